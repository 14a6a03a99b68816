// Files that hold one secret: a device's private key, or a key that two devices share. Text, three lines:
//
//   skyseal-private-key-v1                 or: skyseal-preshared-key-v1
//   # a remark
//   48 characters, see checked_base64.h
#pragma once

#include "core/base/random_source.h"
#include "core/base/result.h"
#include "core/crypto/x25519.h"

#include <string>

namespace skyseal::keys {

/// Reads a device's identity. Refused with a reason when others can read it, when it is a symbolic link, truncated,
/// damaged, or not such a file.
Result<crypto::X25519KeyPair, InputError> loadIdentity(const std::string &path);

/// Makes a new identity and writes it to a file that must not exist yet, for the owner alone (0600).
Result<crypto::X25519KeyPair, InputError> writeNewIdentity(const std::string &path, RandomSource &random);

/// The same for a pre-shared key.
Result<Key32, InputError> loadPresharedKey(const std::string &path);
Result<Key32, InputError> writeNewPresharedKey(const std::string &path, RandomSource &random);

/// The two kinds as they stand in the first line.
enum class SecretKind { PrivateKey, PresharedKey };

/// The secret in a file's text; `source` names it in errors. Safe for any bytes.
Result<Key32, InputError> parseSecretFile(SecretKind kind, std::string_view text, const std::string &source);

} // namespace skyseal::keys
