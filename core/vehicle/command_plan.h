// How a wish becomes messages: which commands or messages to try on this kind of vehicle, in which order, and by what one
// sees that it was fulfilled. Old firmware does not know every command, so a wish may have several ways.
#pragma once

#include "core/base/result.h"
#include "core/vehicle/command_client.h"
#include "core/vehicle/vehicle_command.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace skyseal::vehicle {

/// What the vehicle itself reports when the wish came true.
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
    std::int32_t latitude = 0, longitude = 0; /* degrees × 1e7 */
};
using Sign = std::variant<std::monostate, ArmedIs, ModeIs, MissionItemIs, TargetIs>;

/// A message that is repeated until the sign is seen.
struct RepeatedMessage
{
    OutMessage message;
    bool signExpected = true; ///< false: the vehicle may take it without ever showing so
};

using Way = std::variant<CommandOrder, RepeatedMessage>;

struct CommandPlan
{
    std::vector<Way> ways; ///< the next is tried when one is not supported or not answered
    Sign sign;
    bool replaces = true; ///< a newer wish of the same kind makes this one void
};

/// An error says in words why nothing is sent.
Result<CommandPlan, std::string> planCommand(const VehicleCommand &command, const VehicleState &state,
                                             const Addressing &addressing);

} // namespace skyseal::vehicle
