// Joins the secure channel, which knows no sockets, with the links, which know no keys: hands records in, coalesces frames
// of one wake-up, or on a slow link of 40 ms, into records, sends what the protocol itself wants to send, and measures what
// the ciphers cost. The station and the agent drive their endpoint by the same class. I/O thread.
#pragma once

#include "core/channel/endpoint.h"
#include "core/engine/common/link_pool.h"
#include "core/engine/common/suite_meter.h"
#include "core/metrics/work_clock.h"

#include <map>
#include <vector>

namespace skyseal::engine {

class ChannelDriver
{
public:
    /// So long a frame waits for company on a slow link, unless it is urgent: a head and a tag are as long as half a frame
    /// of telemetry, and nobody sees a twenty-fifth of a second.
    static constexpr Duration kCoalesceDelay = std::chrono::milliseconds(40);

    ChannelDriver(channel::Endpoint endpoint, LinkPool &links);

    channel::Endpoint &endpoint() { return m_endpoint; }
    const channel::Endpoint &endpoint() const { return m_endpoint; }

    /// Takes a datagram whose first byte the channel owns; what it carried, opened in place.
    std::optional<channel::Delivery> receive(TimePoint now, const Path &from, MutableByteView datagram);
    /// The same for one frame that was sealed in place.
    std::optional<channel::Delivery> receiveInline(TimePoint now, const Path &from, MutableByteView frame);
    /// Tells how many frames a delivery held, for the rates.
    void countFrames(channel::SessionId session, std::uint64_t frames) { m_meters[session].openedFrames(frames); }

    /// Adds a whole frame to the session's next datagram: to a record, or sealed in place where the session and the frame
    /// allow it. False when it is too long.
    bool queue(TimePoint now, channel::SessionId session, ByteView frame);
    /// Seals what was queued and need not wait, and sends all that the endpoint has to say. At the end of each wake-up.
    void flush(TimePoint now);
    /// The same for all that was queued: before the end.
    void flushAll(TimePoint now);
    /// Ends all sessions; the goodbyes, which went out once, for whoever wants to say them again.
    struct Goodbye
    {
        Path to;
        Bytes datagram;
    };
    std::vector<Goodbye> closeAll(TimePoint now);
    /// When flush() must be called at the latest.
    TimePoint flushDue() const { return m_flushDue; }

    /// The next event, with the books kept: a session that ended stays in the totals. That `speaking` ended, and what came
    /// after it, is left for a later call: who is about to judge a delivery must still know whose it is.
    std::optional<channel::Event> pollEvent(std::optional<channel::SessionId> speaking = {});

    /// Call about once a second.
    void roll(TimePoint now);
    SuiteCost cost(channel::SessionId session) const;
    /// What the session costs this process.
    channel::EndCosts endCosts(channel::SessionId session) const;
    /// What each record costs is kept over all sessions and suites while this is on, read opening() and sealing(); and the
    /// other ends are asked for their costs.
    void setMeasuring(bool measuring);
    const metrics::Histogram &opening() const { return m_opening; }
    const metrics::Histogram &sealing() const { return m_sealing; }
    /// Sums over all sessions, ended ones and unmatched included. The suite is that of the session heard last.
    ChannelTotals totals() const;

private:
    struct Batch
    {
        std::size_t size = 0;
        bool sealedInPlace = false; ///< the frames are sealed already, each by itself
        bool urgent = false;
        TimePoint since{}; ///< of the oldest frame
        std::array<std::uint8_t, channel::kMaxRecordPayload> frames;

        bool holds(std::size_t more, std::size_t most) const { return size + more <= most; }
        void add(TimePoint now, ByteView bytes);
    };

    std::optional<channel::Delivery> taken(std::uint64_t begin, std::size_t bytes, std::optional<channel::Delivery> delivery);
    bool queueInline(TimePoint now, channel::SessionId session, ByteView frame, Batch &batch);
    std::size_t roomOf(const Path &path, channel::SessionId session);
    bool mayWait(TimePoint now, const Path &path, const Batch &batch) const;
    void sealBatch(TimePoint now, channel::SessionId session, Batch &batch);
    void transmit();

    channel::Endpoint m_endpoint;
    LinkPool &m_links;
    metrics::WorkClock m_clock;
    std::map<channel::SessionId, Batch> m_batches;
    std::map<channel::SessionId, SuiteMeter> m_meters;
    std::map<channel::SessionId, crypto::SuiteId> m_sendSuites; ///< as the events told
    std::array<std::uint8_t, channel::kMaxRecordPayload + channel::kMaxRecordOverhead> m_record;
    TimePoint m_flushDue = kNever;
    bool m_slept = true; ///< nothing was opened in this wake-up yet
    WireTotals m_wire;
    bool m_measuring = false;
    metrics::Histogram m_opening, m_sealing;
    channel::ReceiveCounters m_endedRx, m_endedPeerRx;
    std::optional<channel::FrameCounters> m_endedPeerFrames;
    channel::SendCounters m_endedTx;
    std::optional<channel::Event> m_left; ///< by pollEvent()
};

} // namespace skyseal::engine
