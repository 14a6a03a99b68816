// CPU time of short pieces of work of one thread, at little more than the cost of two readings of the cycle counter. That
// counter also runs while the thread is preempted. A preemption takes longer than any record, so the thread's CPU clock (a
// system call) is read only around pieces that take suspiciously long. The first of them comes unforeseen and counts like the
// piece before it.
#pragma once

#include "core/metrics/cycle_clock.h"

namespace skyseal::metrics {

class WorkClock
{
public:
    /// Longer than the work on any record, shorter than a preemption.
    static constexpr std::uint64_t kSuspicious = 50'000; // ns
    /// Largest age of the last reading of the thread's CPU clock when such a piece begins. Time in which the thread slept
    /// or was preempted since that reading cannot be separated from the piece, so this bounds the error.
    static constexpr std::uint64_t kFresh = 200'000; // ns

    /// Begins a piece; returns a reading of CycleClock::now().
    std::uint64_t begin();
    /// CPU time in ns between the result of begin() and `end`, a reading of CycleClock::now() taken just before the call.
    std::uint64_t between(std::uint64_t begin, std::uint64_t end);

private:
    void look();

    CycleClock m_clock = CycleClock::measure();
    bool m_watching = true;     ///< the last piece took suspiciously long: so may the next
    std::uint64_t m_usual = 0;  ///< ns of the last piece that did not
    std::uint64_t m_cycles = 0; ///< at the last reading of the thread's clock
    Duration m_cpu{};
};

} // namespace skyseal::metrics
