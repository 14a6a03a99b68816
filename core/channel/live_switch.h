// The state machine of a live change of suite or keys (PROTOCOL.md, section 8). It decides; the session acts through
// SwitchActions. No cryptography, no bytes.
//
//   proposer                                   answerer
//   Queued -> Proposed --- Propose --->        prepares read keys of the next epoch
//      commits          <-- Accept ---         Accepted: still sends under the current epoch
//      sends under next --- any record ->      commits, sends under next
//      Confirming       --- Confirm --->
//      settled          <-- Confirmed --       settled
//
// Only the proposer decides. It commits when it receives the Accept, and gives up after switchConfirm; it never sends under an
// epoch that it gave up. The answerer learns the decision from a record under the next epoch (committed) or a newer proposal
// (given up). Until then it keeps the prepared keys, also after it has notified its owner of the failure. Therefore every
// record can be opened, whatever is lost.
#pragma once

#include "core/channel/control.h"
#include "core/channel/events.h"
#include "core/channel/timing.h"

#include <optional>

namespace skyseal::channel {

/// Result of deriving the keys of the next epoch.
enum class NextEpoch : std::uint8_t {
    Prepared, ///< its read keys are installed, in place of others
    NoCipher, ///< this machine lacks the cipher
    Ignored   ///< the peer's key is of small order, or the peer requests too many computations
};

/// Actions and state of the session that its switch needs.
class SwitchActions
{
public:
    virtual ~SwitchActions() = default;
    virtual Epoch currentEpoch() const = 0;
    virtual crypto::SuiteId currentSuite() const = 0;
    virtual bool permittedHere(crypto::SuiteId) const = 0;
    virtual bool permittedByPeer(crypto::SuiteId) const = 0;
    /// Returns true if no more records are expected under the previous epoch, so that its keys may be replaced.
    virtual bool previousDispensable(TimePoint now) const = 0;
    /// Shortest time in which an answer can arrive.
    virtual Duration answerTime() const = 0;
    /// Makes the key pair of a proposal, in place of an earlier one. Returns the public key.
    virtual crypto::PublicKey makeProposalKey() = 0;
    /// The proposal was answered or given up: wipes its private key.
    virtual void dropProposalKey() = 0;
    virtual void send(TimePoint now, const ControlMessage &message) = 0;
    /// Derives the epoch after the current one from the peer's proposal and a fresh key, and sets `answer` to its public key.
    /// Changes nothing unless the result is Prepared.
    virtual NextEpoch answerProposal(TimePoint now, const Propose &message, crypto::PublicKey &answer) = 0;
    /// The same from the answer to this end's proposal.
    virtual NextEpoch takeAnswer(TimePoint now, crypto::SuiteId suite, const crypto::PublicKey &answer) = 0;
    virtual void dropNext() = 0;
    /// The prepared epoch becomes the current one, for sending, too.
    virtual void commitNext(TimePoint now) = 0;
    /// Records sealed under the epoch before the current one; final, since nothing is sealed under it any more.
    virtual std::uint32_t sentBefore() const = 0;
    virtual void peerSentBefore(std::uint32_t records) = 0;
    virtual void notify(const Event &event) = 0;
};

class LiveSwitch
{
public:
    LiveSwitch(SessionId session, bool initiator, const Timing &timing);

    // query
    /// Suite of a switch whose result is open, ours first.
    std::optional<crypto::SuiteId> pending() const;
    TimePoint deadline() const;

    // command
    void request(TimePoint now, crypto::SuiteId suite, bool rekey, SwitchActions &actions);
    /// The session ends: pending switches fail.
    void end(TimePoint now, SwitchActions &actions);

    // input
    /// Ignores messages that do not belong to a switch.
    void handle(TimePoint now, const ControlMessage &message, SwitchActions &actions);
    void handle(TimePoint now, const Propose &message, SwitchActions &actions);
    void handle(TimePoint now, const Accept &message, SwitchActions &actions);
    void handle(TimePoint now, const Refuse &message, SwitchActions &actions);
    void handle(TimePoint now, const Confirm &message, SwitchActions &actions);
    void handle(TimePoint now, const Confirmed &message, SwitchActions &actions);
    /// An authentic record arrived under the prepared epoch. Call before its content is handled.
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
        bool proposed = false; ///< false: waits until the last switch is settled
        crypto::PublicKey key{};
        TimePoint repeatAt{};
    };
    struct Theirs : Switch
    {
        crypto::PublicKey answer{};
        bool failureNotified = false; ///< the owner was notified of a failure, but the proposer may have committed
    };
    struct Confirming
    {
        Epoch epoch{};
        TimePoint since{};
        TimePoint repeatAt{};
    };

    void proposeIfReady(TimePoint now, SwitchActions &actions);
    void accept(TimePoint now, const Propose &message, const crypto::PublicKey &answer, SwitchActions &actions);
    void finishOwn(TimePoint now, SwitchFailure failure, SwitchActions &actions);
    void notifyPending(const Switch &s, bool byPeer, SwitchActions &actions) const;
    void notifyDone(TimePoint now, const Switch &s, bool byPeer, SwitchFailure failure, SwitchActions &actions) const;

    SessionId m_session;
    bool m_initiator;
    Timing m_timing;
    std::uint32_t m_proposals = 0;
    ProposalId m_newestOfPeer{};
    bool m_refusedNewest = false;
    bool m_settled = true; ///< both ends know that the other has moved, and its final record count
    std::optional<Own> m_own;
    std::optional<Theirs> m_theirs;
    std::optional<Confirming> m_confirming;
};

} // namespace skyseal::channel
