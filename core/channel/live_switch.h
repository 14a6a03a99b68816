// The state machine of a live change of suite or keys. No cryptography, no bytes: it decides, SwitchActions acts.
//
//   proposer                                   answerer
//   Queued -> Proposed --- Propose --->        prepares read keys of the next epoch
//      commits          <-- Accept ---         Accepted: still sends under the current epoch
//      sends under next --- any record ->      commits, sends under next
//      Confirming       --- Confirm --->
//      settled          <-- Confirmed --       settled
//
// Only the proposer decides. It has committed once it took the Accept, and has given up once switchConfirm is over; it
// never sends under an epoch that it gave up. The answerer cannot know which until it sees a record under the
// next epoch (committed) or a newer proposal (given up), so it keeps the prepared keys even after it has told its owner that
// nothing came of it. Hence no record is ever undecipherable, whatever is lost.
#pragma once

#include "core/channel/control.h"
#include "core/channel/events.h"
#include "core/channel/timing.h"

#include <optional>

namespace skyseal::channel {

/// What the session does for its switch.
class SwitchActions
{
public:
    virtual ~SwitchActions() = default;
    virtual Epoch currentEpoch() const = 0;
    virtual crypto::SuiteId currentSuite() const = 0;
    virtual bool permittedHere(crypto::SuiteId) const = 0;
    virtual bool permittedByPeer(crypto::SuiteId) const = 0;
    /// Nothing more is to be expected under the previous epoch, so that a new one may take its place.
    virtual bool previousDispensable(TimePoint now) const = 0;
    /// How long an answer takes to come at the least.
    virtual Duration answerTime() const = 0;
    virtual EpochNonce freshNonce() = 0;
    virtual void send(TimePoint now, const ControlMessage &message) = 0;
    /// Makes the keys of the epoch after the current one and installs those for reading; replaces prepared ones.
    /// False when this machine cannot make them; then nothing has changed.
    virtual bool prepareNext(crypto::SuiteId suite, const EpochNonce &proposal, const EpochNonce &answer) = 0;
    virtual void dropNext() = 0;
    /// The prepared epoch becomes the current one, for sending too.
    virtual void commitNext(TimePoint now) = 0;
    /// Records sealed under the epoch before the current one: final, since nothing is sent under it any more.
    virtual std::uint32_t sentBefore() const = 0;
    virtual void peerSentBefore(std::uint32_t records) = 0;
    virtual void notify(const Event &event) = 0;
};

class LiveSwitch
{
public:
    LiveSwitch(SessionId session, bool initiator, const Timing &timing);

    // query
    /// The suite of a switch whose result has not been told yet, ours first.
    std::optional<crypto::SuiteId> pending() const;
    TimePoint deadline() const;

    // command
    void request(TimePoint now, crypto::SuiteId suite, bool rekey, SwitchActions &actions);
    /// The session ends: what is pending is told as failed.
    void end(TimePoint now, SwitchActions &actions);

    // input
    void handle(TimePoint now, const Propose &message, SwitchActions &actions);
    void handle(TimePoint now, const Accept &message, SwitchActions &actions);
    void handle(TimePoint now, const Refuse &message, SwitchActions &actions);
    void handle(TimePoint now, const Confirm &message, SwitchActions &actions);
    void handle(TimePoint now, const Confirmed &message, SwitchActions &actions);
    /// An authentic record came under the prepared epoch; to be called before its content is looked at.
    void handleRecordUnderNext(TimePoint now, SwitchActions &actions);
    void handleDeadline(TimePoint now, SwitchActions &actions);

private:
    struct Switch
    {
        ProposalId id{};
        crypto::SuiteId from{};
        crypto::SuiteId to{};
        Epoch epoch{};
        bool rekey = false;
        TimePoint since{};
    };
    struct Own : Switch
    {
        bool proposed = false; ///< otherwise it waits until the last switch is settled
        EpochNonce nonce{};
        TimePoint repeatAt{};
    };
    struct Theirs : Switch
    {
        EpochNonce answer{};
        bool toldFailed = false; ///< the owner was told so, but the proposer may have committed
    };
    struct Confirming
    {
        Epoch epoch{};
        TimePoint since{};
        TimePoint repeatAt{};
    };

    void proposeIfReady(TimePoint now, SwitchActions &actions);
    void accept(TimePoint now, const Propose &message, SwitchActions &actions);
    void finishOwn(TimePoint now, SwitchFailure failure, SwitchActions &actions);
    void tellPending(const Switch &s, bool byPeer, SwitchActions &actions) const;
    void tellDone(TimePoint now, const Switch &s, bool byPeer, SwitchFailure failure, SwitchActions &actions) const;

    SessionId m_session;
    bool m_initiator;
    Timing m_timing;
    std::uint32_t m_proposals = 0;
    ProposalId m_newestOfPeer{};
    bool m_refusedNewest = false;
    bool m_settled = true; ///< both ends know that the other one moved, and how many records came before
    std::optional<Own> m_own;
    std::optional<Theirs> m_theirs;
    std::optional<Confirming> m_confirming;
};

} // namespace skyseal::channel
