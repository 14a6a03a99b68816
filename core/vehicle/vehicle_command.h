// What a person or a script can ask of a vehicle, and what became of it.
#pragma once

#include "core/vehicle/vehicle_state.h"

#include <cstdint>
#include <string>
#include <variant>

namespace skyseal::vehicle {

struct Arm
{
    bool force = false;
};
struct Disarm
{
    bool force = false;
};
struct TakeOff
{
    double altitude = 10;
}; ///< metres above home
struct Land
{};
struct ReturnToLaunch
{};
struct SetMode
{
    std::string mode;
};
struct GoTo
{
    double latitude = 0, longitude = 0, altitudeRelative = 0;
};
struct ChangeSpeed
{
    double metresPerSecond = 0;
};
struct SetCurrentMissionItem
{
    std::uint16_t index = 0;
};
struct StartMission
{};
struct Reboot
{};
/// Any other command, by number, for the inspector and for scripts.
struct RawCommand
{
    std::uint16_t command = 0;
    float parameters[7]{};
};

using VehicleCommand = std::variant<Arm, Disarm, TakeOff, Land, ReturnToLaunch, SetMode, GoTo, ChangeSpeed,
                                    SetCurrentMissionItem, StartMission, Reboot, RawCommand>;

/// Numbers the commands of one station, so that results find their askers.
enum class CommandId : std::uint32_t {};

enum class CommandOutcome : std::uint8_t { Accepted, Refused, TimedOut };

struct CommandResult
{
    CommandId id{};
    std::uint8_t systemId = 0;
    CommandOutcome outcome{};
    std::uint8_t result = 0; ///< MAV_RESULT, when answered
    std::string reason; ///< in words: MAV_RESULT's name, the vehicle's own words where it gave any, or why nothing was sent
    bool unanswered = false; ///< timed out, and not one word of it came back
};

} // namespace skyseal::vehicle
