// Lists of items for tests of the mission protocol: a fence, rally points and a flight plan around the place where the vehicle
// stands.
#pragma once

#include "tests/sim/item_exchange.h"

#include "core/mavlink/enums.h"

namespace skyseal::sim {

inline constexpr std::int32_t kLatitude = -353632610, kLongitude = 1491652300; // where the vehicle stands
inline constexpr double kMetre = 1e7 / 111318.845;                             // of latitude, in 1e-7 degrees

inline mavlink::MissionItemInt itemAt(std::uint16_t command, float size, double north, double east)
{
    mavlink::MissionItemInt item;
    item.target_system = 1;
    item.target_component = 1;
    item.frame = command == mavlink::MAV_CMD_NAV_RALLY_POINT ? mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT
                                                             : mavlink::MAV_FRAME_GLOBAL;
    item.command = command;
    item.autocontinue = 1;
    item.param1 = size;
    item.x = kLatitude + static_cast<std::int32_t>(north * kMetre);
    item.y = kLongitude + static_cast<std::int32_t>(east * kMetre / std::cos(0.6172));
    return item;
}

inline std::vector<mavlink::MissionItemInt> numbered(std::vector<mavlink::MissionItemInt> items, std::uint8_t type)
{
    for (std::size_t i = 0; i < items.size(); ++i) {
        items[i].seq = static_cast<std::uint16_t>(i);
        items[i].mission_type = type;
    }
    return items;
}

inline std::vector<mavlink::MissionItemInt> polygon(std::uint16_t command, double north, double east, double half)
{
    return {itemAt(command, 4, north + half, east - half), itemAt(command, 4, north + half, east + half),
            itemAt(command, 4, north - half, east + half), itemAt(command, 4, north - half, east - half)};
}

/// A square to stay in, a circle to stay out of, and a return point.
inline std::vector<mavlink::MissionItemInt> someFence()
{
    auto items = polygon(mavlink::MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION, 0, 0, 200);
    items.push_back(itemAt(mavlink::MAV_CMD_NAV_FENCE_CIRCLE_EXCLUSION, 20, 100, 0));
    items.push_back(itemAt(mavlink::MAV_CMD_NAV_FENCE_RETURN_POINT, 0, 0, 0));
    return numbered(items, mavlink::MAV_MISSION_TYPE_FENCE);
}

inline std::vector<mavlink::MissionItemInt> someRallyPoints(double height = 30)
{
    std::vector<mavlink::MissionItemInt> items{itemAt(mavlink::MAV_CMD_NAV_RALLY_POINT, 0, 60, 0),
                                               itemAt(mavlink::MAV_CMD_NAV_RALLY_POINT, 0, -150, 80)};
    for (auto &item : items)
        item.z = static_cast<float>(height);
    return numbered(items, mavlink::MAV_MISSION_TYPE_RALLY);
}

inline std::vector<mavlink::MissionItemInt> somePlan()
{
    std::vector<mavlink::MissionItemInt> items;
    for (int i = 0; i < 5; ++i)
        items.push_back(itemAt(i == 1 ? mavlink::MAV_CMD_NAV_TAKEOFF : mavlink::MAV_CMD_NAV_WAYPOINT, 0, i * 10, 0));
    return numbered(items, 0);
}

inline std::vector<mavlink::MissionItemInt> some(std::uint8_t type)
{
    return type == mavlink::MAV_MISSION_TYPE_FENCE ? someFence()
        : type == mavlink::MAV_MISSION_TYPE_RALLY  ? someRallyPoints()
                                                   : somePlan();
}

inline float parameter(const TestStation &station, const char *name)
{
    return station.vehicle.autopilot().parameters().value(name);
}

} // namespace skyseal::sim
