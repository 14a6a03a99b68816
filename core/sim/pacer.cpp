#include "core/sim/pacer.h"

#include <algorithm>

namespace skyseal::sim {

namespace {

constexpr std::uint64_t kNanoseconds = 1'000'000'000;

} // namespace

/// Sends that are due up to and including this moment. In whole numbers, so that nothing drifts; the seconds apart, so that the
/// product fits.
std::uint64_t Pacer::dueAt(TimePoint now) const
{
    if (now < m_start)
        return 0;
    const auto time = static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(now - m_start).count());
    return time / kNanoseconds * m_perSecond + time % kNanoseconds * m_perSecond / kNanoseconds + 1;
}

std::uint64_t Pacer::take(TimePoint now)
{
    const std::uint64_t due = std::max(dueAt(now), m_due), late = std::max(dueAt(now - kPatience), m_due);
    const std::uint64_t missed = late - m_due;
    m_missed += missed;
    const std::uint64_t out = due - m_due - missed;
    m_due = due;
    return out;
}

void Pacer::fail(std::uint64_t sends)
{
    m_missed += sends;
}

TimePoint Pacer::nextDue() const
{
    const std::uint64_t rest = m_due % m_perSecond * kNanoseconds;
    return m_start + std::chrono::seconds(m_due / m_perSecond)
        + std::chrono::nanoseconds((rest + m_perSecond - 1) / m_perSecond);
}

} // namespace skyseal::sim
