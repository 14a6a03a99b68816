// A private key sealed with a passphrase, as text:
//
//   skyseal-sealed-key-v1
//   # a comment
//   argon2id 3 262144 32 hex digits        passes, memory in KiB, salt
//   skyseal:…                              the public key, not encrypted, so that it can be shown without the passphrase
//   64 characters                          URL-safe base64 of the sealed secret, 48 bytes
//
// The order of the lines is fixed; comments (#) and empty lines may stand between them. The header, the argon2id line and the
// public key line, each with its newline, are authenticated: a change of the unencrypted values is detected when the key is
// opened. The opened secret must also match the public key.
#pragma once

#include "core/base/random_source.h"
#include "core/base/result.h"
#include "core/crypto/passphrase_box.h"
#include "core/crypto/public_key.h"

#include <string>
#include <string_view>

namespace skyseal::crypto {
struct X25519KeyPair;
}

namespace skyseal::keys {

inline constexpr std::string_view kSealedKeyHeader = "skyseal-sealed-key-v1";

/// A well-formed file, not opened yet.
struct SealedKey
{
    crypto::PassphraseCost cost;
    crypto::PassphraseSalt salt{};
    crypto::PublicKey publicKey{};
    crypto::SealedSecret sealed{};

    /// `source` names the text in errors. Safe for any bytes. Costs beyond the limits are rejected without computing.
    static Result<SealedKey, InputError> parse(std::string_view text, const std::string &source);
    std::string text() const;

    static Result<SealedKey, crypto::PassphraseError> seal(const crypto::X25519KeyPair &pair,
                                                           const crypto::Passphrase &passphrase,
                                                           const crypto::PassphraseCost &cost, RandomSource &random);
    Result<crypto::X25519KeyPair, crypto::PassphraseError> open(const crypto::Passphrase &passphrase) const;

private:
    /// The associated data.
    std::string clearLines() const;
};

} // namespace skyseal::keys
