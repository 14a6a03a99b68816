// The cheapest clock of the processor, for timing one seal or open (a few hundred ns) without paying more for the clock
// than for what it times: clock_gettime costs 20 to 40 ns a call, the counter of the processor 5 to 10.
#pragma once

#include "core/base/clock.h"

#include <cstdint>

#if defined(__x86_64__)
#include <x86intrin.h>
#endif

namespace skyseal::metrics {

/// Reads a counter that runs at a constant rate on every core (invariant TSC, ARM's virtual counter), elsewhere the
/// monotonic clock itself.
class CycleClock
{
public:
    /// Times the counter against the monotonic clock for `duration`; done once, at the start of a program.
    static CycleClock measure(Duration duration = std::chrono::milliseconds(5));

    static std::uint64_t now()
    {
#if defined(__x86_64__)
        return __rdtsc();
#elif defined(__aarch64__)
        std::uint64_t value;
        asm volatile("mrs %0, cntvct_el0" : "=r"(value));
        return value;
#else
        return monotonicNanoseconds();
#endif
    }

    std::uint64_t nanoseconds(std::uint64_t cycles) const
    {
        return static_cast<std::uint64_t>(static_cast<double>(cycles) * m_nanosecondsPerCycle);
    }
    /// Time between two readings of now(); 0 when they are the wrong way round.
    std::uint64_t between(std::uint64_t begin, std::uint64_t end) const
    {
        return end > begin ? nanoseconds(end - begin) : 0;
    }

private:
    explicit CycleClock(double nanosecondsPerCycle) : m_nanosecondsPerCycle(nanosecondsPerCycle) {}
    static std::uint64_t monotonicNanoseconds();

    double m_nanosecondsPerCycle;
};

} // namespace skyseal::metrics
