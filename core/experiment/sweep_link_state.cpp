// The part of SweepRunner that brings the link into the state that a run asks for, over lost links and new sessions, and in
// the end back into the one that it had.
#include "core/experiment/sweep_runner.h"

#include <algorithm>

namespace skyseal::experiment {

namespace {

using engine::Protection;

constexpr Duration kSwitchPatience = std::chrono::seconds(15);
constexpr unsigned kMostSwitches = 8; ///< where a full queue takes the time that a switch has, about every other one fails
constexpr Duration kRestorePatience = std::chrono::seconds(6); ///< a switch is confirmed or rolled back within five

/// Whether both ends make a new session on the way from one to the other.
bool renews(std::optional<Protection> from, std::optional<Protection> to)
{
    const auto kind = [](std::optional<Protection> one) { return one.value_or(Protection::Sealed); };
    return kind(from) != kind(to);
}

} // namespace

Protection SweepRunner::wantedProtection() const
{
    const SweepArm &arm = m_config.plan.arms[run().arm];
    if (arm.suite == crypto::SuiteId::None)
        return Protection::Plain;
    return arm.framing == channel::Framing::Inline ? Protection::Inline : Protection::Sealed;
}

/// Decides, on a link that works, what the run still lacks.
void SweepRunner::connectUp(const engine::Snapshot &snapshot)
{
    const engine::SessionSnapshot *up = session(snapshot);
    if (up) {
        const auto &offered = up->info.peerOffered;
        m_plainRefused = std::find(offered.begin(), offered.end(), crypto::SuiteId::None) == offered.end();
        m_inlineRefused = m_inlineRefused || (m_protection == Protection::Inline && m_framing != channel::Framing::Inline);
    }
    if (wantedProtection() == Protection::Plain && m_plainRefused)
        return refuseRun("the other end does not allow plain MAVLink");
    if (wantedProtection() == Protection::Inline && m_inlineRefused)
        return refuseRun("the other end does not allow inline framing");
    if (m_protection == wantedProtection())
        return beginSwitching(snapshot);
    protect(wantedProtection());
    enter(Stage::Connecting, kConnectPatience);
}

void SweepRunner::protect(std::optional<Protection> protection)
{
    const engine::SessionSnapshot *up = m_snapshot ? session(*m_snapshot) : nullptr;
    if (up && renews(m_protection, protection))
        m_ended = up->info.session;
    m_tripsBefore = m_snapshot ? tripsOf(*m_snapshot) : 0;
    m_protection = protection;
    m_station->holdSuite(std::nullopt); // of the run before; this one's is switched to, since that is measured as well
    m_station->setProtection(protection);
}

void SweepRunner::beginSwitching(const engine::Snapshot &snapshot)
{
    if (!isPlain())
        m_station->holdSuite(wantedSuite());
    enter(Stage::Switching, kSwitchPatience);
    switchSuite(snapshot);
}

void SweepRunner::switchSuite(const engine::Snapshot &snapshot)
{
    const engine::SessionSnapshot *up = session(snapshot);
    if (isUnderWantedSuite(snapshot))
        enter(Stage::WarmingUp, m_config.plan.warmUp + kConnectPatience);
    else if (up && !up->info.pending)
        order(up->info.session, wantedSuite());
}

/// Once for each session: another one is there after the link was lost.
void SweepRunner::order(channel::SessionId session, crypto::SuiteId suite)
{
    if (m_switchOrdered == session)
        return;
    m_switchOrdered = session;
    if (m_orders++ == 0)
        m_firstOrder.start();
    m_station->switchSuite(session, suite);
}

bool SweepRunner::isUnderWantedSuite(const engine::Snapshot &snapshot) const
{
    const engine::SessionSnapshot *up = session(snapshot);
    return isPlain() || (up && up->info.suite == wantedSuite() && up->info.pending.value_or(wantedSuite()) == wantedSuite());
}

/// Than the one that the run began with; one that is silent for a moment is not.
bool SweepRunner::isAnotherSession(const engine::Snapshot &snapshot) const
{
    const engine::SessionSnapshot *up = session(snapshot);
    return !isPlain() && up && up->info.session != m_session;
}

void SweepRunner::hearSwitch(const channel::SwitchDone &done)
{
    using Failure = channel::SwitchFailure;
    if (done.rekey)
        return;
    if (m_stage == Stage::Measuring && done.failure == Failure::None)
        return endRun("another suite came into use during the run");
    if (m_stage != Stage::Switching || done.to != wantedSuite())
        return;
    if (done.failure == Failure::None) {
        m_switchTook = 1000 * tookOf(done);
        m_orders = 0; // a new session may need one of its own
        return;
    }
    if (done.failure == Failure::NotAllowedHere || done.failure == Failure::NotAllowedByPeer)
        return endRun("the other end did not take this suite");
    if (done.failure == Failure::SessionEnded)
        return;
    m_switchOrdered.reset(); // the link may be gone for a while; as long as there is patience, once more
    if (!session(*m_snapshot))
        return;
    if (++m_switchesFailed < kMostSwitches)
        return enter(Stage::Switching, kSwitchPatience); // it is not gone, only slow
    const std::string why = done.failure == Failure::NotConfirmed ? "the switch was not confirmed in time, "
                                                                  : "another switch took the place of this one, ";
    endRun(why + std::to_string(kMostSwitches) + " times");
}

/// Seconds, from the run's first order on: one that was not confirmed is part of what the switch took.
double SweepRunner::tookOf(const channel::SwitchDone &done) const
{
    const bool again = m_orders > 1 || m_switchOrdered != done.session;
    const double sinceOrder = m_orders > 0 ? static_cast<double>(m_firstOrder.nsecsElapsed()) / 1e9 : 0;
    return again ? std::max(sinceOrder, seconds(done.took)) : seconds(done.took);
}

void SweepRunner::restore()
{
    if (!m_station)
        return end();
    if (m_own && (isPlain() || !m_snapshot || !session(*m_snapshot)))
        return closeStation();
    if (!m_firstSuite)
        return closeStation();
    m_switchOrdered.reset();
    if (!m_own)
        protect(std::nullopt);
    m_station->holdSuite(m_firstSuite);
    enter(Stage::Restoring, kRestorePatience);
    putBack(*m_snapshot);
}

/// The suite that the link had, on a session of the kind that it had.
void SweepRunner::putBack(const engine::Snapshot &snapshot)
{
    const engine::SessionSnapshot *up = session(snapshot);
    if (!up && m_own)
        return closeStation();
    if (!up || up->info.pending)
        return;
    if (up->info.suite == *m_firstSuite)
        return closeStation();
    order(up->info.session, *m_firstSuite);
}

/// The borrowed station as it was. Where its session is not back yet, it begins with the suite that the link had.
void SweepRunner::giveBack()
{
    const engine::SessionSnapshot *up = m_snapshot ? session(*m_snapshot) : nullptr;
    const bool back = up && m_protection != Protection::Plain && up->info.suite == m_firstSuite && !up->info.pending;
    m_station->holdSuite(std::nullopt);
    m_station->setProtection(std::nullopt);
    if (!back && m_firstSuite)
        m_station->resumeSuite(*m_firstSuite);
    m_station->setMeasuring(false);
    disconnect(m_station, nullptr, this, nullptr);
    m_station = nullptr;
}

} // namespace skyseal::experiment
