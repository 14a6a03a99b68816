// One session: seals and opens its records and inline frames, answers control messages and keeps its timers. The parts decide
// (Epochs, LiveSwitch, ReportExchange, PeerPath, ...), the session connects them. Its own datagrams go to the context's
// outgoing queue, its events to the context's event queue. PROTOCOL.md, sections 5 to 8 and 12.
#pragma once

#include "core/base/locked_memory.h"
#include "core/channel/delivery.h"
#include "core/channel/epoch_exchange.h"
#include "core/channel/epoch_handover.h"
#include "core/channel/epochs.h"
#include "core/channel/freshness_judge.h"
#include "core/channel/inline_frame.h"
#include "core/channel/live_switch.h"
#include "core/channel/peer_path.h"
#include "core/channel/permissions.h"
#include "core/channel/record.h"
#include "core/channel/record_receiver.h"
#include "core/channel/rekey_schedule.h"
#include "core/channel/report_exchange.h"
#include "core/channel/sealed.h"
#include "core/channel/session_context.h"
#include "core/channel/session_info.h"

namespace skyseal::channel {

struct SessionIdentity
{
    SessionId id{};
    bool initiator = false;
    Peer peer;
    ConnectionId ours{};   ///< in received records
    ConnectionId theirs{}; ///< in sent records

    Direction direction() const { return initiator ? Direction::FromInitiator : Direction::FromResponder; }
};

/// Result of a handshake.
struct SessionSetup
{
    SessionIdentity identity;
    SuiteOffer peerOffer;
    crypto::SuiteId suite{};
    KeyChain chain;
    Path path;
};

class Session final : public InLockedMemory, private SwitchActions
{
public:
    Session(SessionSetup setup, SessionContext &context, TimePoint now);

    // query
    SessionId id() const { return m_identity.id; }
    ConnectionId connection() const { return m_identity.ours; }
    const Peer &peer() const { return m_identity.peer; }
    const Path &path() const { return m_path.current(); }
    const Path &origin() const { return m_path.origin(); }
    SessionInfo info(TimePoint now) const;
    SessionStats stats() const;
    TimePoint deadline() const;
    TimePoint lastReceived() const { return m_lastReceived; }
    /// From then on the session is over. Only echoes in reports keep it alive: without them the two clocks cannot be compared
    /// any more. Otherwise an attacker who withholds nothing but reports would leave a session in which no command is fresh.
    TimePoint forgetAt() const;
    TimePoint silentFrom() const { return m_lastReceived + m_context.timing.peerSilentAfter; }
    bool silent(TimePoint now) const { return now >= silentFrom(); }
    /// An active session is never without a record for so long unless records were lost. An agent announces itself again from
    /// then on; the session itself is not affected.
    TimePoint quietFrom() const { return m_lastReceived + m_context.timing.keepAliveAfter * 3 / 2; }
    bool quiet(TimePoint now) const { return now >= quietFrom(); }
    /// The agent reports that its session is quiet, while its own records arrive.
    bool peerReceivesNothing() const { return m_reports.peerReceivesNothing(); }
    /// False if the ciphers of the first epoch could not be made: discard the session.
    bool usable() const { return m_epochs.begun(); }
    /// The peer sent Close.
    bool closing() const { return m_closingUntil.has_value(); }
    /// Reason for which the endpoint must end the session.
    std::optional<DownReason> finished() const { return m_finished; }
    /// Framing that both ends want, for the suites that have it.
    Framing agreedFraming() const { return m_permissions.framing(); }
    /// Framing of the next frame to send.
    Framing framing() const;

    // input
    struct Opened
    {
        bool authentic = false;
        bool routine = false; ///< frames under the current epoch, and no timer or state has changed
    };
    /// Opens a record in place and sets `delivery` if it holds frames.
    Opened open(TimePoint now, const Path &from, const RecordHeader &header, MutableByteView datagram,
                std::optional<Delivery> &delivery);
    /// Opens an inline frame in place. It does not move the path of the session.
    Opened openInline(TimePoint now, const InlineFrame &frame, std::optional<Delivery> &delivery);
    void handleDeadline(TimePoint now);
    /// Sends a report that requests an answer, at most once a second; for example after the stream of the session's link was
    /// reconnected.
    void requestReport(TimePoint now);
    /// Sends such a report to another address at which the peer may be; the answer moves the path there. Used by an agent whose
    /// session is quiet: if only its own records get through, the station has no reason to leave the path. A session cannot
    /// move to another carrier; there a new one replaces it, see peerReceivesNothing().
    void requestReportAt(TimePoint now, const Path &to);
    void countPlaintextDropped(std::uint64_t count) { m_epochs.current().rx.plaintextDropped += count; }
    void countMalformed() { ++m_epochs.current().rx.malformed; }
    /// The owner's counts, for the next report.
    void noteFrames(const FrameCounters &frames) { m_reports.noteFrames(frames); }

