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
    /// So old the last look at the thread's clock may be when a piece begins. What was taken from the thread since then, be
    /// it asleep or without its core, is not told from what is taken from the piece; this is the most that can be.
    static constexpr std::uint64_t kFresh = 200'000; // ns

    /// A reading of CycleClock::now() for the beginning of a piece.
    std::uint64_t begin();
    /// Nanoseconds that the thread worked from a begin() to a reading of CycleClock::now() that was just taken.
    std::uint64_t between(std::uint64_t begin, std::uint64_t end);

private:
    void look();

    CycleClock m_clock = CycleClock::measure();
    std::uint64_t m_cycles = 0; ///< at the last look
    Duration m_cpu{};
};

} // namespace skyseal::metrics
