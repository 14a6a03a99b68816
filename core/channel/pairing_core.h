// State that both roles of a pairing share: outputs, refused keys, jitter of repetitions.
#pragma once

#include "core/channel/datagram_queue.h"
#include "core/channel/pairing.h"
#include "core/channel/pairing_handshake.h"

#include <algorithm>
#include <deque>
#include <vector>

namespace skyseal::channel {

struct PairingCore
{
    PairingConfig config;
    RandomSource &random;
    DatagramQueue outgoing;
    std::deque<PairingEvent> events;
    std::vector<PublicKey> turnedDown; ///< in this window; bounded by 15 handshakes a second for two minutes
    TimePoint hintTold = TimePoint::min();

    PairingAbout about() const
    {
        return {config.wantPresharedKey, config.passphraseKey != nullptr, config.roleAsked, config.name};
    }
    bool mayShow(const PublicKey &key) const
    {
        return key != config.identity->publicKey && std::find(turnedDown.begin(), turnedDown.end(), key) == turnedDown.end();
    }
    /// Adds up to a quarter of jitter, so that ends that began together do not stay in step.
    Duration jittered(Duration pause)
    {
        std::uint8_t dice = 0;
        random.fill({&dice, 1});
        return pause * (384 + dice) / 512;
    }
    void hintAtPassphrase(TimePoint now)
    {
        if (now < hintTold)
            return;
        events.push_back(PairingPassphraseDiffers{});
        hintTold = now + std::chrono::seconds(1);
    }
};

} // namespace skyseal::channel
