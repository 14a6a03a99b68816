// Judges the delay of the records of a session that contain frames (PROTOCOL.md, section 6.1).
#pragma once

#include "core/channel/arrival_history.h"
#include "core/channel/freshness.h"
#include "core/channel/peer_clock.h"

#include <array>
#include <optional>

namespace skyseal::channel {

class FreshnessJudge
{
public:
    /// `limitsAge`: the peer is a station, whose records say when they were sealed.
    FreshnessJudge(const FreshnessLimits &limits, bool limitsAge)
        : m_limits(limits), m_limitsAge(limitsAge), m_arrivals(limits.overtaken)
    {}

    /// Each authentic record, in the order of arrival.
    void addRecord(TimePoint now, RecordPosition position) { m_arrivals.add(now, position); }
    /// A report of the peer, newer than those before.
    void addReport(RecordPosition position, std::uint32_t peerStamp);
    struct Arrival
    {
        TimePoint now;
        RecordPosition position;
        const std::optional<std::uint32_t> &peerStamp; ///< when the frames were sealed; none if they were sealed in place
        bool afterClose = false;
    };
    /// Judges frames. Without a stamp they count as old as the report before them.
    Freshness judge(const Arrival &arrival, const PeerClock &peerClock)
    {
        if (m_arrivals.overtaken(arrival.now, arrival.position))
            return Freshness::Overtaken;
        return m_limitsAge ? judgeAge(arrival, peerClock) : Freshness::Fresh;
    }
    /// `stale`: records with frames that were not fresh.
    FreshnessReport report(std::uint64_t stale) const;

private:
    Freshness judgeAge(const Arrival &arrival, const PeerClock &peerClock);
    std::optional<std::uint32_t> stampBefore(RecordPosition position) const;

    struct ReportStamp
    {
        RecordPosition position{};
        std::uint32_t stamp = 0;
    };

    FreshnessLimits m_limits;
    bool m_limitsAge;
    ArrivalHistory m_arrivals;
    /// The peer's latest two reports, newest first, since frames may arrive after a report that was sent after them. Its clock
    /// began at 0 with the session.
    std::array<ReportStamp, 2> m_reports{};
    std::optional<Duration> m_age = Duration::zero(); ///< greatest possible age of the newest frames; nullopt: unknown
};

} // namespace skyseal::channel
