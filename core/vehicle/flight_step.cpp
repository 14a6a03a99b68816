// Evaluation of conditions and canonical text of flight script steps; the parser is in flight_script.cpp.
#include "core/vehicle/flight_script.h"
#include "core/base/ascii.h"
#include "core/base/number_text.h"

namespace skyseal::vehicle {

namespace {

struct CommandText
{
    std::string operator()(const Arm &arm) const { return arm.force ? "arm force" : "arm"; }
    std::string operator()(const Disarm &disarm) const { return disarm.force ? "disarm force" : "disarm"; }
    std::string operator()(const TakeOff &takeOff) const { return "takeoff " + numberText(takeOff.altitude); }
    std::string operator()(const Land &) const { return "land"; }
    std::string operator()(const ReturnToLaunch &) const { return "rtl"; }
    std::string operator()(const SetMode &mode) const { return "mode " + mode.mode; }
    std::string operator()(const GoTo &place) const
    {
        return "goto " + numberText(place.latitude) + " " + numberText(place.longitude) + " "
            + numberText(place.altitudeRelative);
    }
    std::string operator()(const ChangeAltitude &change) const { return "altitude " + numberText(change.altitudeRelative); }
    std::string operator()(const Loiter &) const { return "pause"; }
    std::string operator()(const PointAt &place) const
    {
        return "roi " + numberText(place.latitude) + " " + numberText(place.longitude) + " "
            + numberText(place.altitudeRelative);
    }
    std::string operator()(const StopPointing &) const { return "roi none"; }
    std::string operator()(const SetHome &home) const
    {
        return "sethome " + numberText(home.latitude) + " " + numberText(home.longitude);
    }
    std::string operator()(const ChangeSpeed &speed) const { return "speed " + numberText(speed.metresPerSecond); }
    std::string operator()(const SetCurrentMissionItem &item) const { return "item " + std::to_string(item.index); }
    std::string operator()(const StartMission &) const { return "start"; }
    std::string operator()(const Reboot &) const { return "reboot"; }
    std::string operator()(const RawCommand &raw) const
    {
        std::string out = "command " + std::to_string(raw.command);
        for (const float parameter : raw.parameters)
            out += " " + numberText(parameter);
        return out;
    }
};

std::string_view sign(ComparisonOperator comparison)
{
    switch (comparison) {
    case ComparisonOperator::AtLeast: return ">=";
    case ComparisonOperator::AtMost: return "<=";
    case ComparisonOperator::Greater: return ">";
    case ComparisonOperator::Less: return "<";
    case ComparisonOperator::Equal: return "==";
    case ComparisonOperator::NotEqual: return "!=";
    }
    return "==";
}

struct ActionText
{
    std::string operator()(const VehicleCommand &command) const { return std::visit(CommandText{}, command); }
    std::string operator()(const WaitUntil &wait) const
    {
        const bool isText = wait.field->kind == StateField::Kind::Text;
        return "wait " + std::string(wait.field->name) + std::string(sign(wait.comparison))
            + (isText ? wait.text : numberText(wait.number)) + " " + numberText(seconds(wait.timeout));
    }
    std::string operator()(const Sleep &sleep) const { return "sleep " + numberText(seconds(sleep.time)); }
    std::string operator()(const WriteParameter &write) const
    {
        return "param " + parameterLabel({.name = write.name, .componentId = write.componentId}) + " "
            + numberText(write.value);
    }
};

/// True for each of the names that a mode has, the vehicle's own and the autopilot's.
bool isInMode(const VehicleState &state, std::string_view name)
{
    return (state.baseMode & mavlink::MAV_MODE_FLAG_CUSTOM_MODE_ENABLED) != 0
        && modeNumber({state.type, state.autopilot}, name, state.ownModes) == state.customMode;
}

} // namespace

bool WaitUntil::fulfilledBy(const VehicleState &state) const
{
    if (field->kind == StateField::Kind::Text) {
        const bool same = equalIgnoringCase(field->text(state), text) || (field->name == "mode" && isInMode(state, text));
        return comparison == ComparisonOperator::Equal ? same : !same;
    }
    const double value = field->number(state);
    if (std::isnan(value))
        return false;
    switch (comparison) {
    case ComparisonOperator::AtLeast: return value >= number;
    case ComparisonOperator::AtMost: return value <= number;
    case ComparisonOperator::Greater: return value > number;
    case ComparisonOperator::Less: return value < number;
    case ComparisonOperator::Equal: return value == number;
    case ComparisonOperator::NotEqual: return value != number;
    }
    return false;
}

std::string toText(const FlightStep &step)
{
    const std::string prefix = step.systemId ? std::to_string(*step.systemId) + ": " : std::string();
    return prefix + std::visit(ActionText{}, step.action);
}

} // namespace skyseal::vehicle
