#include "core/metrics/work_clock.h"

#include "core/metrics/process_usage.h"

#include <utility>

namespace skyseal::metrics {

void WorkClock::look()
{
    // A preemption between the two readings would count as work, or as time without; the next attempt is hardly hit as well.
    for (int attempt = 0; attempt < 4; ++attempt) {
        m_cycles = CycleClock::now();
        m_cpu = threadCpuTime();
        if (m_clock.between(m_cycles, CycleClock::now()) < kSuspicious)
            return;
    }
}

std::uint64_t WorkClock::begin()
{
    if (m_watching && m_clock.between(m_cycles, CycleClock::now()) > kFresh)
        look();
    return CycleClock::now();
}

std::uint64_t WorkClock::between(std::uint64_t begin, std::uint64_t end)
{
    const std::uint64_t passed = m_clock.between(begin, end);
    if (passed < kSuspicious) {
        m_watching = false;
        m_usual = passed;
        return passed;
    }
    if (!std::exchange(m_watching, true))
        return m_usual;
    const std::uint64_t cyclesBefore = m_cycles;
    const Duration cpuBefore = m_cpu;
    look();
    const auto worked = static_cast<std::uint64_t>((m_cpu - cpuBefore).count());
    const std::uint64_t since = m_clock.between(cyclesBefore, m_cycles);
    const std::uint64_t taken = since > worked ? since - worked : 0;
    return passed > taken ? passed - taken : 0;
}

} // namespace skyseal::metrics
