// The flights of a sweep: when SweepRunner flies to a phase, lands, and brings the vehicle down before it ends, and over which
// link. SweepFlight knows how.
#include "core/experiment/sweep_runner.h"

#include "core/engine/station/snapshot.h"
#include "core/engine/station/vehicle_snapshot.h"
#include "core/link/steady_now.h"

namespace skyseal::experiment {

namespace {

constexpr Duration kReopenPatience = std::chrono::seconds(30);
/// Each step of a flight has a time-out of its own, so this is never reached.
constexpr Duration kFlightPatience = std::chrono::hours(1000);

} // namespace

void SweepRunner::beginLeg()
{
    m_flight.beginLeg(m_queue.current().repeat);
    enter(SweepStage::Flying, kFlightPatience);
}

void SweepRunner::beginLanding()
{
    m_flight.beginLanding();
    enter(SweepStage::Landing, kFlightPatience);
}

/// Over the link as it is, if the vehicle is heard on it.
void SweepRunner::bringDown()
{
    if (!m_reopened && !(m_snapshot && m_link.hasVehicle(*m_snapshot)))
        return reopen();
    m_flight.bringDown();
    enter(SweepStage::Landing, kFlightPatience);
}

void SweepRunner::fly()
{
    m_flight.advance(steadyNow(), *m_snapshot);
    sendFlightRequests();
    if (!m_flight.isFinished())
        return;
    if (m_stage.is(SweepStage::Landing))
        return endLanding();
    if (m_flight.problem().empty())
        prepareLink();
    else
        failFlight(m_flight.problem());
}

void SweepRunner::sendFlightRequests()
{
    while (auto next = m_flight.pollRequest())
        m_flight.requestSent(m_station.perform(next->systemId, std::move(next->request)));
}

/// The run for which the vehicle flew is listed with the reason.
void SweepRunner::failFlight(const std::string &problem)
{
    Sample sample = sampleOfRun();
    sample.problem = problem;
    record(sample);
    giveUp(problem);
}

void SweepRunner::endLanding()
{
    const std::string &problem = m_flight.problem();
    if (!problem.empty() && m_problem.find(problem) == std::string::npos)
        m_problem += (m_problem.empty() ? "" : "; ") + problem;
    if (m_flight.isUp() && !m_reopened)
        return reopen();
    if (isEnding())
        restoreLink();
    else
        beginNextRun();
}

/// The old link may be the reason why the vehicle did not land: its agent ended, its session was lost, its relay is too bad.
void SweepRunner::reopen()
{
    m_reopens = true;
    closeStation();
}

void SweepRunner::openForLanding()
{
    m_reopens = false;
    m_reopened = true;
    m_config.lab->start(Load::Natural, Condition{}, m_config.plan.seed);
    m_snapshot.reset();
    m_fresh = true;
    m_link.stationOpened();
    m_link.setProtection(engine::Protection::Sealed, nullptr);
    if (const auto opened = m_station.open(engine::Protection::Sealed); !opened)
        return abandonFlight();
    enter(SweepStage::Connecting, kReopenPatience);
}

void SweepRunner::abandonFlight()
{
    m_problem += "; THE VEHICLE MAY STILL FLY: it could not be reached over a new link either";
    restoreLink();
}

void SweepRunner::nameSource()
{
    if (m_config.lab)
        m_results.source = m_config.lab->sourceText();
    else
        m_results.source = m_config.link ? "the vehicle on " + m_config.link->toText() : "the vehicle of the connected station";
    if (m_config.lab && !m_config.lab->vehicle())
        return; // it only claims to be of a firmware
    for (const engine::VehicleSnapshot &one : m_snapshot->vehicles) {
        if (!one.state.lost && !one.state.firmware.empty())
            m_results.source += "; system " + std::to_string(one.state.systemId) + " is " + one.state.firmware;
    }
}

} // namespace skyseal::experiment
