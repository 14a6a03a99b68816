// Changes of a mission before it is written to the vehicle.
#pragma once

#include "core/vehicle/mission.h"
#include "core/vehicle/vehicle_state.h"

#include <optional>
#include <vector>

namespace skyseal::vehicle {

/// Index of a further waypoint in `items`: at the end, or before the return to launch or landing that ends the mission.
std::size_t placeOfNextWaypoint(const std::vector<MissionItem> &items);

/// Altitude above home, in metres, of the last item before that place that has one; nullopt if none does.
std::optional<float> altitudeBeforeNextWaypoint(const std::vector<MissionItem> &items);

/// Numbers the items from 0. Those that had the number `from` or a greater one have moved by `by` places: commands that name
/// an item, such as a jump, lead to the same one as before.
void renumber(std::vector<MissionItem> &items, std::size_t from, int by);

/// The home position as item 0 of a mission; without a place while it is not known.
MissionItem homeItem(const Position &home);

/// `items` behind this home position.
std::vector<MissionItem> withHome(std::vector<MissionItem> items, const MissionItem &home);

/// `items` with a waypoint at `latitude` and `longitude` (degrees) and `altitude` (metres above home) at that place. `home` is
/// item 0 of a mission that is empty so far, for autopilots that keep home there (ArduPilot).
std::vector<MissionItem> withWaypoint(std::vector<MissionItem> items, double latitude, double longitude, float altitude,
                                      const std::optional<MissionItem> &home);

} // namespace skyseal::vehicle
