// How long to wait before the next attempt to reach the broker: 1 s, doubled up to a minute, each time less a random part of
// up to a half, so that the gateways of a fleet do not all return at the moment at which their broker is back.
#pragma once

#include "core/base/clock.h"

#include <algorithm>
#include <random>

namespace skyseal::mqtt {

class ReconnectDelay
{
public:
    static constexpr Duration kFirst = std::chrono::seconds(1);
    static constexpr Duration kLongest = std::chrono::seconds(60);

    explicit ReconnectDelay(std::uint32_t seed) : m_random(seed) {}

    /// After each attempt that failed, and after each connection that was lost.
    Duration next()
    {
        const Duration whole = m_next;
        m_next = std::min(2 * m_next, kLongest);
        return whole - whole * std::uniform_int_distribution<int>(0, 500)(m_random) / 1000;
    }
    /// The broker accepted the connection.
    void reset() { m_next = kFirst; }

private:
    std::minstd_rand m_random;
    Duration m_next = kFirst;
};

} // namespace skyseal::mqtt
