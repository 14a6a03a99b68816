// The flight modes that the vehicle knows, with ArduCopter's numbers and names.
#pragma once

#include "core/mavlink/enums.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace skyseal::sim {

enum class FlightMode : std::uint32_t {
    Stabilize = mavlink::COPTER_MODE_STABILIZE,
    AltHold = mavlink::COPTER_MODE_ALT_HOLD,
    Auto = mavlink::COPTER_MODE_AUTO,
    Guided = mavlink::COPTER_MODE_GUIDED,
    Loiter = mavlink::COPTER_MODE_LOITER,
    Rtl = mavlink::COPTER_MODE_RTL,
    Land = mavlink::COPTER_MODE_LAND,
    Brake = mavlink::COPTER_MODE_BRAKE
};

std::optional<FlightMode> flightMode(std::uint32_t number);
/// As ArduCopter spells it: "STABILIZE", "ALT_HOLD", …
std::string_view name(FlightMode mode);
/// Whether the mode cannot be flown without a horizontal position.
bool needsPosition(FlightMode mode);
/// Whether the rotors may be armed in this mode. AUTO is allowed only by AUTO_OPTIONS.
bool allowsArming(FlightMode mode, int autoOptions);
/// Whether the pilot's throttle stick decides about climbing.
bool hasManualThrottle(FlightMode mode);

} // namespace skyseal::sim
