// One end of the secure channel: all sessions of one identity. A plain object without socket, thread or clock; see
// PROTOCOL.md in this folder for the protocol.
//
// Use it from one thread, in four groups of calls:
//   query     sessionInfo(), stats(), nextDeadline()
//   input     handleDatagram(), handleInlineFrame(), handleDeadline()
//   command   seal(), sealInline(), switchSuite(), rekey(), close()
//   output    pollTransmit() until it returns nothing, then pollEvent() until it returns nothing. Poll after each input
//             and command, then arm a timer for nextDeadline().
#pragma once

#include "core/base/bytes.h"
#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/base/random_source.h"
#include "core/channel/cost_source.h"
#include "core/channel/counter_store.h"
#include "core/channel/delivery.h"
#include "core/channel/endpoint_config.h"
#include "core/channel/events.h"
#include "core/channel/sealed.h"
#include "core/channel/session_info.h"

#include <memory>
#include <optional>
#include <vector>

namespace skyseal::channel {

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
    /// A station's handshakes with announced agents that have not answered yet.
    std::vector<Unanswered> unanswered() const;
    /// When a station last called agents at this address (setCallAt()); nullopt if it never did, or long ago.
    std::optional<TimePoint> lastCall(const Path &place) const;
    /// Datagrams that belong to no session. malformed: not a message of this version, or of an unknown connection; forged: a
    /// handshake message for another key; replayed: an old first message, or a reply to a first message whose session is up.
    const ReceiveCounters &unmatched() const;
    /// Keyed hashes that were computed over handshake messages before their sender was known: the cost that strangers cause.
    std::uint64_t strangerHashes() const;
    /// Latest time for the next handleDeadline(); kNever if no timer is running.
    TimePoint nextDeadline() const;
    /// Returns true if a datagram with this first byte belongs to the protocol. MAVLink's 0xFD and 0xFE never do.
    static bool owns(std::uint8_t firstByte);
    /// Returns true if the frame is marked as sealed in place: pass it to handleInlineFrame() and to no MAVLink parser.
    static bool ownsFrame(ByteView frame);
    /// Bytes that seal() puts in front of the frames, within the overhead of a record: a station's stamp.
    std::size_t stampLength() const;
    /// Returns true if the message is a record that carries the connection id of a session on a serial carrier: such a session
    /// may have moved to a new stream. Does not authenticate it.
    bool namesSerialSession(ByteView message) const;
    /// Returns true if the datagram is shaped like an announcement. Does not authenticate it.
    static bool isAnnouncement(ByteView datagram);

    // input
    /// Handles one datagram for which owns() is true, and opens a record in place. Returns frames only after the tag was
    /// verified.
    std::optional<Delivery> handleDatagram(TimePoint now, const Path &from, MutableByteView datagram);
    /// Opens one whole frame that was sealed in place, and makes it a plain frame in its buffer. The frame does not name its
    /// session; `from` identifies it. A datagram may hold several such frames.
    std::optional<Delivery> handleInlineFrame(TimePoint now, const Path &from, MutableByteView frame);
    void handleDeadline(TimePoint now);
    /// The stream of this link was reconnected: its sessions send a report at once, so that the peer learns the new path.
    void handleStreamBegan(TimePoint now, LinkId link);
    /// Counts dropped clear MAVLink frames from the path of a session, or of a pinned vehicle.
    void countPlaintextDropped(SessionId, std::uint64_t count);
    /// Stores the owner's counts of the frames of the session, for the next report to the peer.
    void noteFrames(SessionId, const FrameCounters &frames);
    /// `source` is called for each report to a peer that requests costs; empty: this end does not measure.
    void setCostSource(CostSource source);

    // command
    /// While on, requests the costs of the peers: stats().peerCosts. Off at first.
    void askCosts(bool ask);
    /// Seals whole frames into `out` (at least frames.size() + kMaxRecordOverhead bytes). Returns the size of the record. Send
    /// it to recordPath().
    Sealed seal(TimePoint now, SessionId, ByteView frames, MutableByteView out);
    /// Seals one whole frame for inline framing into `out` (frame.size() + 13 bytes, not overlapping). Returns the size.
    /// NotInline for MAVLink 1, signed and unknown messages, and for sessions with another framing().
    Sealed sealInline(TimePoint now, SessionId, ByteView frame, MutableByteView out);
    /// Current framing of the frames to send; Framing::Sealed for an unknown session.
    Framing framing(SessionId) const;
    /// Current destination of the session's records.
    Path recordPath(SessionId) const;
    /// Starts a live switch. The result is a SwitchDone event, also for an immediate refusal.
    void switchSuite(TimePoint now, SessionId, crypto::SuiteId);
    void rekey(TimePoint now, SessionId);
    /// Sends one sealed Close and forgets the session.
    void close(TimePoint now, SessionId);
    /// Replaces the list of peers. Sessions whose key is not listed any more, or is listed with another pre-shared key, end
    /// at once.
    void setPeers(TimePoint now, std::vector<Peer> peers);
    void setPolicy(TimePoint now, Policy policy);
    /// Replaces the addresses at which a station calls agents that listen. New ones are called when the current turn is over.
    void setCallAt(TimePoint now, std::vector<Path> paths);
    /// Replaces an agent's announcement targets.
    void setAnnounceTo(TimePoint now, std::vector<Path> paths);

    // output
    std::optional<Transmit> pollTransmit();
    bool hasTransmit() const;
    std::optional<Event> pollEvent();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace skyseal::channel
