// Reads the key of MAVLink signing from a file.
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/secret_bytes_fwd.h"

#include <string>

namespace skyseal::mavlink {

/// The key in the content of such a file; `source` names the file in errors, which never quote the content. The caller wipes
/// the content.
Result<Key32, InputError> parseSigningKey(ByteView content, const std::string &source);
/// Reads a key from a file of 32 bytes, or of 64 hex digits with nothing but white space around them.
Result<Key32, InputError> readSigningKey(const std::string &path);

} // namespace skyseal::mavlink
