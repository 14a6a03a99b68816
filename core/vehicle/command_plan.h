// Translation of a VehicleCommand into messages: the MAV_CMDs or messages to try on this kind of vehicle, in this order, and
// the state change that confirms the command. Older firmware does not support every command, so there may be alternatives.
#pragma once

#include "core/base/reason.h"
#include "core/base/result.h"
#include "core/vehicle/command_client.h"
#include "core/vehicle/vehicle_command.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace skyseal::vehicle {

// Effects: what the vehicle reports once the command has been carried out.
struct ArmedIs
{
    bool armed = false;
};
struct ModeIs
{
    std::uint32_t customMode = 0;
    std::string name;
};
struct MissionItemIs
{
    std::uint16_t index = 0;
};
struct TargetIs
{
    std::int32_t latitude = 0, longitude = 0; ///< degrees × 1e7
};
struct InAir
{};
using Effect = std::variant<std::monostate, ArmedIs, ModeIs, MissionItemIs, TargetIs, InAir>;

/// A mode that has to be entered first.
struct NeededMode
{
    std::uint32_t customMode = 0;
    std::string name;
    OutMessage request;
};

/// A message that is repeated until the effect is reported.
struct RepeatedMessage
{
    OutMessage message;
    bool effectExpected = true; ///< false: the vehicle may accept it without ever reporting the effect
    /// In other modes the vehicle ignores the message. It is sent once a heartbeat reports this mode; until then, the mode is
    /// requested.
    std::optional<NeededMode> mode = {};
};

using Alternative = std::variant<CommandOrder, RepeatedMessage>;

struct CommandPlan
{
    std::vector<Alternative> alternatives; ///< the next one is tried if one is not supported or not answered
    Effect effect;
    bool replaces = true; ///< a newer command with the same kind of effect cancels this one
    /// To be planned once this one took effect, which only prepares it.
    std::optional<VehicleCommand> then = {};
};

/// The error is the reason why nothing is sent. For a command that prepares itself, it is the plan of the first step.
Result<CommandPlan, Reason> planCommand(const VehicleCommand &command, const VehicleState &state, const Addressing &addressing);

/// True if the command arms the motors on its way.
bool armsFirst(const VehicleCommand &command, const VehicleState &state);

} // namespace skyseal::vehicle
