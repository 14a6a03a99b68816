// The time between two epochs: the peer's move to the current epoch, and the records of the previous one that may still
// arrive (PROTOCOL.md, section 8).
#pragma once

#include "core/base/clock.h"
#include "core/channel/round_trip.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace skyseal::channel {

class EpochHandover
{
public:
    /// Records sealed here under the previous epoch; final, since nothing is sealed under it any more.
    std::uint32_t sentBefore() const { return m_sentBefore; }
    bool peerMoved() const { return m_peerMoved.has_value(); }

    /// An epoch became the current one, after `sentBefore` records under the one before.
    void epochBegan(std::uint32_t sentBefore)
    {
        m_sentBefore = sentBefore;
        m_peerMoved.reset();
        m_countKnown = false;
    }
    /// An authentic record of the peer arrived under the current epoch.
    void peerSends(TimePoint now)
    {
        if (!m_peerMoved)
            m_peerMoved = now;
    }
    /// The peer reported how many records it sealed under the previous epoch.
    void countReported() { m_countKnown = true; }

    /// Returns true if nothing more is expected under the previous epoch. `missing`: its records that have not arrived.
    bool complete(TimePoint now, std::uint64_t missing, const RoundTrip &roundTrip) const
    {
        if (m_countKnown && missing == 0)
            return true;
        return m_peerMoved && roundTrip.settled() && now >= *m_peerMoved + roundTrip.generous();
    }
    /// Time at which the read keys of the previous epoch are wiped; kNever until the peer has moved.
    TimePoint retireAt(Duration linger, const RoundTrip &roundTrip) const
    {
        return m_peerMoved ? *m_peerMoved + std::max(linger, roundTrip.generous()) : kNever;
    }

private:
    std::uint32_t m_sentBefore = 0;
    std::optional<TimePoint> m_peerMoved; ///< first record under the current epoch
    bool m_countKnown = false;
};

} // namespace skyseal::channel
