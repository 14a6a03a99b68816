// The schedule of a load that does not depend on the answers of the other end (open loop): the n-th send is due n / rate after
// the start, whatever became of those before it. A generator that waits for a slow receiver, or makes up for a pause later,
// would offer less exactly while there is something to measure ("coordinated omission"). Sans-I/O.
#pragma once

#include "core/base/clock.h"

#include <cstddef>
#include <cstdint>

namespace skyseal::sim {

class Pacer
{
public:
    /// A send that is as late as this is missed.
    static constexpr Duration kPatience = std::chrono::milliseconds(20);

    /// The first send is due at `start`. `perSecond`: 1 to 1,000,000.
    Pacer(std::uint32_t perSecond, TimePoint start) : m_perSecond(perSecond), m_start(start) {}

    /// Number of sends to make now. Those that are as late as kPatience count as missed and are never made.
    std::uint64_t take(TimePoint now);
    /// Of those that were taken, so many could not be made.
    void fail(std::uint64_t sends);
    TimePoint nextDue() const;

    /// Sends whose time has come so far: made or missed.
    std::uint64_t due() const { return m_due; }
    std::uint64_t missed() const { return m_missed; }

private:
    std::uint64_t dueAt(TimePoint now) const;

    std::uint32_t m_perSecond;
    TimePoint m_start;
    std::uint64_t m_due = 0, m_missed = 0;
};

} // namespace skyseal::sim
