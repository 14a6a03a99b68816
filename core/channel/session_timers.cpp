// What a session does when time passes, and what it tells about itself.
#include "core/channel/session.h"

#include "core/base/weakness.h"

#include <algorithm>

namespace skyseal::channel {

namespace {

constexpr Duration kEventPause = std::chrono::seconds(1);

} // namespace

TimePoint Session::deadline() const
{
    if (m_finished)
        return TimePoint::min();
    const Timing &timing = m_around.timing;
    TimePoint due = std::min({m_reportDue, m_switch.deadline(), m_lastReceived + timing.forgetAfter});
    if (m_leaveBy)
        due = std::min(due, *m_leaveBy);
    if (m_closingUntil)
        due = std::min(due, *m_closingUntil);
    if (m_epochs.previous() && m_peerMovedOn)
        due = std::min(due, *m_peerMovedOn + std::max(timing.oldKeysLinger, m_roundTrip.generous()));
    if (m_toldPath != m_setup.path)
        due = std::min(due, m_moveNotified + kEventPause);
    if (m_former)
        due = std::min(due, m_heardHere + timing.peerSilentAfter);
    if (m_forgedPending > 0 && mayTell())
        due = std::min(due, m_alarmNotified + kEventPause);
    return due;
}

void Session::handleDeadline(TimePoint now)
{
    const Timing &timing = m_around.timing;
    if (m_finished)
        return;
    if (now >= m_lastReceived + timing.forgetAfter) {
        m_finished = DownReason::TimedOut;
        return;
    }
    if (m_leaveBy && now >= *m_leaveBy) {
        m_leaveBy.reset();
        if (!permittedHere(currentSuite())) {
            m_finished = DownReason::Closed;
            return;
        }
    }
    if (m_closingUntil && now >= *m_closingUntil) {
        m_finished = DownReason::PeerClosed;
        return;
    }
    if (m_epochs.previous() && m_peerMovedOn && now >= *m_peerMovedOn + std::max(timing.oldKeysLinger, m_roundTrip.generous()))
        m_epochs.retirePrevious();
    m_switch.handleDeadline(now, *this);
    rekeyWhenDue(now);
    if (now >= m_reportDue) {
        // Quicker until both ends are sure of each other and know the round trip, by which a switch is timed.
        const bool calm = m_confirmed && m_roundTrip.settled();
        m_reportDue = now + (calm ? std::min(timing.statsEvery, timing.keepAliveAfter) : timing.handshakeRetry);
        sendReport(now, !m_confirmed);
    }
    goBackWhenDue(now);
    if (m_toldPath != m_setup.path && now >= m_moveNotified + kEventPause)
        tellMove(now);
    alarmWhenDue(now);
}

/// Nothing more came from where one record did, and nobody there has heard us.
void Session::goBackWhenDue(TimePoint now)
{
    if (!m_former || now < m_heardHere + m_around.timing.peerSilentAfter)
        return;
    if (!weakened(Weakness::NoTrial))
        m_setup.path = *m_former;
    m_former.reset();
}

void Session::showLife(TimePoint now)
{
    if (now < m_lifeShown + kEventPause || m_closingUntil)
        return;
    m_lifeShown = now;
    sendControl(now, {});
}

void Session::lineBegan(TimePoint now)
{
    if (now < m_lineBegan + kEventPause)
        return; // The next report says it soon enough.
    m_lineBegan = now;
    sendReport(now, true);
}

void Session::tellMove(TimePoint now)
{
    if (now < m_moveNotified + kEventPause)
        return;
    notify(PeerMoved{id(), m_toldPath, m_setup.path});
    m_toldPath = m_setup.path;
    m_moveNotified = now;
}

void Session::alarmWhenDue(TimePoint now)
{
    if (m_forgedPending == 0 || !mayTell() || now < m_alarmNotified + kEventPause)
        return;
    notify(ForgeryAlarm{id(), m_forgedPending, m_replayedPending});
    m_forgedPending = 0;
    m_replayedPending = 0;
    m_alarmNotified = now;
}

void Session::end(TimePoint now, bool sayGoodbye)
{
    m_switch.end(now, *this);
    if (sayGoodbye)
        send(now, Close{});
}

SessionInfo Session::info(TimePoint now) const
{
    SessionInfo info;
    info.session = id();
    info.peer = m_setup.peer.key;
    info.peerName = m_setup.peer.name;
    info.role = m_setup.peer.role;
    info.path = m_setup.path;
    info.suite = currentSuite();
    info.epoch = currentEpoch();
    info.framing = framing();
    info.pending = m_switch.pending();
    info.permitted = permitted();
    info.peerOffered = m_setup.peerOffer.suites;
    if (m_setup.peerOffer.allowPlain)
        info.peerOffered.push_back(crypto::SuiteId::None);
    info.silent = silent(now);
    info.since = m_since;
    info.lastReceived = m_lastReceived;
    return info;
}

SessionStats Session::stats() const
{
    SessionStats stats;
    stats.rx = m_epochs.received();
    stats.tx = m_epochs.sent();
    stats.epochs = m_epochs.history();
    stats.roundTrip = m_roundTrip.smoothed();
    if (m_peerReport) {
        stats.peerReported = true;
        stats.peerRx = m_peerReport->rx;
        stats.peerTx = m_peerReport->tx;
        stats.peerFrames = m_peerReport->frames;
        stats.peerCosts = m_peerReport->costs;
        stats.peerStamp = m_peerReport->stamp;
    }
    return stats;
}

} // namespace skyseal::channel
