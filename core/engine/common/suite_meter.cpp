#include "core/engine/common/suite_meter.h"

namespace skyseal::engine {

void SuiteMeter::follow(crypto::SuiteId suite)
{
    // Percentiles over a mixture of two suites would describe neither of them.
    if (suite == m_suite)
        return;
    m_suite = suite;
    m_open.reset();
    m_openNext.reset();
    m_seal.reset();
}

void SuiteMeter::opened(crypto::SuiteId suite, std::uint64_t nanoseconds, std::size_t bytes, bool afterSleep)
{
    follow(suite);
    m_open.record(nanoseconds);
    if (!afterSleep)
        m_openNext.record(nanoseconds);
    m_nanoseconds += nanoseconds;
    ++m_records;
    m_bytes += bytes;
    ++m_sums.opened;
    m_sums.openNanoseconds += nanoseconds;
}

void SuiteMeter::sealed(crypto::SuiteId suite, std::uint64_t nanoseconds)
{
    // At a switch the two directions change at different times; the suite of the opened records is decisive.
    if (m_open.count() == 0)
        follow(suite);
    if (suite == m_suite)
        m_seal.record(nanoseconds);
    m_nanoseconds += nanoseconds;
    ++m_sums.sealed;
    m_sums.sealNanoseconds += nanoseconds;
}

void SuiteMeter::roll(TimePoint now)
{
    if (!m_started) {
        m_started = true;
        m_since = now;
        return;
    }
    const double period = seconds(now - m_since);
    if (period <= 0)
        return;
    m_since = now;
    SuiteCost cost;
    cost.openNsP50 = static_cast<double>(m_open.percentile(0.5));
    cost.openNsP99 = static_cast<double>(m_open.percentile(0.99));
    cost.openNextNsP50 = static_cast<double>(m_openNext.percentile(0.5));
    cost.openNextNsP99 = static_cast<double>(m_openNext.percentile(0.99));
    cost.sealNsP50 = static_cast<double>(m_seal.percentile(0.5));
    cost.sealNsP99 = static_cast<double>(m_seal.percentile(0.99));
    cost.openedRecordsPerSecond = static_cast<double>(m_records) / period;
    cost.openedFramesPerSecond = static_cast<double>(m_frames) / period;
    cost.openedBytesPerSecond = static_cast<double>(m_bytes) / period;
    cost.cpuPercent = static_cast<double>(m_nanoseconds) / 1e9 / period * 100;
    m_cost = cost;
    m_open.reset();
    m_openNext.reset();
    m_seal.reset();
    m_nanoseconds = m_records = m_frames = m_bytes = 0;
}

} // namespace skyseal::engine
