#include "core/crypto/x25519.h"

#include <sodium.h>

namespace skyseal::crypto {

namespace {

/// Stack below the call in which the library's arithmetic may leave parts of a secret.
constexpr std::size_t kLibraryStack = 4096;

} // namespace

X25519KeyPair X25519KeyPair::fromSecret(Key32 &&secret)
{
    X25519KeyPair pair{std::move(secret), {}};
    crypto_scalarmult_base(pair.publicKey.data(), pair.secret.view().data());
    sodium_stackzero(kLibraryStack);
    return pair;
}

X25519KeyPair X25519KeyPair::generate(RandomSource &random)
{
    Key32 secret;
    random.fill(secret.mutableView());
    return fromSecret(std::move(secret));
}

std::optional<Key32> x25519(const Key32 &secret, const PublicKey &publicKey)
{
    Key32 shared;
    const int failed = crypto_scalarmult(shared.mutableView().data(), secret.view().data(), publicKey.data());
    sodium_stackzero(kLibraryStack);
    if (failed != 0 || shared.isZero())
        return std::nullopt;
    return shared;
}

} // namespace skyseal::crypto
