// Connects the secure channel, which has no sockets, with the links, which have no keys: passes records in, coalesces the
// frames of one wake-up (of 40 ms on a slow link) into records, and sends the protocol's own messages. The station and the
// agent use the same class. I/O thread.
#pragma once

#include "core/channel/delivery.h"
#include "core/channel/events.h"
#include "core/channel/sealed.h"
#include "core/engine/common/channel_costs.h"
#include "core/engine/common/link_pool.h"

#include <map>
#include <memory>
#include <vector>

namespace skyseal::channel {
class Endpoint;
}

namespace skyseal::engine {

class ChannelDriver
{
public:
    /// Time for which frames are coalesced on a slow link, unless one is urgent: a record's header and tag are as long as half
    /// a frame of telemetry, and a delay of 40 ms is not visible.
    static constexpr Duration kCoalesceDelay = std::chrono::milliseconds(40);

    ChannelDriver(channel::Endpoint endpoint, LinkPool &links);
    ~ChannelDriver();

    channel::Endpoint &endpoint() { return *m_endpoint; }
    const channel::Endpoint &endpoint() const { return *m_endpoint; }
    ChannelCosts &costs() { return m_costs; }
    const ChannelCosts &costs() const { return m_costs; }

    /// Takes a datagram whose first byte belongs to the channel. Returns its frames, opened in place; nullopt if there are
    /// none or it is rejected.
    std::optional<channel::Delivery> receive(TimePoint now, const Path &from, MutableByteView datagram);
    /// The same for one frame that was sealed in place.
    std::optional<channel::Delivery> receiveInline(TimePoint now, const Path &from, MutableByteView frame);

    /// Adds a whole frame to the session's next datagram: to a record, or sealed in place where the session and the frame
    /// allow it. Returns false if it is too long.
    bool queue(TimePoint now, channel::SessionId session, ByteView frame);
    /// Seals frames that are due, and sends everything that is sealed, in the order of its counters. Call at the end of each
    /// wake-up.
    void flush(TimePoint now);
    /// The same for all frames, due or not; for use before the sessions are closed.
    void flushAll(TimePoint now);
    /// Closes all sessions. Returns the goodbyes, which were sent once, so that the caller can repeat them.
    struct Goodbye
    {
        Path to;
        Bytes datagram;
    };
    std::vector<Goodbye> closeAll(TimePoint now);
    /// Latest time for the next flush().
    TimePoint flushDue() const { return m_flushDue; }

    /// Returns the next event, after updating the totals: the counters of an ended session are kept. The end of the session
    /// `speaking`, and the events after it, are left for a later call: its peer must still be known while a delivery is judged.
    std::optional<channel::Event> pollEvent(std::optional<channel::SessionId> speaking = {});

    /// Call about once a second.
    void roll(TimePoint now);
    /// While on, the costs are kept as well (see ChannelCosts).
    void setMeasuring(bool measuring);
    /// Sums over all sessions, including ended ones and unmatched records. The suite is that of the session heard last.
    ChannelTotals totals() const;

private:
    struct Batch
    {
        std::size_t size = 0;
        bool sealedInPlace = false; ///< the frames are already sealed, each by itself
        bool urgent = false;
        std::optional<Path> path; ///< of the newest record, for which `slow` was determined
        bool slow = false;        ///< frames are coalesced on this path
        TimePoint since{};        ///< of the oldest frame
        std::array<std::uint8_t, channel::kMaxRecordPayload> frames;

        bool holds(std::size_t more, std::size_t most) const { return size + more <= most; }
        void add(TimePoint now, ByteView bytes);
    };

    std::optional<channel::Delivery> taken(std::uint64_t begin, std::size_t bytes, std::optional<channel::Delivery> delivery);
    bool queueInline(TimePoint now, channel::SessionId session, ByteView frame, Batch &batch);
    std::size_t roomOf(const Path &path, channel::SessionId session);
    bool mayWait(TimePoint now, const Path &path, Batch &batch) const;
    void sealBatch(TimePoint now, channel::SessionId session, Batch &batch);
    void transmit();
    void sendInPlace(channel::SessionId session, Batch &batch);

    std::unique_ptr<channel::Endpoint> m_endpoint;
    LinkPool &m_links;
    ChannelCosts m_costs;
    std::map<channel::SessionId, Batch> m_batches;
    std::map<channel::SessionId, crypto::SuiteId> m_sendSuites; ///< from the events
    std::array<std::uint8_t, channel::kMaxRecordPayload + channel::kMaxRecordOverhead> m_record;
    TimePoint m_flushDue = kNever;
    ChannelTotals m_kept;                 ///< the counters of ended sessions, and the bytes on the wire of all
    std::optional<channel::Event> m_left; ///< deferred by pollEvent()
};

} // namespace skyseal::engine
