// Times short pieces of one thread's work as CPU time, for little more than two readings of the processor's counter. That
// counter also runs while the kernel gives the core to somebody else. No record takes as long as the shortest such pause, so
// only where a piece took suspiciously long the thread's own clock, a system call, is asked how much of it was work.
#pragma once

#include "core/metrics/cycle_clock.h"

namespace skyseal::metrics {

class WorkClock
{
public:
    /// Longer than any record takes, shorter than a pause by the scheduler.
    static constexpr std::uint64_t kSuspicious = 50'000; // ns

    /// The thread was asleep until now: what passes from here on and is not its CPU time was taken from it.
    void wake();
    /// Nanoseconds that the thread worked between two readings of CycleClock::now(), the second just taken, both since it
    /// woke up.
    std::uint64_t between(std::uint64_t begin, std::uint64_t end);

private:
    CycleClock m_clock = CycleClock::measure();
    std::uint64_t m_cycles = CycleClock::now();
    Duration m_cpu{};
};

} // namespace skyseal::metrics
