#include "core/channel/live_switch.h"

#include <algorithm>

namespace skyseal::channel {

namespace {

Epoch after(Epoch epoch)
{
    return Epoch{static_cast<std::uint32_t>(epoch) + 1};
}

} // namespace

LiveSwitch::LiveSwitch(SessionId session, bool initiator, const Timing &timing)
    : m_session(session), m_initiator(initiator), m_timing(timing)
{}

std::optional<crypto::SuiteId> LiveSwitch::pending() const
{
    if (m_own)
        return m_own->to;
    if (m_theirs && !m_theirs->failureNotified)
        return m_theirs->to;
    return std::nullopt;
}

TimePoint LiveSwitch::deadline() const
{
    TimePoint due = kNever;
    if (m_own)
        due = std::min({due, m_own->repeatAt, m_own->since + m_timing.switchConfirm});
    if (m_theirs && !m_theirs->failureNotified)
        due = std::min(due, m_theirs->since + m_timing.switchConfirm);
    if (m_confirming)
        due = std::min(due, m_confirming->repeatAt);
    return due;
}

void LiveSwitch::request(TimePoint now, crypto::SuiteId suite, bool rekey, SwitchActions &actions)
{
    if (m_own)
        finishOwn(now, SwitchFailure::Superseded, actions);
    Own own;
    own.id = ProposalId{++m_proposals};
    own.from = actions.currentSuite();
    own.to = suite;
    own.epoch = after(actions.currentEpoch());
    own.rekey = rekey;
    own.since = now;
    own.repeatAt = now;
    m_own = own;
    notifyPending(own, false, actions);
    if (!actions.permittedHere(suite))
        return finishOwn(now, SwitchFailure::NotAllowedHere, actions);
    if (!actions.permittedByPeer(suite))
        return finishOwn(now, SwitchFailure::NotAllowedByPeer, actions);
    proposeIfReady(now, actions);
}

void LiveSwitch::proposeIfReady(TimePoint now, SwitchActions &actions)
{
    const bool peersTurn = m_theirs && !m_theirs->failureNotified;
    if (!m_own->proposed && (!m_settled || peersTurn || !actions.previousDispensable(now))) {
        m_own->repeatAt = now + m_timing.switchRetry;
        return;
    }
    if (!m_own->proposed) {
        m_own->proposed = true;
        m_own->from = actions.currentSuite();
        m_own->epoch = after(actions.currentEpoch());
        m_own->key = actions.makeProposalKey();
    }
    m_own->repeatAt = now + std::max(m_timing.switchRetry, actions.answerTime());
    actions.send(now, Propose{m_own->id, m_own->epoch, m_own->to, m_own->key});
}

void LiveSwitch::handle(TimePoint now, const ControlMessage &message, SwitchActions &actions)
{
    std::visit(
        [&](const auto &one) {
            using Message = std::decay_t<decltype(one)>;
            if constexpr (!std::is_same_v<Message, Report> && !std::is_same_v<Message, Close>)
                handle(now, one, actions);
        },
        message);
}

void LiveSwitch::handle(TimePoint now, const Propose &message, SwitchActions &actions)
{
    if (message.id < m_newestOfPeer || message.epoch != after(actions.currentEpoch()))
        return;
    if (message.id == m_newestOfPeer) {
        if (m_refusedNewest)
            actions.send(now, Refuse{message.id});
        else if (m_theirs && m_theirs->id == message.id)
            actions.send(now, Accept{message.id, m_theirs->answer});
        return;
    }
    // Crossing proposals: the initiator's is valid, so it does not answer the responder's.
    if (m_own && m_own->proposed && m_initiator)
        return;
    const bool allowed = actions.permittedHere(message.suite);
    if (allowed && (!m_settled || !actions.previousDispensable(now)))
        return; // The peer repeats it until the last switch is settled.

    crypto::PublicKey answer{};
    const NextEpoch next = allowed ? actions.answerProposal(now, message, answer) : NextEpoch::NoCipher;
    if (next == NextEpoch::Ignored)
        return;
    m_newestOfPeer = message.id;
    m_refusedNewest = next == NextEpoch::NoCipher;
    if (m_own && m_own->proposed)
        finishOwn(now, SwitchFailure::Superseded, actions);
    if (m_theirs) { // The peer has given it up, or it would not propose the same epoch again.
        if (!m_theirs->failureNotified)
            notifyDone(now, *m_theirs, true, SwitchFailure::Superseded, actions);
        m_theirs.reset();
        if (m_refusedNewest)
            actions.dropNext();
    }
    if (m_refusedNewest)
        actions.send(now, Refuse{message.id});
    else
        accept(now, message, answer, actions);
}

void LiveSwitch::accept(TimePoint now, const Propose &message, const crypto::PublicKey &answer, SwitchActions &actions)
{
    Theirs theirs;
    theirs.id = message.id;
    theirs.from = actions.currentSuite();
    theirs.to = message.suite;
    theirs.epoch = message.epoch;
    theirs.rekey = theirs.from == theirs.to;
    theirs.since = now;
    theirs.answer = answer;
    m_theirs = theirs;
    notifyPending(theirs, true, actions);
    actions.send(now, Accept{message.id, theirs.answer});
}

void LiveSwitch::handle(TimePoint now, const Accept &message, SwitchActions &actions)
{
    if (!m_own || !m_own->proposed || m_own->id != message.id)
        return;
    const NextEpoch next = actions.takeAnswer(now, m_own->to, message.key);
    if (next == NextEpoch::Ignored)
        return;
    // The peer has given up its own proposal: it would not have accepted ours if it had committed.
    m_theirs.reset();
    if (next == NextEpoch::NoCipher) {
        actions.dropNext();
        return finishOwn(now, SwitchFailure::NotAllowedHere, actions);
    }
    actions.commitNext(now);
    m_settled = false;
    m_confirming = Confirming{m_own->epoch, now, now + std::max(m_timing.switchRetry, actions.answerTime())};
    actions.send(now, Confirm{m_own->epoch, actions.sentBefore()});
    finishOwn(now, SwitchFailure::None, actions);
}

void LiveSwitch::handle(TimePoint now, const Refuse &message, SwitchActions &actions)
{
    if (m_own && m_own->proposed && m_own->id == message.id)
        finishOwn(now, SwitchFailure::NotAllowedByPeer, actions);
}

void LiveSwitch::handleRecordUnderNext(TimePoint now, SwitchActions &actions)
{
    if (!m_theirs)
        return;
    const Theirs theirs = *m_theirs;
    m_theirs.reset();
    actions.commitNext(now);
    m_settled = false;
    if (theirs.failureNotified)
        notifyPending(theirs, true, actions);
    notifyDone(now, theirs, true, SwitchFailure::None, actions);
    if (m_own && m_own->proposed)
        finishOwn(now, SwitchFailure::Superseded, actions);
}

void LiveSwitch::handle(TimePoint now, const Confirm &message, SwitchActions &actions)
{
    if (message.epoch != actions.currentEpoch() || m_confirming)
        return;
    if (!m_settled)
        actions.peerSentBefore(message.sentBefore);
    m_settled = true;
    actions.send(now, Confirmed{message.epoch, actions.sentBefore()});
}

void LiveSwitch::handle(TimePoint, const Confirmed &message, SwitchActions &actions)
{
    if (!m_confirming || message.epoch != m_confirming->epoch)
        return;
    actions.peerSentBefore(message.sentBefore);
    m_confirming.reset();
    m_settled = true;
}

void LiveSwitch::handleDeadline(TimePoint now, SwitchActions &actions)
{
    if (m_confirming && now >= m_confirming->repeatAt) {
        const bool fresh = now - m_confirming->since < m_timing.switchConfirm;
        const Duration pause = fresh ? m_timing.switchRetry : m_timing.keepAliveAfter;
        m_confirming->repeatAt = now + std::max(pause, actions.answerTime());
        actions.send(now, Confirm{m_confirming->epoch, actions.sentBefore()});
    }
    if (m_theirs && !m_theirs->failureNotified && now >= m_theirs->since + m_timing.switchConfirm) {
        m_theirs->failureNotified = true;
        notifyDone(now, *m_theirs, true, SwitchFailure::NotConfirmed, actions);
    }
    if (m_own && now >= m_own->since + m_timing.switchConfirm)
        finishOwn(now, SwitchFailure::NotConfirmed, actions);
    else if (m_own && now >= m_own->repeatAt)
        proposeIfReady(now, actions);
}

void LiveSwitch::end(TimePoint now, SwitchActions &actions)
{
    if (m_own)
        finishOwn(now, SwitchFailure::SessionEnded, actions);
    if (m_theirs && !m_theirs->failureNotified)
        notifyDone(now, *m_theirs, true, SwitchFailure::SessionEnded, actions);
    m_theirs.reset();
    m_confirming.reset();
}

void LiveSwitch::finishOwn(TimePoint now, SwitchFailure failure, SwitchActions &actions)
{
    const Own own = *m_own;
    m_own.reset();
    actions.dropProposalKey();
    notifyDone(now, own, false, failure, actions);
}

void LiveSwitch::notifyPending(const Switch &s, bool byPeer, SwitchActions &actions) const
{
    actions.notify(SwitchPending{m_session, s.from, s.to, s.epoch, byPeer, s.rekey});
}

void LiveSwitch::notifyDone(TimePoint now, const Switch &s, bool byPeer, SwitchFailure failure, SwitchActions &actions) const
{
    actions.notify(SwitchDone{m_session, s.from, s.to, s.epoch, byPeer, s.rekey, failure, now - s.since});
}

} // namespace skyseal::channel
