// The text form of a public key, and its fingerprint for comparison by the users.
#pragma once

#include "core/base/result.h"
#include "core/crypto/public_key.h"

#include <string>
#include <string_view>

namespace skyseal::keys {

using crypto::PublicKey;

/// "skyseal:" and 48 characters of URL-safe base64: the 32 bytes of the key and the first 4 bytes of
/// BLAKE2b-256("skyseal public key v1" | key) as a check that detects typing errors.
std::string publicKeyText(const PublicKey &key);

/// Parses such a text, with white space around it allowed. The error states the reason.
Result<PublicKey, InputError> publicKeyFromText(std::string_view text);

/// All 256 bits of BLAKE2b-256("skyseal fingerprint v1" | key) as 16 groups of four hex digits. Never shortened: a key with
/// a matching prefix can be found by search.
std::string fingerprint(const PublicKey &key);

} // namespace skyseal::keys
