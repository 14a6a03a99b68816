// Converts monotonic counters into recent rates: the share lost over the last second, the growth over the last minute.
// Fed with the counters at a steady pace; no clock.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace skyseal::engine {

/// The growth of a counter over the last `slots` readings, counted from the first one.
template<std::size_t slots> class Growth
{
public:
    void note(std::uint64_t total)
    {
        if (m_count == 0)
            m_readings.fill(total);
        m_readings[m_count++ % (slots + 1)] = total;
    }

    /// Signed, since a late record reduces the count of lost ones.
    std::int64_t value() const
    {
        if (m_count == 0)
            return 0;
        const std::uint64_t newest = m_readings[(m_count - 1) % (slots + 1)];
        const std::uint64_t oldest = m_readings[m_count % (slots + 1)];
        return static_cast<std::int64_t>(newest) - static_cast<std::int64_t>(oldest);
    }

private:
    std::array<std::uint64_t, slots + 1> m_readings{};
    std::size_t m_count = 0;
};

/// What was lost of all that was sent, in one or several sessions.
struct LossShare
{
    double lost = 0, received = 0;

    double percent() const { return lost + received > 0 ? 100 * lost / (lost + received) : 0; }
    LossShare &operator+=(const LossShare &more)
    {
        lost += more.lost;
        received += more.received;
        return *this;
    }
};

/// The loss over the last four readings: a second, at four a second.
class LossMeter
{
public:
    void note(std::uint64_t received, std::uint64_t lost)
    {
        m_received.note(received);
        m_lost.note(lost);
    }

    LossShare share() const
    {
        return {static_cast<double>(std::max<std::int64_t>(0, m_lost.value())),
                static_cast<double>(std::max<std::int64_t>(0, m_received.value()))};
    }
    double percent() const { return share().percent(); }

private:
    Growth<4> m_received, m_lost;
};

} // namespace skyseal::engine
