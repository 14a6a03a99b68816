// One end of the secure channel: all sessions that run over one identity. A plain object without socket, thread or
// clock; PROTOCOL.md beside this file describes what it speaks.
//
// Use, from one thread, in four groups:
//   query     sessionInfo(), stats(), nextDeadline()
//   input     handleDatagram(), handleInlineFrame(), handleDeadline()
//   command   seal(), sealInline(), switchSuite(), rekey(), close()
//   output    pollTransmit() until it gives nothing, then pollEvent() until it gives nothing. Poll after every input
//             and command; then arm a timer for nextDeadline().
#pragma once

#include "core/base/bytes.h"
#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/base/random_source.h"
#include "core/base/result.h"
#include "core/channel/events.h"
#include "core/channel/message_traits.h"
#include "core/channel/policy.h"
#include "core/channel/stats.h"
#include "core/crypto/x25519.h"

#include <functional>
#include <memory>
#include <optional>

namespace skyseal::channel {

/// The station listens, learns where an agent is from its announcements, and starts the handshake (Noise initiator); the
/// agent announces itself twice a second until a session is up (Noise responder).
enum class Role : std::uint8_t { Station, Agent };

/// Counters that must never go back, over restarts: ours in first messages, and the last one seen of each peer. The owner
/// keeps them on disk. Called rarely (once a handshake).
class CounterStore
{
public:
    virtual ~CounterStore() = default;
    /// A number greater than every one given before, also by earlier runs.
    virtual std::uint64_t next() = 0;
    /// Numbers up to `counter` are used: next() gives greater ones from now on. False when that cannot be kept.
    virtual bool skipTo(std::uint64_t counter)
    {
        static_cast<void>(counter);
        return false;
    }
    /// The greatest number accepted from `peer`; 0 when none.
    virtual std::uint64_t lastSeen(const PublicKey &peer) = 0;
    /// Remembers it durably; false when that failed (there is no session then).
    virtual bool remember(const PublicKey &peer, std::uint64_t counter) = 0;
};

/// The protocol's timers and limits; the defaults are the protocol's (PROTOCOL.md gives each its reason), tests lower them.
struct Timing
{
    Duration announceEvery = std::chrono::milliseconds(500); ///< while no session is up
    /// While a session is up on the same link, but a peer that is listed has none.
    Duration announceBesideEvery = std::chrono::seconds(2);
    Duration handshakeRetry = std::chrono::milliseconds(250); ///< doubled each time, with jitter, up to 2 s
    Duration keepAliveAfter = std::chrono::seconds(1);        ///< send something when nothing was sent for so long
    /// Then a station handshakes anew, beside the old session. An agent announces itself after 1.5 x keepAliveAfter already.
    Duration peerSilentAfter = std::chrono::milliseconds(2500);
    Duration forgetAfter = std::chrono::minutes(10);  ///< a silent session ends
    Duration switchConfirm = std::chrono::seconds(5); ///< a switch not confirmed by then is rolled back
    Duration switchRetry = std::chrono::milliseconds(100);
    Duration oldKeysLinger = std::chrono::seconds(3); ///< or 3 round trips, whichever is longer
    Duration statsEvery = std::chrono::seconds(1);
    Duration rekeyAfter = std::chrono::seconds(600);
    std::uint32_t rekeyAfterRecords = 1u << 22;
    std::uint32_t hardStopRecords = (1u << 24) - 1;
};

/// What a session costs now: see EndCosts.
using CostSource = std::function<EndCosts(SessionId)>;

struct Config
{
    Role role = Role::Station;
    std::shared_ptr<const crypto::X25519KeyPair> identity; ///< our static key
    std::vector<Peer> peers;
    Policy policy;
    Timing timing;
    /// The agent's side: where to announce; more are learned from authenticated records. An all-zero address stands for the
    /// one peer of a link that has one.
    std::vector<Path> announceTo;
    /// What frames look like; without it, frames are never sealed in place, whatever the policy says.
    std::shared_ptr<const MessageTraits> messageTraits = nullptr;
};

/// A datagram to send as it is. The bytes live until the next call of a non-const member.
struct Transmit
{
    Path to;
    ByteView bytes;
};

/// Opened MAVLink frames (one or several whole ones, or what a peer sealed: parse them). The bytes lie in the datagram's
/// buffer and live as long as it.
struct Delivery
{
    SessionId session{};
    Epoch epoch{};
    crypto::SuiteId suite{};
    ByteView frames;
};

/// NotFrames: empty, or begins with a byte below 0x10, which marks the channel's own messages (MAVLink begins with 0xFD or
/// 0xFE). Exhausted: the hard limit of an epoch whose rekey never succeeded; the session ends. NotInline: neither this frame
/// nor perhaps the session is one to be sealed in place; seal it in a record.
enum class SealError : std::uint8_t { NoSession, TooLong, Exhausted, NoRoom, NotFrames, NotInline };

/// How many bytes were sealed, or why none. One word, because every record hands it up through three calls: a Result goes
/// by way of memory, and is read before it has arrived there (5 ns each time).
class Sealed
{
public:
    Sealed(std::size_t size) : m_value(static_cast<std::int64_t>(size)) {}
    Sealed(SealError error) : m_value(-1 - static_cast<std::int64_t>(error)) {}

