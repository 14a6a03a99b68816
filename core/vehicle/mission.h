// One item of a mission, as MISSION_ITEM_INT carries it.
#pragma once

#include "core/mavlink/enums.h"

#include <cstdint>

namespace skyseal::vehicle {

struct MissionItem
{
    std::uint16_t sequence = 0;
    std::uint16_t command = mavlink::MAV_CMD_NAV_WAYPOINT;       ///< MAV_CMD
    std::uint8_t frame = mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT; ///< MAV_FRAME
    bool current = false;
    bool autoContinue = true;
    float parameters[4]{};
    double latitude = 0, longitude = 0; ///< degrees
    float altitude = 0;                 ///< metres
    bool operator==(const MissionItem &) const = default;
};

} // namespace skyseal::vehicle
