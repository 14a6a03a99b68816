#include "core/experiment/flight_plan.h"

#include "core/base/ascii.h"

#include <algorithm>

namespace skyseal::experiment {

namespace {

using vehicle::FlightStep;

bool lands(const FlightStep &step)
{
    const auto *command = std::get_if<vehicle::VehicleCommand>(&step.action);
    if (!command)
        return false;
    if (const auto *mode = std::get_if<vehicle::SetMode>(command))
        return equalIgnoringCase(mode->mode, "LAND") || equalIgnoringCase(mode->mode, "RTL");
    return std::holds_alternative<vehicle::Land>(*command) || std::holds_alternative<vehicle::ReturnToLaunch>(*command)
        || std::holds_alternative<vehicle::Disarm>(*command);
}

} // namespace

Result<FlightPlan, InputError> parseFlightPlan(std::string_view script)
{
    FlightPlan out;
    out.script = std::string(script);
    std::string steps(script); // a mark ends a step as well, so that the columns of errors are those of the script
    std::ranges::replace(steps, '|', ';');
    auto parsed = vehicle::parseFlightScript(steps);
    if (!parsed)
        return tl::unexpected(parsed.error());
    const auto marks = static_cast<std::size_t>(std::ranges::count(script, '|'));
    if (marks == 0) {
        const auto landing = std::ranges::find_if(*parsed, lands);
        out.legs.emplace_back(parsed->begin(), landing);
        out.legs.emplace_back(landing, parsed->end());
    } else {
        out.legs.resize(marks + 1);
        for (FlightStep &step : *parsed) {
            const std::string_view before = script.substr(0, step.column - 1);
            out.legs[static_cast<std::size_t>(std::ranges::count(before, '|'))].push_back(std::move(step));
        }
    }
    for (std::size_t phase = 0; phase + 1 < out.legs.size(); ++phase) {
        if (out.legs[phase].empty())
            return tl::unexpected(InputError{"no step leads to phase " + std::to_string(phase + 1), {}});
    }
    return out;
}

} // namespace skyseal::experiment