    bool has_value() const { return m_value >= 0; }
    explicit operator bool() const { return has_value(); }
    /// Only of one that has a value.
    std::size_t operator*() const { return static_cast<std::size_t>(m_value); }
    std::size_t value_or(std::size_t other) const { return has_value() ? **this : other; }
    /// Only of one that has none.
    SealError error() const { return static_cast<SealError>(-1 - m_value); }

private:
    std::int64_t m_value;
};

/// How much a record adds to the frames it carries at the most, and the most that one may carry so that the datagram
/// stays within 1200 bytes.
inline constexpr std::size_t kMaxRecordOverhead = 40;
inline constexpr std::size_t kMaxRecordPayload = 1200 - kMaxRecordOverhead;

struct SessionInfo
{
    SessionId session{};
    PublicKey peer{};
    std::string peerName;
    PeerRole role{};
    Path path;
    crypto::SuiteId suite{};
    Epoch epoch{};
    Framing framing{};                        ///< how frames are sent now
    std::optional<crypto::SuiteId> pending;   ///< a switch that is under way
    std::vector<crypto::SuiteId> permitted;   ///< by both ends
    std::vector<crypto::SuiteId> peerOffered; ///< what the other end would accept, as it said; None among them: plain as well
    bool silent = false;                      ///< nothing authentic for Timing::peerSilentAfter
    TimePoint since{};
    TimePoint lastReceived{};
};

/// A known agent that announces itself and has not answered the handshake: it does not know our key, or it is deaf.
struct Unanswered
{
    PublicKey peer{};
    std::string peerName;
    Path path;             ///< where its newest announcement came from
    TimePoint since{};     ///< of the first message that it did not answer
    TimePoint announced{}; ///< when it was heard last
    unsigned sent = 0;     ///< first messages
};

class Endpoint
{
public:
    /// `random` and `counters` must outlive the endpoint.
    Endpoint(Config config, RandomSource &random, CounterStore &counters, TimePoint now);
    ~Endpoint();
    Endpoint(Endpoint &&) noexcept;
    Endpoint &operator=(Endpoint &&) noexcept;

    // query
    std::vector<SessionId> sessions() const;
    std::optional<SessionInfo> sessionInfo(SessionId) const;
    std::optional<SessionStats> stats(SessionId) const;
    /// A station's handshakes with agents that were heard and have not answered yet.
    std::vector<Unanswered> unanswered() const;
    /// Datagrams that belong to no session. malformed: no message of this version, or of an unknown connection; forged: a
    /// handshake message that is not meant for our key; replayed: one that came before.
    const ReceiveCounters &unmatched() const;
    /// When handleDeadline() must be called at the latest; kNever when there is nothing to wait for.
    TimePoint nextDeadline() const;
    /// True for a first byte that belongs to this protocol; MAVLink's 0xFD and 0xFE never do.
    static bool owns(std::uint8_t firstByte);
    /// True for a frame that claims to be sealed in place: hand it to handleInlineFrame(). It is no frame for anybody else.
    static bool ownsFrame(ByteView frame);

    /// True for what has the form of an agent's announcement, whosever it is.
    static bool isAnnouncement(ByteView datagram);

    // input
    /// Takes one datagram whose first byte it owns and opens it in place. Gives frames only after their tag verified.
    std::optional<Delivery> handleDatagram(TimePoint now, const Path &from, MutableByteView datagram);
    /// Takes one frame that was sealed in place, alone and whole (a datagram may hold several), and makes it plain where it
    /// is. The session is found by where it came from, since the frame names none.
    std::optional<Delivery> handleInlineFrame(TimePoint now, const Path &from, MutableByteView frame);
    void handleDeadline(TimePoint now);
    /// A stream of this link was cut and joined anew: its sessions say at once where they are now.
    void handleStreamBegan(TimePoint now, LinkId link);
    /// Tells that clear MAVLink of `count` frames came from the path of a session, or claimed a pinned vehicle.
    void countPlaintextDropped(SessionId, std::uint64_t count);
    /// What the caller counts of the frames that the session delivered; the peer is told with the next report.
    void noteFrames(SessionId, const FrameCounters &frames);

    /// Who measures what a session costs this end. It is called at each report to a peer that asks.
    void setCostSource(CostSource source);

    // command
    /// Asks the peers for what their end costs, as long as it is on: stats().peerCosts. It is off at first, and costs nothing.
    void askCosts(bool ask);
    /// Seals whole frames into `out` (at least frames.size() + kMaxRecordOverhead): the record's size. It goes to
    /// sessionInfo(session)->path; see recordPath().
    Sealed seal(TimePoint now, SessionId, ByteView frames, MutableByteView out);
    /// Seals one whole frame in place into `out` (13 bytes more than the frame, apart from it): the size. NotInline for
    /// frames that cannot travel so (MAVLink 1, signed ones, unknown messages) and for sessions that do not (framing()).
    Sealed sealInline(TimePoint now, SessionId, ByteView frame, MutableByteView out);
    /// How frames of the session go now; Sealed when there is no such session.
    Framing framing(SessionId) const;
    /// Where records of the session go now.
    Path recordPath(SessionId) const;
    /// Begins a live switch; the result comes as SwitchDone, a refusal at once as well.
    void switchSuite(TimePoint now, SessionId, crypto::SuiteId);
    void rekey(TimePoint now, SessionId);
    /// Tells the peer, once and sealed, and forgets the session.
    void close(TimePoint now, SessionId);
    /// A new list of peers; sessions with keys that are no longer in it end at once, as do those made with another
    /// pre-shared key than the one that is listed now.
    void setPeers(TimePoint now, std::vector<Peer> peers);
    void setPolicy(TimePoint now, Policy policy);
    /// An agent's: where to announce itself from now on.
    void setAnnounceTo(TimePoint now, std::vector<Path> paths);

    // output
    std::optional<Transmit> pollTransmit();
    std::optional<Event> pollEvent();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace skyseal::channel
