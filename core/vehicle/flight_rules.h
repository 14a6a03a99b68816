// What the autopilots can do on each frame, and how: one table, by which commands are planned and the window offers them. It
// says what real vehicles do; tests compare it with recordings of them. Which modes exist is in flight_modes.h.
#pragma once

#include "core/vehicle/vehicle_state.h"

#include <string_view>

namespace skyseal::vehicle {

/// How a vehicle does an act.
struct Act
{
    enum class Way : std::uint8_t {
        None,   ///< it cannot
        Mode,   ///< by entering a mode
        Command ///< by a command of the act's own
    };

    Way way = Way::None;
    std::string_view mode = {}; ///< the autopilot's name, of Way::Mode
};

struct FlightRules
{
    enum class TakeOff : std::uint8_t {
        None,
        AboveHome, ///< MAV_CMD_NAV_TAKEOFF to metres above home
        AboveSea   ///< the same to metres above mean sea level
    };

    bool flies = true; ///< has an altitude to command
    TakeOff takeOff = TakeOff::None;
    std::string_view takesOffIn = {}; ///< the mode in which a take-off is accepted; empty: any
    /// The mode in which the vehicle is armed before a mission; empty: any. ArduCopter does not arm in AUTO and some others.
    std::string_view armsForMissionIn = {};
    /// Disarmed, the vehicle may accept a take-off or a mission, and carries it out when it is armed at some later time.
    bool startsNeedArmed = true;
    Act land = {}, returnHome = {}, hold = {}, mission = {};
};

/// The rules of this autopilot and frame. An autopilot that is not known is assumed to understand the commands of MAVLink.
const FlightRules &rulesOf(const VehicleState &state);

/// True if arming in the mode that is in use begins a flight at once.
bool armingTakesOff(const VehicleState &state);

} // namespace skyseal::vehicle
