// Static key pairs of test ends, for those that need no secret: a key pair is incomplete here.
#pragma once

#include "core/base/random_source.h"
#include "core/crypto/public_key.h"

#include <memory>

namespace skyseal::crypto {
struct X25519KeyPair;
}

namespace skyseal::test {

std::shared_ptr<const crypto::X25519KeyPair> newIdentity(RandomSource &random);
/// The same for the same seed.
std::shared_ptr<const crypto::X25519KeyPair> newIdentity(std::uint64_t seed);
const crypto::PublicKey &publicKeyOf(const crypto::X25519KeyPair &identity);

} // namespace skyseal::test
