// Files that hold one secret: a device's private key, or a key that two devices share. Text, three lines:
//
//   skyseal-private-key-v1                 or: skyseal-preshared-key-v1
//   # a comment
//   48 characters, see checked_base64.h
//
// A private key may be sealed with a passphrase instead: sealed_key.h.
#pragma once

#include "core/base/random_source.h"
#include "core/base/result.h"
#include "core/crypto/passphrase_box.h"
#include "core/crypto/public_key.h"

#include <functional>
#include <string>

namespace skyseal::crypto {
class Passphrase;
struct X25519KeyPair;
} // namespace skyseal::crypto

namespace skyseal::keys {

/// Callback for the passphrase of a sealed file. `attempt` counts from 0 and increases after each wrong passphrase. An error
/// cancels reading.
using AskPassphrase = std::function<Result<crypto::Passphrase, InputError>(const std::string &file, int attempt)>;

/// How to seal a private key; not sealed if there is no passphrase.
struct Sealing
{
    const crypto::Passphrase *passphrase = nullptr;
    crypto::PassphraseCost cost = {};
};

/// Reads a device's identity. Fails if other users can read it, if it is a symbolic link, truncated, damaged or another kind
/// of file, or if it is sealed and `ask` is empty.
Result<crypto::X25519KeyPair, InputError> loadIdentity(const std::string &path, const AskPassphrase &ask = {});

/// The properties of an identity that are readable without its passphrase.
struct IdentityFacts
{
    crypto::PublicKey publicKey{};
    bool sealed = false;
};
Result<IdentityFacts, InputError> readIdentityFacts(const std::string &path);

/// Generates an identity, writes it to a new file for the owner only (0600) and returns its public key: the secret is in the
/// file alone. Fails if the file exists.
Result<crypto::PublicKey, InputError> writeNewIdentity(const std::string &path, RandomSource &random,
                                                       const Sealing &sealing = {});
/// Writes an existing identity to a new file.
Result<void, InputError> writeIdentity(const std::string &path, const crypto::X25519KeyPair &pair, RandomSource &random,
                                       const Sealing &sealing);
/// Replaces the file of an identity, to change or remove the passphrase.
Result<void, InputError> rewriteIdentity(const std::string &path, const crypto::X25519KeyPair &pair, RandomSource &random,
                                         const Sealing &sealing);

/// Parses the text of a private key file, plain or sealed. Fails as loadIdentity() does, apart from its checks of the file.
Result<crypto::X25519KeyPair, InputError> parseIdentity(std::string_view text, const std::string &source,
                                                        const AskPassphrase &ask);

/// The same functions for a pre-shared key, which is never sealed.
Result<Key32, InputError> loadPresharedKey(const std::string &path);
Result<Key32, InputError> writeNewPresharedKey(const std::string &path, RandomSource &random);
/// Writes an existing pre-shared key, replacing an older file.
Result<void, InputError> writePresharedKey(const std::string &path, const Key32 &secret);

/// The two kinds of files, named in their first line.
enum class SecretKind { PrivateKey, PresharedKey };

/// Parses the text of a secret file; `source` names it in errors. Safe for any bytes.
Result<Key32, InputError> parseSecretFile(SecretKind kind, std::string_view text, const std::string &source);

} // namespace skyseal::keys
