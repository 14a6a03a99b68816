// One item of a mission, as MISSION_ITEM_INT carries it.
#pragma once

#include <cstdint>

namespace skyseal::vehicle {

struct MissionItem
{
    std::uint16_t sequence = 0;
    std::uint16_t command = 16; ///< MAV_CMD
    std::uint8_t frame = 3;     ///< MAV_FRAME, 3 = relative altitude
    bool current = false;
    bool autoContinue = true;
    float parameters[4]{};
    double latitude = 0, longitude = 0; ///< degrees
    float altitude = 0;                 ///< metres
    bool operator==(const MissionItem &) const = default;
};

} // namespace skyseal::vehicle
