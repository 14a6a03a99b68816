#include "core/vehicle/flight_script_runner.h"

#include "core/base/number_text.h"

namespace skyseal::vehicle {

namespace {

std::string describe(const StateField &field, const VehicleState &state)
{
    if (field.kind == StateField::Kind::Text)
        return std::string(field.name) + " is " + (field.text(state).empty() ? "not known" : field.text(state));
    const double value = field.number(state);
    return std::string(field.name) + (std::isnan(value) ? " is not known" : " is " + shortNumber(value));
}

} // namespace

std::string_view stepResultName(StepResult result)
{
    switch (result) {
    case StepResult::Accepted: return "accepted";
    case StepResult::Refused: return "refused";
    case StepResult::TimedOut: return "timeout";
    case StepResult::Reached: return "reached";
    }
    return "refused";
}

void FlightScriptRunner::advance(TimePoint now, std::span<const VehicleState *const> vehicles)
{
    if (m_resultArrived) {
        m_resultArrived = false;
        m_settled = now + kSettleTime;
    }
    // After a step that ends without a request, the next one begins in the same call.
    for (std::size_t before = m_steps.size() + 1; !finished() && before != m_index;) {
        before = m_index;
        const VehicleState *vehicle = pickVehicle(vehicles);
        if (m_phase == Phase::Idle) {
            m_phase = Phase::WaitingForVehicle;
            m_stepSystem = 0;
            m_deadline = now + kVehicleTimeout;
        }
        if (m_phase == Phase::WaitingForVehicle) {
            if (vehicle)
                begin(now, *vehicle);
            else if (now >= m_deadline)
                end(StepResult::TimedOut, "no such vehicle was heard");
        }
        if (m_phase == Phase::WaitingForState && vehicle)
            watch(now, *vehicle, std::get<WaitUntil>(m_steps[m_index].action));
        else if (m_phase == Phase::Sleeping && now >= m_deadline)
            end(StepResult::Reached);
        else if (m_phase == Phase::WaitingForResult && now >= m_deadline)
            end(StepResult::TimedOut, "no answer");
    }
}

void FlightScriptRunner::handleResult(const CommandResult &result)
{
    if (m_phase != Phase::WaitingForResult || m_awaited != result.id)
        return;
    switch (result.outcome) {
    case CommandOutcome::Accepted: return end(StepResult::Accepted, result.reason.text());
    case CommandOutcome::Refused: return end(StepResult::Refused, result.reason.text());
    case CommandOutcome::TimedOut: return end(StepResult::TimedOut, result.reason.text());
    }
}

void FlightScriptRunner::handleResult(const ParameterResult &result)
{
    if (m_phase == Phase::WaitingForResult && m_awaited == result.id)
        end(result.ok ? StepResult::Accepted : StepResult::Refused, result.reason.text());
}

std::optional<ScriptRequest> FlightScriptRunner::pollRequest()
{
    return std::exchange(m_request, std::nullopt);
}

void FlightScriptRunner::requestSent(RequestId id)
{
    m_awaited = id;
}

std::optional<StepReport> FlightScriptRunner::pollReport()
{
    if (m_reports.empty())
        return std::nullopt;
    StepReport report = std::move(m_reports.front());
    m_reports.pop_front();
    return report;
}

const VehicleState *FlightScriptRunner::pickVehicle(std::span<const VehicleState *const> vehicles)
{
    if (m_firstSystem == 0 && !vehicles.empty())
        m_firstSystem = vehicles.front()->systemId;
    const std::uint8_t wanted = m_steps[m_index].systemId.value_or(m_firstSystem);
    for (const VehicleState *vehicle : vehicles) {
        if (vehicle->systemId == wanted)
            return vehicle;
    }
    return nullptr;
}

void FlightScriptRunner::begin(TimePoint now, const VehicleState &vehicle)
{
    m_stepSystem = vehicle.systemId;
    m_awaited.reset();
    const auto &action = m_steps[m_index].action;
    if (const auto *wait = std::get_if<WaitUntil>(&action)) {
        m_phase = Phase::WaitingForState;
        m_deadline = now + wait->timeout;
        return;
    }
    if (const auto *sleep = std::get_if<Sleep>(&action)) {
        m_phase = Phase::Sleeping;
        m_deadline = now + sleep->time;
        return;
    }
    m_phase = Phase::WaitingForResult;
    m_deadline = now + kResultTimeout;
    if (const auto *command = std::get_if<VehicleCommand>(&action))
        m_request = ScriptRequest{m_stepSystem, *command};
    else
        m_request = ScriptRequest{m_stepSystem, std::get<WriteParameter>(action)};
}

void FlightScriptRunner::watch(TimePoint now, const VehicleState &vehicle, const WaitUntil &wait)
{
    if (now >= m_settled && wait.fulfilledBy(vehicle))
        end(StepResult::Reached, describe(*wait.field, vehicle));
    else if (now >= m_deadline && now >= m_settled)
        end(StepResult::TimedOut, describe(*wait.field, vehicle));
}

void FlightScriptRunner::end(StepResult result, std::string reason)
{
    const FlightStep &step = m_steps[m_index];
    m_reports.push_back(
        {m_stepSystem ? m_stepSystem : step.systemId.value_or(0), m_index + 1, step.text, result, std::move(reason)});
    m_failed = result == StepResult::Refused || result == StepResult::TimedOut;
    m_resultArrived = m_phase == Phase::WaitingForResult;
    m_phase = Phase::Idle;
    ++m_index;
}

} // namespace skyseal::vehicle
