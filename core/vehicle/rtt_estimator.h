// The time from a request to its answer, and the retransmission timeout that follows from it (RFC 6298, section 2). Measure
// only answers to requests that were sent once (Karn's algorithm). No clock.
#pragma once

#include "core/base/clock.h"

#include <algorithm>

namespace skyseal::vehicle {

class RttEstimator
{
public:
    static constexpr Duration kFirstTimeout = std::chrono::milliseconds(500), kLeastTimeout = std::chrono::milliseconds(20),
                              kMostTimeout = std::chrono::seconds(3);
    /// Servers may need longer than the answer that was measured.
    static constexpr Duration kLeastSupposed = std::chrono::milliseconds(100);

    void measure(Duration roundTrip)
    {
        if (m_smoothed == Duration::zero()) {
            m_smoothed = roundTrip;
            m_variation = roundTrip / 2;
        } else {
            const Duration difference = roundTrip > m_smoothed ? roundTrip - m_smoothed : m_smoothed - roundTrip;
            m_variation = (m_variation * 3 + difference) / 4;
            m_smoothed = (m_smoothed * 7 + roundTrip) / 8;
        }
        m_shortest = std::min(m_shortest, roundTrip);
        m_timeout = std::clamp(m_smoothed + std::max(m_variation * 4, m_smoothed / 4), kLeastTimeout, kMostTimeout);
    }

    /// A round trip that others have measured on this link, until one is measured here: the timeout that would follow from it.
    void suppose(Duration roundTrip)
    {
        if (m_smoothed == Duration::zero())
            m_timeout = std::clamp(roundTrip * 3, kLeastSupposed, kMostTimeout);
    }

    /// Without an answer for so long, a request counts as lost.
    Duration timeout() const { return m_timeout; }
    /// The shortest one measured; zero before. A message that arrives sooner than this after a request does not answer it.
    Duration shortest() const { return m_smoothed == Duration::zero() ? Duration::zero() : m_shortest; }
    /// True if answers queue up: they arrive later than the first ones did.
    bool isGrowing() const { return m_smoothed > m_shortest * 2; }

private:
    Duration m_timeout = kFirstTimeout;
    Duration m_smoothed{}, m_variation{}, m_shortest = Duration::max() / 4; ///< zero until one was measured
};

} // namespace skyseal::vehicle
