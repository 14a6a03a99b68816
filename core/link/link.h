// One way to carry bytes to other machines: what UDP, TCP, serial and log replay have in common. Lives on the I/O
// worker thread, whole; its listener is called there and nowhere else.
//
// Packets do not pass through signals: a wake-up hands the listener everything that arrived as one batch of views into
// the link's own buffers, writable, so that records are opened in place. Nothing here allocates per packet.
#pragma once

#include "core/base/bytes.h"
#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/link/link_error.h"
#include "core/link/link_url.h"

#include <QtCore/QObject>

#include <optional>

namespace skyseal::link {

class Link;

/// One datagram, or the next chunk of a byte stream (Link::isStream()).
struct ReceivedBlock
{
    Path path;
    MutableByteView bytes; ///< may be changed in place; gone when the call returns
    TimePoint time;
};

/// Who is told what a link received. Calls come from inside the event loop of the link's thread; close() may be called
/// from within, deleting the link may not (use deleteLater).
class LinkListener
{
public:
    virtual ~LinkListener() = default;
    virtual void linkReceived(Link &link, std::span<const ReceivedBlock> blocks) = 0;
    /// A stream begins or ends (tcp, tcpin, serial): partial frames of that path belong to the old stream.
    virtual void linkPeerJoined(Link &, const Path &) {}
    virtual void linkPeerLeft(Link &, const Path &) {}
};

enum class LinkState : std::uint8_t {
    Closed,
    Opening,   ///< looking up a name, connecting
    Listening, ///< bound; peers may come
    Connected, ///< udpout: the remote address is known; tcp, serial, tlog: open
    Waiting,   ///< failed for now (`error()` says why), tries again by itself
    Failed,    ///< failed for good: only open() tries again
    Ended,     ///< a log was replayed to its end
};

/// One word for scripts, e.g. "listening".
const char *name(LinkState state);

/// Since the link was made, over all its peers.
struct LinkCounters
{
    std::uint64_t rxBlocks = 0; ///< datagrams or stream chunks
    std::uint64_t rxBytes = 0;
    std::uint64_t rxOversized = 0;   ///< datagrams longer than kMaxDatagram: dropped
    std::uint64_t rxKernelDrops = 0; ///< datagrams that the system dropped because we were too slow, where it tells
    std::uint64_t rxErrors = 0;
    std::uint64_t txBlocks = 0;
    std::uint64_t txBytes = 0;
    std::uint64_t txDropped = 0; ///< blocks for which there was no room, no peer or no open link
    std::uint64_t txErrors = 0;  ///< blocks that the system refused to send

    bool operator==(const LinkCounters &) const = default;
};

/// The longest datagram that is received or sent; a record has at most 1200 bytes, a MAVLink frame 280.
inline constexpr std::size_t kMaxDatagram = 2048;

struct LinkOptions
{
    /// Use QUdpSocket even where the system can receive in batches.
    bool portableUdp = false;
    int receiveBufferBytes = 4 << 20; ///< asked of the system for UDP
    /// About how long the datagrams of one wake-up may take before timers and the other links have their turn: a frame
    /// from the vehicle does not wait for a whole burst of handshakes that somebody sends to the other link.
    Duration turn = std::chrono::microseconds(50);
    std::size_t streamQueueBytes = 256 << 10; ///< unsent bytes per stream before blocks are dropped
    /// tcpin: a client that was of no use for so long gives way to a new one when there is no room.
    Duration uselessAfter = std::chrono::seconds(5);
    Duration retryFirst = std::chrono::milliseconds(500);
    Duration retryMax = std::chrono::seconds(5);
    double replayFactor = 1.0; ///< tlog: 2 = twice as fast as recorded, 0 = as fast as possible
};

/// Base of all links. open() never blocks and never throws: the outcome is the state.
class Link : public QObject
{
    Q_OBJECT

public:
    Link(LinkUrl url, LinkId id, LinkListener &listener, LinkOptions options);
    ~Link() override;

    LinkId id() const { return m_id; }
    const LinkUrl &url() const { return m_url; }
    /// Fixed from construction on; a member, cheap enough to ask for each block.
    const LinkTraits &traits() const { return m_traits; }
    LinkState state() const { return m_state; }
    /// Why the state is Waiting, Failed or Ended; code None otherwise.
    const LinkError &error() const { return m_error; }

    bool isStream() const { return m_traits.isStream; }
    /// Our own address while one is bound.
    virtual std::optional<Address> localEndpoint() const { return std::nullopt; }
    /// Where the link listens or sends from, for people: "0.0.0.0:14550", the device, the file. Before it is bound, what
    /// was asked for.
    virtual std::string localAddress() const;
    /// The one peer of udpout and tcp once it is known; all zero for the others.
    virtual Address remote() const { return {}; }
    virtual LinkCounters counters() const { return m_counters; }

    /// Starts, or starts again from Closed, Failed and Ended; no effect otherwise.
    virtual void open() = 0;
    virtual void close() = 0;

    /// Queues one block; flush() sends what is queued, and a full queue flushes itself. The all-zero address means
    /// remote(). Blocks that cannot be taken are dropped and counted, never waited for.
    virtual void send(const Address &to, ByteView block) = 0;
    /// Call at the end of every wake-up in which something was sent.
    virtual void flush() = 0;

    /// What came from there just now was of use: a valid frame, an authentic record. Only the listener can tell. Where there
    /// are places for a few peers only, who is of no use gives way.
    virtual void noteUse(const Address &) {}

Q_SIGNALS:
    void stateChanged(skyseal::link::LinkState state);

protected:
    void setState(LinkState state, LinkError error = {});
    LinkListener &listener() { return m_listener; }
    const LinkOptions &options() const { return m_options; }

    LinkCounters m_counters;

private:
    const LinkUrl m_url;
    const LinkTraits m_traits;
    const LinkId m_id;
    LinkListener &m_listener;
    const LinkOptions m_options;
    LinkState m_state = LinkState::Closed;
    LinkError m_error;
};

} // namespace skyseal::link
