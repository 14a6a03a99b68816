// Commands to a vehicle, as a person or a script gives them, and their result. CommandPlan turns them into MAV_CMD numbers.
#pragma once

#include "core/base/compiled_once.h"
#include "core/base/reason.h"
#include "core/vehicle/request_id.h"

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
    double altitude = 10; ///< metres above home
    bool prepare = false; ///< first enters the mode that it needs, and arms, as far as the vehicle is not ready for it
};
struct Land
{};
struct ReturnToLaunch
{};
struct SetMode
{
    std::string mode;
};
/// Flies to a place and holds there; an aeroplane circles it.
struct GoTo
{
    double latitude = 0, longitude = 0; ///< degrees
    double altitudeRelative = 0;        ///< metres above home
    bool changeMode = false;            ///< of ArduPilot: enters GUIDED if the vehicle is in another mode
};
/// Climbs or descends and holds there. ArduPilot stops where it is, PX4 keeps the place that it flies to.
struct ChangeAltitude
{
    double altitudeRelative = 0; ///< metres above home
    bool changeMode = false;     ///< as in GoTo
};
/// Pause: stops and holds the present place; an aeroplane circles it.
struct Loiter
{};
/// Points the camera at a place until StopPointing; a copter whose camera cannot pan turns its nose.
struct PointAt
{
    double latitude = 0, longitude = 0; ///< degrees
    double altitudeRelative = 0;        ///< metres above home
};
struct StopPointing
{};
/// Moves home. Its altitude stays, since a station without terrain data knows no other.
struct SetHome
{
    double latitude = 0, longitude = 0; ///< degrees
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
{
    bool prepare = false; ///< as in TakeOff
};
struct Reboot
{};
/// Any other command, by number, for the inspector and for scripts.
struct RawCommand
{
    std::uint16_t command = 0;
    float parameters[7]{};
};

using VehicleCommandVariant =
    std::variant<Arm, Disarm, TakeOff, Land, ReturnToLaunch, SetMode, GoTo, ChangeAltitude, Loiter, PointAt, StopPointing,
                 SetHome, ChangeSpeed, SetCurrentMissionItem, StartMission, Reboot, RawCommand>;
using VehicleCommand = CompiledOnce<VehicleCommandVariant>;

/// Whether an autopilot may change its mode for it.
inline bool changesMode(const VehicleCommand &command)
{
    return std::holds_alternative<SetMode>(command) || std::holds_alternative<TakeOff>(command)
        || std::holds_alternative<Land>(command) || std::holds_alternative<ReturnToLaunch>(command)
        || std::holds_alternative<GoTo>(command) || std::holds_alternative<Loiter>(command)
        || std::holds_alternative<StartMission>(command) || std::holds_alternative<ChangeAltitude>(command);
}

/// Whether it begins a flight.
inline bool startsFlight(const VehicleCommand &command)
{
    return std::holds_alternative<TakeOff>(command) || std::holds_alternative<StartMission>(command);
}

enum class CommandOutcome : std::uint8_t { Accepted, Refused, TimedOut };

struct CommandResult
{
    RequestId id{};
    std::uint8_t systemId = 0;
    CommandOutcome outcome{};
    std::uint8_t result = 0; ///< MAV_RESULT, if the vehicle answered
    /// The MAV_RESULT and the vehicle's status texts, or why nothing was sent.
    Reason reason = {};
    bool changeUnanswered = false; ///< timed out without any answer
};

} // namespace skyseal::vehicle

extern template struct skyseal::CompiledOnce<skyseal::vehicle::VehicleCommandVariant>;
