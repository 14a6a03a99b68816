#include "core/metrics/cycle_clock.h"

namespace skyseal::metrics {

std::uint64_t CycleClock::monotonicNanoseconds()
{
    return static_cast<std::uint64_t>(
        std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch()).count());
}

CycleClock CycleClock::measure(Duration duration)
{
    struct Reading
    {
        std::uint64_t nanoseconds, cycles, uncertainty;
    };
    // A preemption between the readings of the two clocks would falsify the rate, so the closest pair of several counts.
    const auto read = [] {
        Reading best{0, 0, UINT64_MAX};
        for (int i = 0; i < 16; ++i) {
            const std::uint64_t before = now();
            const std::uint64_t time = monotonicNanoseconds();
            const std::uint64_t width = now() - before;
            if (width < best.uncertainty)
                best = {time, before + width / 2, width};
        }
        return best;
    };
    const Reading begin = read();
    while (monotonicNanoseconds() - begin.nanoseconds < static_cast<std::uint64_t>(duration.count())) {}
    const Reading end = read();
    const std::uint64_t passed = end.nanoseconds - begin.nanoseconds, counted = end.cycles - begin.cycles;
    return CycleClock(counted ? static_cast<double>(passed) / static_cast<double>(counted) : 1.0);
}

} // namespace skyseal::metrics