    // command
    Sealed seal(TimePoint now, ByteView plaintext, MutableByteView out);
    Sealed sealInline(TimePoint now, ByteView frame, MutableByteView out);
    void switchSuite(TimePoint now, crypto::SuiteId suite) { m_switch.request(now, suite, suite == currentSuite(), *this); }
    void rekey(TimePoint now) { m_switch.request(now, currentSuite(), true, *this); }
    /// On a serial carrier: until then records carry the connection id, since the peer may already have a newer session.
    void nameRecordsUntil(TimePoint until) { m_namedUntil = until; }
    /// Sends an empty record to a peer that may have lost the session. At most once a second, since the cause need not be
    /// authentic.
    void sendKeepAlive(TimePoint now);
    /// The list of peers has changed: takes over name and role.
    void updatePeer(const Peer &peer) { m_identity.peer = peer; }
    void policyChanged(TimePoint now);
    /// Fails a pending switch and, with `sendClose`, sends Close.
    void end(TimePoint now, bool sendClose);

private:
    // SwitchActions
    Epoch currentEpoch() const override { return m_epochs.current().number; }
    crypto::SuiteId currentSuite() const override { return m_epochs.current().suite; }
    bool permittedHere(crypto::SuiteId suite) const override { return m_permissions.permittedHere(suite); }
    bool permittedByPeer(crypto::SuiteId suite) const override { return m_permissions.permits(suite); }
    bool previousDispensable(TimePoint now) const override;
    Duration answerTime() const override { return roundTrip().smoothed(); }
    crypto::PublicKey makeProposalKey() override { return m_exchange.propose(m_context.random); }
    void dropProposalKey() override { m_exchange.drop(); }
    void send(TimePoint now, const ControlMessage &message) override;
    NextEpoch answerProposal(TimePoint now, const Propose &message, crypto::PublicKey &answer) override;
    NextEpoch takeAnswer(TimePoint now, crypto::SuiteId suite, const crypto::PublicKey &answer) override
    {
        return m_exchange.mayCompute(now) ? prepareNext(suite, m_exchange.finish(answer)) : NextEpoch::Ignored;
    }
    void dropNext() override { m_epochs.dropNext(); }
    void commitNext(TimePoint now) override;
    std::uint32_t sentBefore() const override { return m_handover.sentBefore(); }
    void peerSentBefore(std::uint32_t records) override;
    void notify(const Event &event) override { m_context.events.push_back(event); }

    const RoundTrip &roundTrip() const { return m_reports.roundTrip(); }
    NextEpoch prepareNext(crypto::SuiteId suite, const std::optional<SwitchSecret> &exchanged);
    DatagramKind kindFor(TimePoint now, const Path &to, ByteView plaintext) const;
    Sealed sealRecord(TimePoint now, const Path &to, ByteView plaintext, MutableByteView out);
    Sealed sealStamped(TimePoint now, ByteView plaintext, MutableByteView out);
    void deliver(TimePoint now, LiveEpoch &epoch, RecordPosition position, ByteView plaintext, Delivery &delivery);
    bool exhausted(const LiveEpoch &epoch);
    Opened opened(TimePoint now, const Path &from, const OpenRecord &record, std::optional<Delivery> &delivery);
    Opened refused(TimePoint now, RecordFault fault);
    bool follow(TimePoint now, const Path &from);
    void sendControl(TimePoint now, const Path &to, ByteView plaintext);
    void handleControl(TimePoint now, const Path &from, RecordPosition position, ByteView plaintext);
    void handleReport(TimePoint now, const Path &from, RecordPosition position, const Report &report);
    void sendTo(TimePoint now, const Path &to, const ControlMessage &message);
    void sendReport(TimePoint now, const Path &to, bool answerAtOnce);
    /// The owner has begun or ceased to request the peer's costs, and the peer does not know yet.
    bool isRequestDue() const { return m_confirmed && m_requestedCosts != m_context.askCosts; }
    TimePoint retirePreviousAt() const;
    /// The owner does not know a session yet that this end only answered.
    bool knownToOwner() const { return m_confirmed || m_identity.initiator; }
    void notifyMove(TimePoint now);
    void notifyForgeries(TimePoint now);

    SessionIdentity m_identity;
    SessionContext &m_context;
    Permissions m_permissions;
    Epochs m_epochs;
    EpochExchange m_exchange;
    EpochHandover m_handover;
    LiveSwitch m_switch;
    RekeySchedule m_rekeys;
    ReportExchange m_reports;
    PeerPath m_path;
    RecordReceiver m_receiver;
    IntervalLimit m_keepAlives;
    IntervalLimit m_reportRequests;
    FreshnessJudge m_freshness;
    TimePoint m_lastReceived;
    TimePoint m_namedUntil = TimePoint::min();
    bool m_confirmed = false;           ///< an authentic record arrived: the peer is alive and its handshake was not replayed
    bool m_requestedCosts = false;      ///< by the last report that was sent
    std::optional<TimePoint> m_leaveBy; ///< the suite in use is not permitted any more; the session ends then at the latest
    std::optional<TimePoint> m_closingUntil; ///< the peer sent Close; records that it overtook are still accepted until then
    std::optional<DownReason> m_finished;
};

} // namespace skyseal::channel
