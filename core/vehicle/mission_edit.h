// Changes of a mission before it is written to the vehicle.
#pragma once

#include "core/vehicle/mission.h"

#include <optional>
#include <vector>

namespace skyseal::vehicle {

/// Index of a further waypoint in `items`: at the end, or before the return to launch or landing that ends the mission.
std::size_t placeOfNextWaypoint(const std::vector<MissionItem> &items);

/// Altitude above home, in metres, of the last item before that place that has one; nullopt if none does.
std::optional<float> altitudeBeforeNextWaypoint(const std::vector<MissionItem> &items);

/// `items` with a waypoint at `latitude` and `longitude` (degrees) and `altitude` (metres above home) at that place. `home` is
/// item 0 of a mission that is empty so far, for autopilots that keep home there (ArduPilot). Counters of jumps are adapted,
/// so that each still leads to the same item.
std::vector<MissionItem> withWaypoint(std::vector<MissionItem> items, double latitude, double longitude, float altitude,
                                      const std::optional<MissionItem> &home);

} // namespace skyseal::vehicle
