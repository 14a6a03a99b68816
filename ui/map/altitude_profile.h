// The altitudes along the route of a mission, over the way on the ground.
#pragma once

#include "ui/map/mission_route.h"

#include <vector>

namespace skyseal::ui {

struct ProfilePoint
{
    int sequence = 0;         ///< of the item; -1: where the route begins
    double distance = 0;      ///< metres along the route, each part once: loiters and jumps are not followed
    double altitude = 0;      ///< metres above home, or above the terrain; NaN: unknown
    bool overTerrain = false; ///< `altitude` counts from the terrain, whose height is not known here
};

/// The points of a route. `homeAltitude` is in metres above mean sea level, NaN if it is not known; altitudes that count from
/// the sea are then unknown as well.
std::vector<ProfilePoint> profileOf(const MissionRoute &route, double homeAltitude);

} // namespace skyseal::ui
