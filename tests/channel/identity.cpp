#include "identity.h"

#include "core/crypto/x25519.h"
#include "tests/crypto/seeded_random.h"

namespace skyseal::test {

std::shared_ptr<const crypto::X25519KeyPair> newIdentity(RandomSource &random)
{
    return std::make_shared<const crypto::X25519KeyPair>(crypto::X25519KeyPair::generate(random));
}

std::shared_ptr<const crypto::X25519KeyPair> newIdentity(std::uint64_t seed)
{
    SeededRandom random(seed);
    return newIdentity(random);
}

const crypto::PublicKey &publicKeyOf(const crypto::X25519KeyPair &identity)
{
    return identity.publicKey;
}

} // namespace skyseal::test
