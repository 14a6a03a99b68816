#include "core/vehicle/mission_edit.h"

#include <cmath>

namespace skyseal::vehicle {

namespace {

bool endsMission(const MissionItem &item)
{
    return item.command == mavlink::MAV_CMD_NAV_RETURN_TO_LAUNCH || item.command == mavlink::MAV_CMD_NAV_LAND
        || item.command == mavlink::MAV_CMD_NAV_VTOL_LAND;
}

bool isAboveHome(const MissionItem &item)
{
    return item.frame == mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT || item.frame == mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT_INT;
}

} // namespace

std::size_t placeOfNextWaypoint(const std::vector<MissionItem> &items)
{
    return items.empty() || !endsMission(items.back()) ? items.size() : items.size() - 1;
}

std::optional<float> altitudeBeforeNextWaypoint(const std::vector<MissionItem> &items)
{
    for (std::size_t i = placeOfNextWaypoint(items); i > 0; --i) {
        const MissionItem &item = items[i - 1];
        if (isAboveHome(item) && item.altitude > 0)
            return item.altitude;
    }
    return std::nullopt;
}

void renumber(std::vector<MissionItem> &items, std::size_t from, int by)
{
    std::uint16_t sequence = 0;
    for (MissionItem &item : items) {
        item.sequence = sequence++;
        const bool namesItem = item.command == mavlink::MAV_CMD_DO_JUMP
            || item.command == mavlink::MAV_CMD_DO_SET_MISSION_CURRENT;
        if (namesItem && item.parameters[0] >= static_cast<float>(from))
            item.parameters[0] += static_cast<float>(by);
    }
}

MissionItem homeItem(const Position &home)
{
    MissionItem out;
    out.frame = mavlink::MAV_FRAME_GLOBAL;
    if (home.known()) {
        out.latitude = home.latitude;
        out.longitude = home.longitude;
        out.altitude = std::isfinite(home.altitude) ? static_cast<float>(home.altitude) : 0;
    }
    return out;
}

std::vector<MissionItem> withHome(std::vector<MissionItem> items, const MissionItem &home)
{
    items.insert(items.begin(), home);
    renumber(items, 0, 1);
    return items;
}

std::vector<MissionItem> withWaypoint(std::vector<MissionItem> items, double latitude, double longitude, float altitude,
                                      const std::optional<MissionItem> &home)
{
    if (items.empty() && home)
        items.push_back(*home);
    const std::size_t place = placeOfNextWaypoint(items);
    MissionItem waypoint;
    waypoint.latitude = latitude;
    waypoint.longitude = longitude;
    waypoint.altitude = altitude;
    items.insert(items.begin() + static_cast<std::ptrdiff_t>(place), waypoint);
    renumber(items, place, 1);
    return items;
}

} // namespace skyseal::vehicle
