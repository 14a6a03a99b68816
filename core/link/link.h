// Base class of the links: UDP, TCP, serial and log replay. A link and its listener live on the thread that made the link
// (the I/O thread of a station).
//
// Received blocks do not pass through signals: each wake-up of the event loop calls the listener with one batch of writable
// views into the link's buffers, so that records are opened in place and nothing is allocated per packet.
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

/// One datagram, or the next chunk of a byte stream (LinkTraits::isStream).
struct ReceivedBlock
{
    Path path;
    MutableByteView bytes; ///< may be changed in place; valid during the call
    TimePoint time;
};

/// Receives the blocks of a link. Called from the event loop of the link's thread. The listener may call close(), but must
/// not delete the link (use deleteLater()).
class LinkListener
{
public:
    virtual ~LinkListener() = default;
    virtual void linkReceived(Link &link, std::span<const ReceivedBlock> blocks) = 0;
    /// A byte stream begins or ends (tcp, tcpin, serial). Discard partial frames of that path.
    virtual void linkPeerJoined(Link &, const Path &) {}
    virtual void linkPeerLeft(Link &, const Path &) {}
};

enum class LinkState : std::uint8_t {
    Closed,
    Opening,   ///< looking up a name, connecting
    Listening, ///< bound; peers may connect
    Connected, ///< udpout: the remote address is known; tcp, serial, tlog: open
    Waiting,   ///< failed; error() has the reason, and the link retries by itself
    Failed,    ///< failed; open() retries
    Ended,     ///< the log was replayed to its end
};

/// Keyword for scripts, e.g. "listening".
const char *name(LinkState state);

/// Totals of all peers since the link was created.
struct LinkCounters
{
    std::uint64_t rxBlocks = 0; ///< datagrams or stream chunks
    std::uint64_t rxBytes = 0;
    std::uint64_t rxOversized = 0;   ///< datagrams longer than kMaxDatagram: dropped
    std::uint64_t rxKernelDrops = 0; ///< datagrams dropped by the full receive buffer of the system (Linux only)
    std::uint64_t rxErrors = 0;
    std::uint64_t txBlocks = 0;
    std::uint64_t txBytes = 0;
    std::uint64_t txDropped = 0; ///< blocks dropped because the queue was full, or no peer or open link existed
    std::uint64_t txErrors = 0;  ///< blocks that the system call rejected

    bool operator==(const LinkCounters &) const = default;
};

/// The longest datagram that is received or sent; a record has at most 1200 bytes, a MAVLink frame 280.
inline constexpr std::size_t kMaxDatagram = 2048;

struct LinkOptions
{
    /// Use QUdpSocket even where the system can receive in batches.
    bool portableUdp = false;
    /// UDP on Linux: pass consecutive datagrams of one size to one address to the system as one buffer, which it segments
    /// (UDP_SEGMENT). For load generators; datagrams of ordinary traffic seldom have the same size.
    bool segmentedUdp = false;
    int receiveBufferBytes = 4 << 20; ///< requested from the system for UDP
    /// Approximate time that the datagrams of one wake-up may take before timers and the other links are served. Bounds the
    /// delay of a frame from the vehicle while another link receives a burst of handshakes.
    Duration turn = std::chrono::microseconds(50);
    std::size_t streamQueueBytes = 256 << 10; ///< unsent bytes per stream before blocks are dropped
    /// tcpin: a client without noteUse() for this time is closed when a new one needs its place.
    Duration uselessAfter = std::chrono::seconds(5);
    Duration retryFirst = std::chrono::milliseconds(500);
    Duration retryMax = std::chrono::seconds(5);
    double replayFactor = 1.0; ///< tlog: 2 = twice as fast as recorded, 0 = as fast as possible
};

/// open() never blocks and never throws; its outcome is the state.
class Link : public QObject
{
    Q_OBJECT

public:
    Link(LinkUrl url, LinkId id, LinkListener &listener, LinkOptions options);
    ~Link() override;

    LinkId id() const { return m_id; }
    const LinkUrl &url() const { return m_url; }
    /// Constant; a member, so that reading it for each block is cheap.
    const LinkTraits &traits() const { return m_traits; }
    LinkState state() const { return m_state; }
    /// Reason of the states Waiting, Failed and Ended; code None otherwise.
    const LinkError &error() const { return m_error; }

    bool isStream() const { return m_traits.isStream; }
    /// The bound local address, if any.
    virtual std::optional<Address> localEndpoint() const { return std::nullopt; }
    /// Text for people: the local address "0.0.0.0:14550", the device or the file. Before it is bound, as in the URL.
    virtual std::string localAddress() const;
    /// The peer of udpout and tcp once its address is known; all zero otherwise.
    virtual Address remote() const { return {}; }
    virtual LinkCounters counters() const { return m_counters; }

    /// Starts from Closed, Failed or Ended; no effect in other states.
    virtual void open() = 0;
    virtual void close() = 0;

    /// Queues one block; flush() sends the queue, and a full queue flushes itself. The all-zero address means remote().
    /// Never blocks: a block that does not fit is dropped and counted.
    virtual void send(const Address &to, ByteView block) = 0;
    /// Call at the end of each wake-up that called send().
    virtual void flush() = 0;

    /// Call when a valid frame or an authentic record was received from this peer. Links with a limited number of peers (tcpin)
    /// close peers without such calls first.
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
