// Rare events of one vehicle, as values in the order in which they occurred: results of requests and status texts.
#pragma once

#include "core/vehicle/mission.h"
#include "core/vehicle/onboard_log.h"
#include "core/vehicle/parameter.h"
#include "core/vehicle/remote_file.h"
#include "core/vehicle/vehicle_command.h"
#include "core/vehicle/vehicle_state.h"

#include <variant>

namespace skyseal::vehicle {

/// A complete STATUSTEXT of any component of the vehicle.
struct TextReceived
{
    std::uint8_t systemId = 0;
    StatusText text;
};

using Event = std::variant<CommandResult, ParameterResult, MissionResult, FileResult, LogResult, TextReceived>;

} // namespace skyseal::vehicle
