// Names of flight modes: from the base and custom mode of a heartbeat to the name that the autopilot uses, and back. The
// numbers are those of the dialect (COPTER_MODE, PLANE_MODE, …) and the main and sub modes of PX4, or those that the vehicle
// names itself (ModeList). Two modes never have the same name. The table also says which modes a station may ask for: some an
// autopilot enters by itself only, others exist on some frames only.
#pragma once

#include "core/mavlink/enums.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::vehicle {

/// Vehicle type and autopilot, which determine the meaning of mode numbers.
struct VehicleKind
{
    std::uint8_t type = 0;      ///< MAV_TYPE
    std::uint8_t autopilot = 0; ///< MAV_AUTOPILOT
    bool operator==(const VehicleKind &) const = default;

    bool isArduPilot() const { return autopilot == mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA; }
    bool isPx4() const { return autopilot == mavlink::MAV_AUTOPILOT_PX4; }
    bool isCopter() const;
    bool isPlane() const; ///< with and without vertical take-off
    bool isRover() const; ///< boats included
    bool isSubmarine() const;
};

/// What a vehicle is built as. With the autopilot it determines the modes and what the vehicle can do, see flight_rules.h.
enum class Frame : std::uint8_t {
    Multirotor,
    Helicopter,
    Plane,
    VtolPlane, ///< a plane that takes off and lands vertically
    Rover,     ///< boats included
    Submarine,
    Tracker, ///< of antennas
    Other
};

/// `verticalTakeOff`: see VehicleState. A type of the family MAV_TYPE_VTOL needs no such sign.
Frame frameOf(VehicleKind kind, bool verticalTakeOff);

/// A mode that the vehicle itself names (AVAILABLE_MODES, standard modes protocol).
struct OwnMode
{
    std::uint32_t number = 0; ///< custom_mode
    std::string name;         ///< of this mode alone
    bool selectable = true;   ///< a station may ask for it
};

/// The name that the vehicle gives the mode, else the autopilot's: "GUIDED", "AUTO", …; "MODE(17)" for a number without a name.
/// Without a custom mode it is the name of the base mode ("GUIDED", "AUTO", "STABILIZE", "MANUAL", "PREFLIGHT").
std::string modeName(VehicleKind kind, std::uint8_t baseMode, std::uint32_t customMode, std::span<const OwnMode> own = {});

/// The custom mode for a name of either, or for "MODE(17)"; nullopt if this vehicle has no such mode. Names are compared
/// without regard to case, and with '_' for a blank, since a script has no blanks in words.
std::optional<std::uint32_t> modeNumber(VehicleKind kind, std::string_view name, std::span<const OwnMode> own = {});

/// The modes that can be asked for: those that the vehicle names, else all of its autopilot and frame, in the order of their
/// numbers. Modes that an autopilot enters by itself only are left out of both.
std::vector<std::string> modeNames(VehicleKind kind, bool verticalTakeOff = false, std::span<const OwnMode> own = {});

/// True for a mode of ArduPlane that only a plane with vertical take-off has.
bool isVerticalMode(VehicleKind kind, std::uint32_t customMode);

} // namespace skyseal::vehicle
