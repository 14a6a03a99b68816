// The flight modes that the vehicle knows, with ArduCopter's numbers and names.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace skyseal::sim {

enum class FlightMode : std::uint32_t {
    Stabilize = 0,
    AltHold = 2,
    Auto = 3,
    Guided = 4,
    Loiter = 5,
    Rtl = 6,
    Land = 9,
    Brake = 17
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
