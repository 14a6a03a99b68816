#include "core/experiment/flight_driver.h"

#include "core/link/steady_now.h"

namespace skyseal::experiment {

namespace {

constexpr Duration kReopenPatience = std::chrono::seconds(30);
constexpr Duration kSettlePatience = std::chrono::seconds(20);

} // namespace

std::string FlightDriver::endOfPhase() const
{
    return m_link.snapshot() ? m_flight.endOfPhase(*m_link.snapshot()) : std::string();
}

void FlightDriver::enter(Stage stage, Duration patience)
{
    m_stage.enter(stage, patience, now(), m_link.snapshotTime());
    m_link.setSnapshotsPerSecond(LinkDriver::kWatching);
}

/// Without an end of the patience: each step of a flight has a time-out of its own.
void FlightDriver::begin(Stage stage)
{
    m_stage.enterUnlimited(stage);
    m_link.setSnapshotsPerSecond(LinkDriver::kWatching);
}

void FlightDriver::beginLeg(unsigned block)
{
    m_flight.beginLeg(block);
    begin(Stage::Flying);
}

void FlightDriver::beginLanding()
{
    m_flight.beginLanding();
    begin(Stage::Landing);
}

/// Over the link as it is, if the vehicle is heard on it.
void FlightDriver::bringDown()
{
    if (!m_reopened && !m_link.hasVehicle())
        return reopen();
    m_flight.bringDown();
    begin(Stage::Landing);
}

void FlightDriver::handleSnapshot()
{
    switch (m_stage.stage()) {
    case Stage::Flying:
    case Stage::Landing: fly(); break;
    case Stage::Connecting:
        if (m_link.hasVehicle())
            enter(Stage::Settling, kSettlePatience);
        break;
    case Stage::Settling:
        if (m_link.isSettled(m_stage.age(m_link.snapshotTime()), true))
            bringDown();
        break;
    case Stage::Idle:
    case Stage::Reopening: break;
    }
}

void FlightDriver::handleClosed()
{
    if (m_stage.is(Stage::Reopening))
        openFresh();
}

void FlightDriver::handleTimeout()
{
    if (m_stage.isOverdue(now()))
        abandon();
}

void FlightDriver::fly()
{
    m_flight.advance(steadyNow(), *m_link.snapshot());
    while (auto next = m_flight.pollRequest())
        m_flight.requestSent(m_link.station().perform(next->systemId, std::move(next->request)));
    if (!m_flight.isFinished())
        return;
    if (m_stage.is(Stage::Landing))
        return endLanding();
    m_stage.enterUnlimited(Stage::Idle);
    const std::string problem = m_flight.problem(); // the next part clears it
    Q_EMIT legEnded(problem);
}

void FlightDriver::endLanding()
{
    if (const std::string problem = m_flight.problem(); !problem.empty())
        Q_EMIT landingFailed(problem);
    if (m_flight.isUp() && !m_reopened)
        return reopen();
    m_stage.enterUnlimited(Stage::Idle);
    Q_EMIT down();
}

/// The old link may be the reason why the vehicle did not land: its agent ended, its session was lost, its relay is too bad.
void FlightDriver::reopen()
{
    m_stage.enterUnlimited(Stage::Reopening);
    m_link.close();
}

void FlightDriver::openFresh()
{
    m_reopened = true;
    m_lab->start(Load::Natural, Condition{}, m_seed);
    if (const auto opened = m_link.open(engine::Protection::Sealed); !opened)
        return abandon();
    enter(Stage::Connecting, kReopenPatience);
}

void FlightDriver::abandon()
{
    m_stage.enterUnlimited(Stage::Idle);
    Q_EMIT landingFailed("THE VEHICLE MAY STILL FLY: it could not be reached over a new link either");
    Q_EMIT down();
}

} // namespace skyseal::experiment

#include "moc_flight_driver.cpp"
