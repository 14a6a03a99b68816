// CPU cost of the secure channel's ciphers in this process: for each session, and, while a measurement is on, for each record.
// The caller reads the clock directly around each call of the endpoint. I/O thread.
#pragma once

#include "core/channel/delivery.h"
#include "core/engine/common/suite_meter.h"
#include "core/metrics/work_clock.h"

#include <map>

namespace skyseal::engine {

class ChannelCosts
{
public:
    /// Begins a record; pass the result, and CycleClock::now() of its end, to opened() or sealed().
    std::uint64_t begin() { return m_clock.begin(); }
    void opened(std::uint64_t begin, std::uint64_t end, const channel::Delivery &delivery);
    void sealed(std::uint64_t begin, std::uint64_t end, channel::SessionId session, crypto::SuiteId suite);
    /// Call after each datagram that arrived, opened or not, and before the thread goes to sleep.
    void wokeUp() { m_slept = false; }
    void sleeps() { m_slept = true; }
    /// Counts the frames of a delivery, for the rates.
    void countFrames(channel::SessionId session, std::uint64_t frames) { m_meters[session].openedFrames(frames); }
    void forget(channel::SessionId session) { m_meters.erase(session); }

    /// Call about once a second.
    void roll(TimePoint now);
    SuiteCost of(channel::SessionId session) const;
    /// The cost of the session to this process, and that of the process.
    channel::EndCosts endCosts(channel::SessionId session) const;
    /// While on, the cost of each record is kept over all sessions and suites, see opening() and sealing().
    void setMeasuring(bool measuring) { m_measuring = measuring; }
    const metrics::Histogram &opening() const { return m_opening; }
    const metrics::Histogram &sealing() const { return m_sealing; }

private:
    metrics::WorkClock m_clock;
    std::map<channel::SessionId, SuiteMeter> m_meters;
    bool m_slept = true; ///< no record was opened in this wake-up yet
    bool m_measuring = false;
    metrics::Histogram m_opening, m_sealing;
};

} // namespace skyseal::engine
