// The smoothed round trip of one session (RFC 6298's filter), from the stamps that reports carry.
#pragma once

#include "core/base/clock.h"

#include <algorithm>

namespace skyseal::channel {

class RoundTrip
{
public:
    void add(Duration sample)
    {
        if (sample < Duration::zero())
            return;
        ++m_samples;
        m_longest = std::max(sample, m_longest - m_longest / 32);
        if (!known()) {
            m_smoothed = std::max(sample, Duration(1));
            m_variation = sample / 2;
            return;
        }
        const Duration error = sample > m_smoothed ? sample - m_smoothed : m_smoothed - sample;
        m_variation += (error - m_variation) / 4;
        m_smoothed += (sample - m_smoothed) / 8;
    }

    bool known() const { return m_smoothed > Duration::zero(); }
    Duration smoothed() const { return m_smoothed; }
    /// Enough samples to rely on `generous`.
    bool settled() const { return m_samples >= kEnough; }
    /// Longer than any round trip that this link is known to take: three times the mean, the mean and four deviations, or
    /// the longest of late, whichever is longest.
    Duration generous() const { return std::max({3 * m_smoothed, m_smoothed + 4 * m_variation, m_longest}); }

private:
    static constexpr unsigned kEnough = 3;

    Duration m_smoothed{};
    Duration m_variation{};
    Duration m_longest{};
    unsigned m_samples = 0;
};

} // namespace skyseal::channel
