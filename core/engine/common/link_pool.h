// All links of one engine: created from URLs, found by id, flushed together at the end of a wake-up, and described in
// snapshots. I/O thread.
#pragma once

#include "core/engine/common/carrier_writer.h"
#include "core/engine/common/link_snapshot.h"
#include "core/link/link.h"
#include "core/metrics/rate_meter.h"

#include <functional>
#include <memory>
#include <vector>

namespace skyseal::engine {

/// Purpose of a link.
enum class LinkUse : std::uint8_t {
    Both,
    ListenOnly ///< nothing is ever sent on it
};

class LinkPool
{
public:
    using StateChanged = std::function<void(link::Link &)>;

    /// `listener` receives the blocks; `stateChanged` is called after a link's state changed, also from within open().
    LinkPool(link::LinkListener &listener, StateChanged stateChanged, link::LinkOptions options = {});
    ~LinkPool();

    link::Link &open(LinkId id, const link::LinkUrl &url, LinkUse use = LinkUse::Both);
    /// Closes the link; the object is deleted by the event loop, since it may be the caller.
    void remove(LinkId id);
    link::Link *find(LinkId id) const;
    /// Nothing is ever sent on the link.
    bool isListenOnly(LinkId id) const;

    /// Queues one block for a remote, in the carrier of the path (clear MAVLink goes in Carrier::Datagram, which adds
    /// nothing); dropped if the link was removed or only listens.
    void send(const Path &to, ByteView block);
    /// The encoder of the carriers; its node is the sender of TUNNEL messages.
    CarrierWriter &carriers() { return m_carriers; }
    const CarrierWriter &carriers() const { return m_carriers; }
    /// Whether frames should be coalesced on this path: a serial line at a radio's speed, or a path through MAVLink routers.
    bool isSlow(const Path &path) const;
    /// Sends the blocks that were queued since the last flush.
    void flush();

    template<typename F> void forEach(F &&each)
    {
        for (Entry &entry : m_entries)
            each(*entry.link);
    }

    /// The remote address to show for the link.
    void noteRemote(LinkId id, const Address &remote);
    /// Call when a valid frame or authentic record arrived from there; see link::Link::noteUse().
    void noteUse(const Path &from);
    /// Frames with a bad checksum.
    void countBadFrame(LinkId id, std::uint64_t count = 1);
    std::uint64_t badFrames() const;
    std::vector<LinkSnapshot> snapshots(TimePoint now);
    LinkSnapshot snapshot(const link::Link &link) const;

private:
    struct Later
    {
        void operator()(link::Link *link) const { link->deleteLater(); }
    };
    struct Entry
    {
        std::unique_ptr<link::Link, Later> link;
        LinkUse use = LinkUse::Both;
        bool dirty = false;
        Address remote{};
        std::uint64_t badCrc = 0;
        std::uint64_t rxBytesSeen = 0, txBytesSeen = 0;
        metrics::RateMeter rxRate, txRate;
    };

    Entry *entry(LinkId id);
    const Entry *entry(LinkId id) const;
    LinkSnapshot describe(const Entry &entry) const;

    link::LinkListener &m_listener;
    StateChanged m_stateChanged;
    link::LinkOptions m_options;
    std::vector<Entry> m_entries;
    CarrierWriter m_carriers;
    std::uint64_t m_badFramesOfRemoved = 0;
};

} // namespace skyseal::engine
