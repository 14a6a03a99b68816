// The smoothed round trip of a session (filter of RFC 6298), from the stamps of its reports.
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
    /// There are enough samples to rely on generous().
    bool settled() const { return m_samples >= kEnough; }
    /// Upper bound of the round trips of this link: the longest of three times the mean, the mean and four deviations, and the
    /// longest recent sample.
    Duration generous() const { return std::max({3 * m_smoothed, m_smoothed + 4 * m_variation, m_longest}); }

private:
    static constexpr unsigned kEnough = 3;

    Duration m_smoothed{};
    Duration m_variation{};
    Duration m_longest{};
    unsigned m_samples = 0;
};

} // namespace skyseal::channel
