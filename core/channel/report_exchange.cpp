#include "core/channel/report_exchange.h"

#include <algorithm>

namespace skyseal::channel {

std::uint32_t ReportExchange::stamp(TimePoint now) const
{
    return static_cast<std::uint32_t>(fullStamp(now));
}

std::uint64_t ReportExchange::fullStamp(TimePoint now) const
{
    // Bit 0 is set because 0 means "none" in an echo; an error of one microsecond does not matter.
    return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(now - m_start).count()) | 1u;
}

void ReportExchange::addTo(SessionStats &stats) const
{
    stats.roundTrip = m_roundTrip.smoothed();
    if (!m_peer)
        return;
    stats.peerReported = true;
    stats.peerRx = m_peer->rx;
    stats.peerTx = m_peer->tx;
    stats.peerFrames = m_peer->frames;
    stats.peerCosts = m_peer->costs;
    stats.peerFreshness = m_peer->freshness;
    stats.peerCannotStore = m_peer->cannotStore;
    stats.peerRx.stale = staleAtPeer();
    stats.peerStamp = m_peer->stamp;
}

bool ReportExchange::handle(TimePoint now, const Report &report)
{
    const bool isOld = m_peer && static_cast<std::int32_t>(report.stamp - m_peer->stamp) <= 0;
    if (isOld)
        return false;
    m_peer = report;
    m_peerAt = now;
    if (report.echo != 0) {
        // In full, counted on from the echo before: modulo 2^32, an echo that was withheld for 72 minutes would look new.
        m_echo += static_cast<std::uint32_t>(report.echo - static_cast<std::uint32_t>(m_echo));
        const std::chrono::microseconds roundTrip(static_cast<std::int64_t>(fullStamp(now) - m_echo - report.held));
        m_roundTrip.add(roundTrip);
        if (roundTrip.count() >= 0)
            m_peerClock.add(now, now - roundTrip - std::chrono::microseconds(report.held / PeerClock::kDrift), report.stamp);
    }
    return true;
}

void ReportExchange::notifyChanges(SessionId session, std::deque<Event> &events)
{
    const std::uint64_t stale = staleAtPeer();
    if (stale > m_staleNotified)
        events.push_back(CommandsLate{session, stale - m_staleNotified, *m_peer->freshness});
    m_staleNotified = stale;
    if (peerCannotStore() != m_storageNotified)
        events.push_back(PeerStorageChanged{session, peerCannotStore()});
    m_storageNotified = peerCannotStore();
}

Report ReportExchange::make(TimePoint now) const
{
    Report report;
    report.stamp = stamp(now);
    report.frames = m_frames;
    if (m_peer) {
        report.echo = m_peer->stamp;
        const auto held = std::chrono::duration_cast<std::chrono::microseconds>(now - m_peerAt);
        report.held = static_cast<std::uint32_t>(std::min<std::int64_t>(held.count(), UINT32_MAX));
    }
    return report;
}

} // namespace skyseal::channel
