// Files that hold one secret: a device's private key, or a key that two devices share. Text, three lines:
//
//   skyseal-private-key-v1                 or: skyseal-preshared-key-v1
//   # a remark
//   48 characters, see checked_base64.h
//
// A private key may be sealed with a passphrase instead: sealed_key.h.
#pragma once

#include "core/base/random_source.h"
#include "core/base/result.h"
#include "core/crypto/passphrase_box.h"
#include "core/crypto/x25519.h"

#include <functional>
#include <string>

namespace skyseal::keys {

/// Asked for the passphrase of a sealed file. `attempt` counts from 0; a later one means that the one before did not open it.
/// An error ends the reading.
using AskPassphrase = std::function<Result<crypto::Passphrase, InputError>(const std::string &file, int attempt)>;

/// With what a private key is to be sealed; without a passphrase it is not.
struct Sealing
{
    const crypto::Passphrase *passphrase = nullptr;
    crypto::PassphraseCost cost = {};
};

/// Reads a device's identity. Refused with a reason when others can read it, when it is a symbolic link, truncated,
/// damaged, not such a file, or sealed and `ask` is empty.
Result<crypto::X25519KeyPair, InputError> loadIdentity(const std::string &path, const AskPassphrase &ask = {});

/// What can be known of an identity without its passphrase.
struct IdentityFacts
{
    crypto::PublicKey publicKey{};
    bool sealed = false;
};
Result<IdentityFacts, InputError> readIdentityFacts(const std::string &path);

/// Makes a new identity and writes it to a file that must not exist yet, for the owner alone (0600).
Result<crypto::X25519KeyPair, InputError> writeNewIdentity(const std::string &path, RandomSource &random,
                                                           const Sealing &sealing = {});
/// Writes an identity that there is already to a new file.
Result<void, InputError> writeIdentity(const std::string &path, const crypto::X25519KeyPair &pair, RandomSource &random,
                                       const Sealing &sealing);
/// Replaces the file of an identity: another passphrase, or none.
Result<void, InputError> rewriteIdentity(const std::string &path, const crypto::X25519KeyPair &pair, RandomSource &random,
                                         const Sealing &sealing);

/// A private key file's text from elsewhere, plain or sealed. The same refusals as loadIdentity, but for those of the file.
Result<crypto::X25519KeyPair, InputError> parseIdentity(std::string_view text, const std::string &source,
                                                        const AskPassphrase &ask);

/// The same for a pre-shared key, which is never sealed.
Result<Key32, InputError> loadPresharedKey(const std::string &path);
Result<Key32, InputError> writeNewPresharedKey(const std::string &path, RandomSource &random);
/// One that there is already, replacing an older file of that name.
Result<void, InputError> writePresharedKey(const std::string &path, const Key32 &secret);

/// The two kinds as they stand in the first line.
enum class SecretKind { PrivateKey, PresharedKey };

/// The secret in a file's text; `source` names it in errors. Safe for any bytes.
Result<Key32, InputError> parseSecretFile(SecretKind kind, std::string_view text, const std::string &source);

} // namespace skyseal::keys
