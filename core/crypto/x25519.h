// X25519 (RFC 7748) as the handshake uses it.
#pragma once

#include "core/base/random_source.h"
#include "core/base/secret_bytes.h"
#include "core/crypto/public_key.h"

#include <optional>

namespace skyseal::crypto {

/// A private scalar with its public point. Move-only, since the secret is.
struct X25519KeyPair
{
    Key32 secret;
    PublicKey publicKey{};

    /// The pair of a secret; any 32 bytes are valid (they are clamped when used).
    static X25519KeyPair fromSecret(Key32 &&secret);
    static X25519KeyPair generate(RandomSource &random);

    X25519KeyPair clone() const { return {secret.clone(), publicKey}; }
};

/// The shared secret; nullopt if it is all zero, that is, if the public key is a point of small order (RFC 7748 6.1).
std::optional<Key32> x25519(const Key32 &secret, const PublicKey &publicKey);

} // namespace skyseal::crypto
