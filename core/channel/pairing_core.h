// State that both roles of a pairing share: outputs, the reason to close the window, jitter of repetitions.
#pragma once

#include "core/channel/datagram_queue.h"
#include "core/channel/pairing.h"
#include "core/channel/pairing_handshake.h"

#include <deque>

namespace skyseal::channel {

struct PairingCore
{
    PairingConfig config;
    RandomSource &random;
    DatagramQueue outgoing = {};
    std::deque<PairingEvent> events = {};
    std::optional<PairingEnd> failure = std::nullopt; ///< why the window has to close
    TimePoint hintFrom = TimePoint::min();
    TimePoint otherFrom = TimePoint::min();

    /// Adds up to a quarter of jitter, so that ends that began together do not stay in step.
    Duration jittered(Duration pause)
    {
        std::uint8_t dice = 0;
        random.fill({&dice, 1});
        return pause * (384 + dice) / 512;
    }
    void hintAtPassphrase(TimePoint now)
    {
        if (now < hintFrom)
            return;
        events.push_back(PairingPassphraseDiffers{});
        hintFrom = now + std::chrono::seconds(1);
    }
    void reportOther(TimePoint now)
    {
        if (now < otherFrom)
            return;
        events.push_back(PairingOtherTried{});
        otherFrom = now + std::chrono::seconds(1);
    }
};

} // namespace skyseal::channel
