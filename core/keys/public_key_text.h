// A public key as people pass it on, and the fingerprint that they compare.
#pragma once

#include "core/base/result.h"
#include "core/crypto/x25519.h"

#include <string>
#include <string_view>

namespace skyseal::keys {

using crypto::PublicKey;

/// "skyseal:" and 48 characters of URL-safe base64: the 32 bytes of the key and 4 bytes of check, the front of
/// BLAKE2b-256("skyseal public key v1" | key), so that a slip of the pen is told from another key.
std::string publicKeyText(const PublicKey &key);

/// The key of such a text, which white space may surround. The error says what is wrong with it.
Result<PublicKey, InputError> publicKeyFromText(std::string_view text);

/// All 256 bits of BLAKE2b-256("skyseal fingerprint v1" | key) as 16 groups of four hex digits. Never shortened: a
/// prefix that agrees can be searched for.
std::string fingerprint(const PublicKey &key);

} // namespace skyseal::keys
