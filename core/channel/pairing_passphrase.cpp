#include "core/channel/pairing_passphrase.h"

namespace skyseal::channel {

// One for all: the two ends have nothing in common yet that somebody in between could not choose for them.
static constexpr crypto::PassphraseSalt kSalt{'s', 'k', 'y', 's', 'e', 'a', 'l', ' ', 'p', 'a', 'i', 'r', 'i', 'n', 'g', '1'};

std::shared_ptr<const Key32> pairingPassphraseKey(const crypto::Passphrase &passphrase)
{
    auto key = crypto::keyFromPassphrase(passphrase, kPairingPassphraseCost, kSalt);
    return key ? std::make_shared<const Key32>(std::move(*key)) : nullptr;
}

} // namespace skyseal::channel
