// Place and altitude of a mission item, if it has them: in other items these fields are zero, unused, or mean something else.
// https://mavlink.io/en/messages/common.html#mav_commands, https://mavlink.io/en/services/mission.html#mission_item_int
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

/// The frame that means the same and that all ground stations read in files: the frames for integers are deprecated synonyms,
/// which vehicles return.
constexpr std::uint8_t plainFrame(std::uint8_t frame)
{
    switch (frame) {
    case mavlink::MAV_FRAME_GLOBAL_INT: return mavlink::MAV_FRAME_GLOBAL;
    case mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT_INT: return mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT;
    case mavlink::MAV_FRAME_GLOBAL_TERRAIN_ALT_INT: return mavlink::MAV_FRAME_GLOBAL_TERRAIN_ALT;
    default: return frame;
    }
}

/// Whether the command takes parameters 5 and 6 as a place: the attribute hasLocation of the definitions, true without one and
/// of a command that they do not have.
bool commandHasPlace(std::uint16_t command);

/// Whether parameters 5 and 6 are latitude and longitude, known or not.
inline bool isGlobal(const MissionItem &item)
{
    return isGlobalFrame(item.frame) && commandHasPlace(item.command);
}

/// What MISSION_ITEM_INT multiplies parameters 5 and 6 by: 1e7 for degrees, 1e4 for metres in a local frame, 1 for numbers of a
/// command without a place.
inline double integerScale(const MissionItem &item)
{
    if (!commandHasPlace(item.command) || item.frame == mavlink::MAV_FRAME_MISSION)
        return 1;
    return isGlobalFrame(item.frame) ? 1e7 : 1e4;
}

/// Whether the item names a place on the globe. Without one, the command is executed where the vehicle is.
inline bool hasPlace(const MissionItem &item)
{
    return isGlobal(item) && std::isfinite(item.latitude) && std::isfinite(item.longitude)
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
    switch (plainFrame(frame)) {
    case mavlink::MAV_FRAME_GLOBAL: return AltitudeReference::SeaLevel;
    case mavlink::MAV_FRAME_GLOBAL_TERRAIN_ALT: return AltitudeReference::Terrain;
    default: return AltitudeReference::Home;
    }
}

/// Whether the item has the form of the home position, which ArduPilot and its ground stations keep as item 0 of a mission: a
/// waypoint with its altitude above sea level.
inline bool isLikeHome(const MissionItem &item)
{
    return item.command == mavlink::MAV_CMD_NAV_WAYPOINT && isGlobalFrame(item.frame)
        && altitudeReferenceOf(item.frame) == AltitudeReference::SeaLevel;
}

} // namespace skyseal::vehicle
