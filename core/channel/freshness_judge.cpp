#include "core/channel/freshness_judge.h"

namespace skyseal::channel {

void FreshnessJudge::addReport(RecordPosition position, std::uint32_t peerStamp)
{
    m_reports = {ReportStamp{position, peerStamp}, m_reports[0]};
}

std::optional<std::uint32_t> FreshnessJudge::stampBefore(RecordPosition position) const
{
    for (const ReportStamp &report : m_reports) {
        if (position >= report.position)
            return report.stamp;
    }
    return std::nullopt;
}

Freshness FreshnessJudge::judgeAge(const Arrival &arrival, const PeerClock &peerClock)
{
    if (arrival.afterClose)
        return Freshness::AfterClose;
    const auto peerStamp = arrival.peerStamp ? arrival.peerStamp : stampBefore(arrival.position);
    m_age = peerStamp ? peerClock.age(arrival.now, *peerStamp) : std::nullopt;
    const bool young = !m_limits.age || (m_age && *m_age <= *m_limits.age);
    return young ? Freshness::Fresh : Freshness::TooOld;
}

FreshnessReport FreshnessJudge::report(std::uint64_t stale) const
{
    using Milliseconds = std::chrono::duration<std::uint64_t, std::milli>;
    using Microseconds = std::chrono::duration<std::uint64_t, std::micro>;
    FreshnessReport out;
    out.stale = stale;
    out.ageMicroseconds = m_age ? std::chrono::duration_cast<Microseconds>(*m_age).count() : FreshnessReport::kUnknownAge;
    out.overtakenMilliseconds = std::chrono::duration_cast<Milliseconds>(m_limits.overtaken).count();
    out.limitMilliseconds = std::chrono::duration_cast<Milliseconds>(m_limits.age.value_or(Duration::zero())).count();
    return out;
}

} // namespace skyseal::channel
