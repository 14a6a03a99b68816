#include "core/metrics/work_clock.h"

#include "core/metrics/process_usage.h"

namespace skyseal::metrics {

void WorkClock::look()
{
    m_cpu = threadCpuTime();
    m_cycles = CycleClock::now();
}

std::uint64_t WorkClock::begin()
{
    if (m_clock.between(m_cycles, CycleClock::now()) > kFresh)
        look();
    return CycleClock::now();
}

std::uint64_t WorkClock::between(std::uint64_t begin, std::uint64_t end)
{
    const std::uint64_t passed = m_clock.between(begin, end);
    if (passed < kSuspicious)
        return passed;
    const auto worked = static_cast<std::uint64_t>((threadCpuTime() - m_cpu).count());
    const std::uint64_t since = m_clock.between(m_cycles, CycleClock::now());
    const std::uint64_t taken = since > worked ? since - worked : 0;
    look();
    return passed > taken ? passed - taken : 0;
}

} // namespace skyseal::metrics
