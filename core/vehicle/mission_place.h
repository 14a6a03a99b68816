// The place and the altitude of a mission item, if it has them: in the others these fields are zero or mean something else.
// https://mavlink.io/en/messages/common.html#mav_commands
#pragma once

#include "core/vehicle/mission.h"

#include <cmath>

namespace skyseal::vehicle {

/// Whether the coordinates of an item in this MAV_FRAME are latitude and longitude.
constexpr bool isGlobalFrame(std::uint8_t frame)
{
    switch (frame) {
    case mavlink::MAV_FRAME_GLOBAL:
    case mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT:
    case mavlink::MAV_FRAME_GLOBAL_INT:
    case mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT_INT:
    case mavlink::MAV_FRAME_GLOBAL_TERRAIN_ALT:
    case mavlink::MAV_FRAME_GLOBAL_TERRAIN_ALT_INT: return true;
    default: return false;
    }
}

/// Whether the item names a place on the globe. Without one, the command is executed where the vehicle is.
inline bool hasPlace(const MissionItem &item)
{
    return isGlobalFrame(item.frame) && std::isfinite(item.latitude) && std::isfinite(item.longitude)
        && (item.latitude != 0 || item.longitude != 0);
}

/// Whether the item names an altitude. A navigation command without a place may: a take-off, or a loiter where the vehicle is.
inline bool hasAltitude(const MissionItem &item)
{
    const bool navigates = item.command < mavlink::MAV_CMD_NAV_LAST || item.command == mavlink::MAV_CMD_CONDITION_CHANGE_ALT;
    return std::isfinite(item.altitude) && (hasPlace(item) || (navigates && item.altitude != 0));
}

enum class AltitudeReference : std::uint8_t { Home, SeaLevel, Terrain };

/// The reference of the altitude of an item in this MAV_FRAME.
constexpr AltitudeReference altitudeReferenceOf(std::uint8_t frame)
{
    switch (frame) {
    case mavlink::MAV_FRAME_GLOBAL:
    case mavlink::MAV_FRAME_GLOBAL_INT: return AltitudeReference::SeaLevel;
    case mavlink::MAV_FRAME_GLOBAL_TERRAIN_ALT:
    case mavlink::MAV_FRAME_GLOBAL_TERRAIN_ALT_INT: return AltitudeReference::Terrain;
    default: return AltitudeReference::Home;
    }
}

} // namespace skyseal::vehicle
