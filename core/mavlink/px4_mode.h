// Custom modes of PX4, which the dialects do not define: the main mode in the third byte, the sub mode in the fourth, with the
// numbers of PX4's px4_custom_mode.h.
#pragma once

#include <cstdint>
#include <optional>

namespace skyseal::mavlink {

constexpr std::uint32_t px4Mode(std::uint32_t mainMode, std::uint32_t subMode = 0)
{
    return mainMode << 16 | subMode << 24;
}

inline constexpr std::uint32_t kPx4Manual = px4Mode(1);
inline constexpr std::uint32_t kPx4AltitudeControl = px4Mode(2);
inline constexpr std::uint32_t kPx4PositionControl = px4Mode(3);
inline constexpr std::uint32_t kPx4Orbit = px4Mode(3, 1);
inline constexpr std::uint32_t kPx4PositionSlow = px4Mode(3, 2);
inline constexpr std::uint32_t kPx4AutoReady = px4Mode(4, 1);
inline constexpr std::uint32_t kPx4AutoTakeOff = px4Mode(4, 2);
inline constexpr std::uint32_t kPx4AutoLoiter = px4Mode(4, 3);
inline constexpr std::uint32_t kPx4AutoMission = px4Mode(4, 4);
inline constexpr std::uint32_t kPx4AutoRtl = px4Mode(4, 5);
inline constexpr std::uint32_t kPx4AutoLand = px4Mode(4, 6);
inline constexpr std::uint32_t kPx4AutoFollowTarget = px4Mode(4, 8);
inline constexpr std::uint32_t kPx4AutoPrecisionLand = px4Mode(4, 9);
inline constexpr std::uint32_t kPx4AutoVtolTakeOff = px4Mode(4, 10);
inline constexpr std::uint32_t kPx4External1 = px4Mode(4, 11); ///< the first of eight modes that programs beside PX4 provide
inline constexpr std::uint32_t kPx4Acro = px4Mode(5);
inline constexpr std::uint32_t kPx4Offboard = px4Mode(6);
inline constexpr std::uint32_t kPx4Stabilized = px4Mode(7);
inline constexpr std::uint32_t kPx4Rattitude = px4Mode(8);
inline constexpr std::uint32_t kPx4Termination = px4Mode(10);
inline constexpr std::uint32_t kPx4AltitudeCruise = px4Mode(11);

/// PX4's number of the mode (nav_state of its vehicle_status.msg), a bit of the sets of modes in its events; nullopt for a mode
/// without one.
constexpr std::optional<std::uint8_t> px4NavigationState(std::uint32_t mode)
{
    if (mode >= kPx4External1 && mode <= px4Mode(4, 18) && (mode & 0xffffff) == px4Mode(4))
        return static_cast<std::uint8_t>(23 + ((mode - kPx4External1) >> 24));
    switch (mode) {
    case kPx4Manual: return 0;
    case kPx4AltitudeControl: return 1;
    case kPx4PositionControl: return 2;
    case kPx4AutoMission: return 3;
    case kPx4AutoLoiter: return 4;
    case kPx4AutoRtl: return 5;
    case kPx4PositionSlow: return 6;
    case kPx4AltitudeCruise: return 8;
    case kPx4Acro: return 10;
    case kPx4Termination: return 13;
    case kPx4Offboard: return 14;
    case kPx4Stabilized: return 15;
    case kPx4AutoTakeOff: return 17;
    case kPx4AutoLand: return 18;
    case kPx4AutoFollowTarget: return 19;
    case kPx4AutoPrecisionLand: return 20;
    case kPx4Orbit: return 21;
    case kPx4AutoVtolTakeOff: return 22;
    default: return std::nullopt;
    }
}

} // namespace skyseal::mavlink
