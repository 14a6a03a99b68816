// Cycle counter of the processor, to time one seal or open (a few hundred ns) at low cost: a reading takes 5 to 10 ns, while
// clock_gettime takes 20 to 40 ns.
#pragma once

#include "core/base/clock.h"

#include <cstdint>

namespace skyseal::metrics {

/// Reads a counter with a constant rate on every core (invariant TSC on x86, CNTVCT_EL0 on ARM); on other processors the
/// monotonic clock.
class CycleClock
{
public:
    /// Calibrates the counter against the monotonic clock. Blocks for `duration`; call once, when the program starts.
    static CycleClock measure(Duration duration = std::chrono::milliseconds(5));

    static std::uint64_t now()
    {
#if defined(__x86_64__)
        return __builtin_ia32_rdtsc(); // not __rdtsc(), whose header takes half a second to compile
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
    /// Nanoseconds between two readings of now(); 0 if `end` is before `begin`.
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
