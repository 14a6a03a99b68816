#include "core/vehicle/log_sweep.h"

#include <algorithm>

namespace skyseal::vehicle {

void LogSweep::begin(TimePoint now, const LogContent &content)
{
    const auto run = content.missingFrom(0);
    m_from = run ? run->first : 0;
    m_until = run ? run->end : 0;
    m_requested = m_began = now;
    m_isMeasuring = true;
    m_first.reset();
    m_due = m_interval == Duration::zero() ? kNever : timeOf(m_until);
}

void LogSweep::arrived(TimePoint now, std::size_t chunk)
{
    if (!m_isMeasuring)
        return;
    if (!m_first) {
        if (chunk >= m_from)
            m_first = Arrival{now, chunk};
        m_latest = now;
        m_bursts = 0;
        return;
    }
    const bool beginsBurst = now - m_latest > kLeastSpacing / 2;
    m_latest = now;
    m_bursts += beginsBurst ? 1 : 0;
    if (chunk < m_first->chunk + kMeasured)
        return;
    const Duration passed = now - m_first->time;
    const bool isInBursts = m_bursts > 0 && passed / m_bursts <= kMostSpacing; // else the gaps were losses
    if (isInBursts && !beginsBurst)
        return;
    m_interval = std::max<Duration>(passed / static_cast<Duration::rep>(chunk - m_first->chunk), std::chrono::microseconds(1));
    m_spacing = isInBursts ? std::max(passed / m_bursts, kLeastSpacing) : kLeastSpacing;
    m_due = timeOf(m_until);
}

/// The chunk that the vehicle sends next when a request that is made now reaches it.
std::size_t LogSweep::place(TimePoint now) const
{
    return m_from + static_cast<std::size_t>((now - m_requested + m_interval - Duration(1)) / m_interval);
}

std::optional<std::size_t> LogSweep::poll(TimePoint now, const LogContent &content, Duration roundTrip)
{
    if (now < m_due)
        return std::nullopt;
    const std::size_t next = place(now);
    auto run = content.missingFrom(next);
    if (run && run->first == next) { // it comes by itself
        m_due = timeOf(run->end);
        return std::nullopt;
    }
    if (!run) {
        m_due = m_began + roundTrip / kInRoundTrip;
        if (now < m_due)
            return std::nullopt;
        m_began = now;
        run = content.missingFrom(0);
        if (!run) {
            m_due = kNever;
            return std::nullopt;
        }
    }
    m_isMeasuring = false;
    m_from = run->first;
    m_until = run->end;
    m_requested = now;
    m_due = std::max(timeOf(m_until), now + std::max(m_spacing, m_interval));
    return m_from;
}

} // namespace skyseal::vehicle
