// The reports that both ends of a session send each other (PROTOCOL.md, section 7): schedule, session clock, round trip, and
// the peer's latest report.
#pragma once

#include "core/base/clock.h"
#include "core/channel/control.h"
#include "core/channel/events.h"
#include "core/channel/peer_clock.h"
#include "core/channel/round_trip.h"

#include <deque>
#include <optional>

namespace skyseal::channel {

class ReportExchange
{
public:
    /// The session clock starts at `now`. `due`: time of the first report, kNever to wait for schedule().
    ReportExchange(TimePoint now, TimePoint due) : m_start(now), m_due(due), m_peerAt(now), m_peerClock(now) {}

    // query
    TimePoint due() const { return m_due; }
    TimePoint start() const { return m_start; }
    const RoundTrip &roundTrip() const { return m_roundTrip; }
    /// When this end sent what the peer echoed last; the beginning of the session before the first echo. A report that somebody
    /// withheld proves nothing later than that.
    TimePoint provenAt() const { return m_start + std::chrono::microseconds(static_cast<std::int64_t>(m_echo)); }
    bool peerAsksCosts() const { return m_peer && m_peer->asksCosts; }
    /// Session clock in microseconds, modulo 2^32; never 0.
    std::uint32_t stamp(TimePoint now) const;
    /// The same, not modulo 2^32.
    std::uint64_t fullStamp(TimePoint now) const;
    /// The session clock that the peer echoed last, not modulo 2^32; 0 before the first echo.
    std::uint64_t echo() const { return m_echo; }
    /// Bounds the age of messages from the peer; before the first round trip by the fact that an agent's session clock begins
    /// before its station's.
    const PeerClock &peerClock() const { return m_peerClock; }
    /// By the peer's latest report; 0 for a peer that does not report it.
    std::uint64_t staleAtPeer() const { return m_peer && m_peer->freshness ? m_peer->freshness->stale : 0; }
    /// By the peer's latest report.
    bool peerCannotStore() const { return m_peer && m_peer->cannotStore; }
    /// By the peer's latest report.
    bool peerReceivesNothing() const { return m_peer && m_peer->receivesNothing; }
    /// Fills the values that come from the peer's latest report.
    void addTo(SessionStats &stats) const;

    // input
    /// Takes a report of the peer. Returns false, and changes nothing, unless it is newer than the latest one.
    bool handle(TimePoint now, const Report &report);
    /// Adds events for the changes in the latest report: commands that arrived too late, and the storage of the peer.
    void notifyChanges(SessionId session, std::deque<Event> &events);
    /// The owner's frame counters, for the following reports.
    void noteFrames(const FrameCounters &frames) { m_frames = frames; }

    // command
    void schedule(TimePoint due) { m_due = due; }
    /// A report with stamp, echo and frame counters; the other members are the caller's.
    Report make(TimePoint now) const;

private:
    TimePoint m_start;
    TimePoint m_due;
    std::optional<FrameCounters> m_frames;
    std::optional<Report> m_peer;
    TimePoint m_peerAt;       ///< arrival of m_peer
    std::uint64_t m_echo = 0; ///< of the peer's latest report, not modulo 2^32
    std::uint64_t m_staleNotified = 0;
    bool m_storageNotified = false; ///< the owner was notified that the peer cannot store
    RoundTrip m_roundTrip;
    PeerClock m_peerClock;
};

} // namespace skyseal::channel
