// The MAV_CMD numbers that a mission of this vehicle may hold.
#pragma once

#include <cstdint>

namespace skyseal::sim::mission_command {

inline constexpr std::uint16_t kWaypoint = 16;
inline constexpr std::uint16_t kLoiterUnlimited = 17;
inline constexpr std::uint16_t kLoiterTime = 19;
inline constexpr std::uint16_t kReturnToLaunch = 20;
inline constexpr std::uint16_t kLand = 21;
inline constexpr std::uint16_t kTakeOff = 22;
inline constexpr std::uint16_t kDelay = 93;
inline constexpr std::uint16_t kLastNavigation = 95; ///< smaller numbers are navigation commands
inline constexpr std::uint16_t kConditionYaw = 115;
inline constexpr std::uint16_t kJump = 177;
inline constexpr std::uint16_t kChangeSpeed = 178;

} // namespace skyseal::sim::mission_command
