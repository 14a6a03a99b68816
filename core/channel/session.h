// One session: its epochs, counters, switch, reports and the address where the peer was heard last. It seals and opens;
// everything it has to say by itself goes to the outbox, everything its owner must know to the events.
#pragma once

#include "core/base/random_source.h"
#include "core/channel/cost_source.h"
#include "core/channel/delivery.h"
#include "core/channel/events.h"
#include "core/channel/sealed.h"
#include "core/channel/session_info.h"
#include "core/channel/epochs.h"
#include "core/channel/inline_frame.h"
#include "core/channel/key_chain.h"
#include "core/channel/live_switch.h"
#include "core/channel/negotiation.h"
#include "core/channel/datagram_queue.h"
#include "core/channel/record.h"
#include "core/channel/round_trip.h"

#include <deque>

namespace skyseal::channel {

/// What sessions share with their endpoint; outlives them.
struct Surroundings
{
    RandomSource &random;
    DatagramQueue outbox;
    std::deque<Event> events;
    SuiteOffer offer; ///< what our policy allows now
    Timing timing;
    const MessageTraits *facts = nullptr; ///< null: nothing is sealed in place here
    CostSource costs = {};                ///< empty: we do not measure ourselves
    bool askCosts = false;                ///< of the other end
};

/// What a finished handshake gives.
struct SessionSetup
{
    SessionId id{};
    bool initiator = false;
    Peer peer;
    ConnectionId ours{};   ///< in the records that come to us
    ConnectionId theirs{}; ///< in the records that we send
    SuiteOffer peerOffer;
    crypto::SuiteId suite{};
    KeyChain chain;
    Path path;
};

class Session final : private SwitchActions
{
public:
    Session(SessionSetup setup, Surroundings &around, TimePoint now);

    // query
    SessionId id() const { return m_setup.id; }
    ConnectionId connection() const { return m_setup.ours; }
    const Peer &peer() const { return m_setup.peer; }
    const Path &path() const { return m_setup.path; }
    const Path &origin() const { return m_origin; }
    SessionInfo info(TimePoint now) const;
    SessionStats stats() const;
    TimePoint deadline() const;
    TimePoint lastReceived() const { return m_lastReceived; }
    TimePoint silentFrom() const { return m_lastReceived + m_around.timing.peerSilentAfter; }
    /// A living session is never quiet for so long, unless records were lost. Earlier than silent, and without consequence
    /// for the session: an agent starts to announce itself again.
    TimePoint quietFrom() const { return m_lastReceived + m_around.timing.keepAliveAfter * 3 / 2; }
    bool silent(TimePoint now) const { return now - m_lastReceived >= m_around.timing.peerSilentAfter; }
    /// True once something authentic came: only then is the other end known to be alive and not a replay.
    bool confirmed() const { return m_confirmed; }
    /// False when the ciphers of its first epoch could not be made: to be thrown away at once.
    bool usable() const { return m_epochs.begun(); }
    /// The peer said goodbye.
    bool closing() const { return m_closingUntil.has_value(); }
    /// Set when the session cannot go on.
    std::optional<DownReason> finished() const { return m_finished; }

    // input
    struct Opened
    {
        bool authentic = false;
        bool routine = false; ///< frames under the current epoch and nothing else happened: no timer changed
    };
    /// `delivery`: is given what is for the owner, once, where the owner of the endpoint will have it.
    Opened open(TimePoint now, const Path &from, const RecordHeader &header, MutableByteView datagram,
                std::optional<Delivery> &delivery);
    /// A frame sealed in place; it never moves the address.
    Opened openInline(TimePoint now, const InlineFrame &frame, std::optional<Delivery> &delivery);
    void handleDeadline(TimePoint now);
    void addRoundTrip(Duration sample) { m_roundTrip.add(sample); }
    void countPlaintextDropped(std::uint64_t count) { m_epochs.current().rx.plaintextDropped += count; }
    /// Goes out with the next report.
    void noteFrames(const FrameCounters &frames) { m_frames = frames; }
    void countMalformed() { ++m_epochs.current().rx.malformed; }

