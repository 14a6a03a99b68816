// The reports that both ends of a session send each other (PROTOCOL.md, section 7): schedule, session clock, round trip, and
// the peer's latest report.
#pragma once

#include "core/base/clock.h"
#include "core/channel/control.h"
#include "core/channel/round_trip.h"

#include <optional>

namespace skyseal::channel {

class ReportExchange
{
public:
    /// The session clock starts at `now`. `due`: time of the first report, kNever to wait for schedule().
    ReportExchange(TimePoint now, TimePoint due) : m_start(now), m_due(due), m_peerAt(now) {}

    // query
    TimePoint due() const { return m_due; }
    TimePoint start() const { return m_start; }
    const RoundTrip &roundTrip() const { return m_roundTrip; }
    bool peerAsksCosts() const { return m_peer && m_peer->asksCosts; }
    /// Session clock in microseconds, modulo 2^32; never 0.
    std::uint32_t stamp(TimePoint now) const;
    /// Fills the values that come from the peer's latest report.
    void addTo(SessionStats &stats) const;

    // input
    /// Takes a report of the peer. Returns false, and changes nothing, unless it is newer than the latest one.
    bool handle(TimePoint now, const Report &report);
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
    TimePoint m_peerAt; ///< arrival of m_peer
    RoundTrip m_roundTrip;
};

} // namespace skyseal::channel
