// The signing key as a file holds it.
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/secret_bytes.h"

#include <string>

namespace skyseal::mavlink {

/// The key in the content of such a file; `source` names it in errors, which never quote it. The caller wipes the content.
Result<Key32, InputError> parseSigningKey(ByteView content, const std::string &source);
/// Reads a key from a file of 32 bytes, or of 64 hex digits with nothing but white space around them.
Result<Key32, InputError> readSigningKey(const std::string &path);

} // namespace skyseal::mavlink
