#include "core/metrics/cycle_clock.h"

namespace skyseal::metrics {

std::uint64_t CycleClock::monotonicNanoseconds()
{
    return static_cast<std::uint64_t>(
        std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch()).count());
}

CycleClock CycleClock::measure(Duration duration)
{
    const std::uint64_t wanted = static_cast<std::uint64_t>(duration.count());
    const std::uint64_t time = monotonicNanoseconds();
    const std::uint64_t cycles = now();
    std::uint64_t passed = 0;
    while (passed < wanted)
        passed = monotonicNanoseconds() - time;
    const std::uint64_t counted = now() - cycles;
    return CycleClock(counted ? static_cast<double>(passed) / static_cast<double>(counted) : 1.0);
}

} // namespace skyseal::metrics