    // command
    Sealed seal(TimePoint now, ByteView plaintext, MutableByteView out);
    Sealed sealInline(TimePoint now, ByteView frame, MutableByteView out);
    Framing agreedFraming() const;
    /// How frames are to be sent now.
    Framing framing() const;
    void switchSuite(TimePoint now, crypto::SuiteId suite);
    void rekey(TimePoint now);
    /// In a single-peer carrier: records name their session until then, since another one may be there at the other end.
    void nameRecordsUntil(TimePoint until) { m_namedUntil = until; }
    /// An empty record, for a peer that may have lost us. At most once a second, since what asks for it need not be authentic.
    void showLife(TimePoint now);
    /// The line that we are on was joined anew: a report that asks for an answer, at most once a second, whoever joins it how
    /// often.
    void lineBegan(TimePoint now);
    /// Keys changed in the list of peers: role and name follow.
    void updatePeer(const Peer &peer) { m_setup.peer = peer; }
    void policyChanged(TimePoint now);
    /// Says goodbye when the peer can hear it, and fails what is pending.
    void end(TimePoint now, bool sayGoodbye);

private:
    // SwitchActions
    Epoch currentEpoch() const override { return m_epochs.current().number; }
    crypto::SuiteId currentSuite() const override { return m_epochs.current().suite; }
    bool permittedHere(crypto::SuiteId suite) const override;
    bool permittedByPeer(crypto::SuiteId suite) const override;
    bool previousDispensable(TimePoint now) const override;
    Duration answerTime() const override { return m_roundTrip.smoothed(); }
    EpochNonce freshNonce() override;
    void send(TimePoint now, const ControlMessage &message) override;
    bool prepareNext(crypto::SuiteId suite, const EpochNonce &proposal, const EpochNonce &answer) override;
    void dropNext() override;
    void commitNext(TimePoint now) override;
    std::uint32_t sentBefore() const override { return m_sentBefore; }
    void peerSentBefore(std::uint32_t records) override;
    void notify(const Event &event) override { m_around.events.push_back(event); }

    bool prepare(Epoch number, crypto::SuiteId suite, const EpochNonce &proposal, const EpochNonce &answer);
    Direction ourDirection() const { return m_setup.initiator ? Direction::FromInitiator : Direction::FromResponder; }
    std::vector<crypto::SuiteId> permitted() const;

    bool inlineAllowed() const { return m_inlineAgreed && m_around.offer.allowInline; }
    DatagramKind kindFor(TimePoint now, ByteView plaintext) const;
    bool nothingMissing() const;
    Opened refuse(TimePoint now, std::uint64_t ReceiveCounters::*counter, LiveEpoch &epoch);
    Opened opened(TimePoint now, const Path &from, const RecordHeader &header, LiveEpoch &epoch, MutableByteView plaintext,
                  std::optional<Delivery> &delivery);
    void follow(TimePoint now, const Path &from);
    void goBackWhenDue(TimePoint now);
    void sendControl(TimePoint now, ByteView plaintext);
    void handleControl(TimePoint now, const Path &from, ByteView plaintext);
    void handleReport(TimePoint now, const Path &from, const Report &report);
    void sendReport(TimePoint now, bool answerAtOnce);
    void rekeyWhenDue(TimePoint now);
    /// A session that was only answered is not known to its owner yet.
    bool mayTell() const { return m_confirmed || m_setup.initiator; }
    void tellMove(TimePoint now);
    void alarmWhenDue(TimePoint now);
    Sealed sealRecord(TimePoint now, ByteView plaintext, MutableByteView out);
    std::uint32_t stamp(TimePoint now) const;

    SessionSetup m_setup;
    Surroundings &m_around;
    Path m_origin;
    Epochs m_epochs;
    KeyChain m_chain; ///< for the epoch after the current one
    std::optional<KeyChain> m_chainAfterNext;
    LiveSwitch m_switch;
    RoundTrip m_roundTrip;
    std::optional<DownReason> m_finished;
    std::optional<TimePoint> m_closingUntil; ///< the peer said goodbye; what it overtook is still taken
    bool m_confirmed = false;
    bool m_inlineAgreed; ///< both ends said in the handshake that they allow it

    TimePoint m_namedUntil = TimePoint::min();
    TimePoint m_since;
    TimePoint m_lastReceived;
    TimePoint m_lastSent;
    TimePoint m_reportDue;
    TimePoint m_epochSince;
    TimePoint m_rekeyNotBefore;
    std::optional<TimePoint> m_leaveBy;     ///< the suite in use is no longer permitted; it ends then at the latest
    std::optional<TimePoint> m_peerMovedOn; ///< since when the peer sends under the current epoch; none = not yet
    bool m_previousComplete = false;        ///< the peer has said how many records the previous epoch had
    std::uint32_t m_sentBefore = 0;

    std::optional<FrameCounters> m_frames; ///< as our owner counts them
    std::optional<Report> m_peerReport;
    TimePoint m_peerReportAt;

    Path m_toldPath; ///< the path that the owner knows
    TimePoint m_moveNotified;
    std::uint64_t m_forgedPending = 0;
    std::uint64_t m_replayedPending = 0;
    TimePoint m_alarmNotified;
    TimePoint m_lifeShown, m_lineBegan;

    std::optional<Path> m_former;   ///< where the peer was known to hear us; set while the present path is on trial
    std::uint32_t m_trialStamp = 0; ///< a report that echoes a later one has heard us at the present path
    TimePoint m_heardHere;          ///< the newest record from the present path
};

} // namespace skyseal::channel
