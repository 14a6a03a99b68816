// Names of flight modes: what a heartbeat's base and custom mode mean on each autopilot, and back. The numbers are those of
// ArduPilot's mode enums (COPTER_MODE and its siblings) and of PX4's main and sub modes.
#pragma once

#include "core/mavlink/enums.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::vehicle {

/// What kind of vehicle decides about the meaning of mode numbers.
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

/// "GUIDED", "AUTO", …; "MODE(17)" for a number that has no name here; of autopilots without custom modes the base mode's
/// word ("GUIDED", "AUTO", "STABILIZE", "MANUAL").
std::string modeName(VehicleKind kind, std::uint8_t baseMode, std::uint32_t customMode);

/// The custom mode of a name, in any case, or of "MODE(17)"; nullopt when this kind of vehicle has none of that name.
std::optional<std::uint32_t> modeNumber(VehicleKind kind, std::string_view name);

/// All names that modeNumber() knows for this kind, in the order of their numbers.
std::vector<std::string> modeNames(VehicleKind kind);

} // namespace skyseal::vehicle
