#include "core/experiment/sweep_flight.h"

#include "core/engine/station/snapshot.h"
#include "core/engine/station/vehicle_snapshot.h"

#include <algorithm>

namespace skyseal::experiment {

using vehicle::FlightStep;
using vehicle::StepResult;

namespace {

/// Longer than the interval of heartbeats, which say whether a vehicle is armed.
constexpr std::string_view kPause = "sleep 2.5";
constexpr std::string_view kLandingPatience = "180", kDisarmingPatience = "5";

} // namespace

void SweepFlight::beginLeg(unsigned block)
{
    m_block = block;
    m_number = block / m_plan.phases() + 1;
    m_isUp = true;
    run(Part::Leg, m_plan.legs[block % m_plan.phases()]);
}

void SweepFlight::beginLanding()
{
    if (m_plan.legs.back().empty())
        return bringDown();
    run(Part::Landing, m_plan.legs.back());
}

void SweepFlight::bringDown()
{
    // An order to arm may just have been carried out, and the heartbeat that says so is yet to come.
    run(Part::Pausing, vehicle::parseFlightScript(kPause).value());
}

void SweepFlight::run(Part part, std::vector<FlightStep> steps)
{
    if (part <= Part::Pausing)
        m_problem.clear();
    for (FlightStep &step : steps)
        step.systemId = step.systemId ? step.systemId : m_first;
    m_part = part;
    m_failure.clear();
    m_runner.emplace(std::move(steps));
}

/// "1: land; 2: land; 1: wait armed==0 180; 2: wait armed==0 180", for all vehicles that are armed.
void SweepFlight::command(Part part, std::string_view order, std::string_view patience)
{
    std::string orders, waits;
    for (const std::uint8_t id : m_armed) {
        orders.append(std::to_string(id)).append(": ").append(order).append("; ");
        waits.append(std::to_string(id)).append(": wait armed==0 ").append(patience).append("; ");
    }
    run(part, vehicle::parseFlightScript(orders + waits).value());
}

void SweepFlight::advance(TimePoint now, const engine::Snapshot &snapshot)
{
    if (!m_runner)
        return;
    std::vector<const vehicle::VehicleState *> states;
    for (const engine::VehicleSnapshot &one : snapshot.vehicles)
        states.push_back(&one.state);
    if (!m_first && !states.empty())
        m_first = states.front()->systemId; // as the runner does
    m_armed = armedIn(snapshot);
    m_runner->advance(now, states);
    while (const auto report = m_runner->pollReport()) {
        if (report->result == StepResult::Refused || report->result == StepResult::TimedOut)
            m_failure = "'" + report->step + "': " + std::string(vehicle::stepResultName(report->result))
                + (report->reason.empty() ? "" : ", " + report->reason);
    }
    if (m_runner->finished())
        finishPart();
}

void SweepFlight::finishPart()
{
    const Part part = m_part;
    m_runner.reset();
    m_part = Part::None;
    if (!m_failure.empty() && (part == Part::Leg || part == Part::Landing))
        m_problem = inFlight("failed at " + m_failure);
    if (part == Part::Leg) {
        m_inPhase = m_armed;
        return;
    }
    if (m_armed.empty()) {
        m_isUp = false;
        m_inPhase.clear();
        m_block.reset();
    } else if (part == Part::Disarming) {
        m_problem = inFlight("could not be ended, the vehicle is armed" + (m_failure.empty() ? "" : "; " + m_failure));
    } else if (part == Part::BringingDown) {
        command(Part::Disarming, "disarm", kDisarmingPatience);
    } else {
        command(Part::BringingDown, "land", kLandingPatience);
    }
}

void SweepFlight::handleResult(const vehicle::CommandResult &result)
{
    if (m_runner)
        m_runner->handleResult(result);
}

void SweepFlight::handleResult(const vehicle::ParameterResult &result)
{
    if (m_runner)
        m_runner->handleResult(result);
}

std::optional<vehicle::ScriptRequest> SweepFlight::pollRequest()
{
    return m_runner ? m_runner->pollRequest() : std::nullopt;
}

void SweepFlight::requestSent(vehicle::RequestId id)
{
    if (m_runner)
        m_runner->requestSent(id);
}

std::string SweepFlight::endOfPhase(const engine::Snapshot &snapshot) const
{
    const std::set<std::uint8_t> armed = armedIn(snapshot);
    if (!m_isUp || std::ranges::includes(armed, m_inPhase))
        return {};
    return inFlight("ended by itself, the vehicle was disarmed during a run");
}

/// System ids of the vehicles that the script commands.
std::set<std::uint8_t> SweepFlight::flown() const
{
    std::set<std::uint8_t> out;
    for (const auto &leg : m_plan.legs) {
        for (const FlightStep &step : leg) {
            if (const auto id = step.systemId ? step.systemId : m_first)
                out.insert(*id);
        }
    }
    return out;
}

/// A vehicle that is not heard counts as armed, since nobody knows.
std::set<std::uint8_t> SweepFlight::armedIn(const engine::Snapshot &snapshot) const
{
    std::set<std::uint8_t> out = flown();
    for (const engine::VehicleSnapshot &one : snapshot.vehicles) {
        if (!one.state.lost && !one.state.armed)
            out.erase(one.state.systemId);
    }
    return out;
}

std::string SweepFlight::inFlight(const std::string &what) const
{
    return "flight " + std::to_string(m_number) + " " + what;
}

} // namespace skyseal::experiment
