#include "core/channel/pairing_passphrase.h"

namespace skyseal::channel {

// One salt for all: the two ends share no value yet that a man in the middle could not choose.
static constexpr crypto::PassphraseSalt kSalt{'s', 'k', 'y', 's', 'e', 'a', 'l', ' ', 'p', 'a', 'i', 'r', 'i', 'n', 'g', '1'};

std::shared_ptr<const Key32> pairingPassphraseKey(const crypto::Passphrase &passphrase)
{
    auto key = crypto::keyFromPassphrase(passphrase, kPairingPassphraseCost, kSalt);
    return key ? std::make_shared<const Key32>(std::move(*key)) : nullptr;
}

} // namespace skyseal::channel
