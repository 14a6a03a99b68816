#include "core/sim/mission.h"

#include "core/mavlink/enums.h"

#include <algorithm>
#include <iterator>

namespace skyseal::sim {

namespace {

// Of MAV_FRAME; the terrain frames count as relative, since the ground is flat.
bool absoluteFrame(std::uint8_t frame)
{
    return frame == mavlink::MAV_FRAME_GLOBAL || frame == mavlink::MAV_FRAME_GLOBAL_INT;
}
bool relativeFrame(std::uint8_t frame)
{
    using namespace mavlink;
    return frame == MAV_FRAME_GLOBAL_RELATIVE_ALT || frame == MAV_FRAME_GLOBAL_RELATIVE_ALT_INT
        || frame == MAV_FRAME_GLOBAL_TERRAIN_ALT || frame == MAV_FRAME_GLOBAL_TERRAIN_ALT_INT;
}

// The commands of missions that are simulated, by the kinds of vehicles whose firmware knows them.
struct Supported
{
    std::uint16_t command;
    bool copter, plane, rover;
};
constexpr Supported kCommands[] = {
    {mavlink::MAV_CMD_NAV_WAYPOINT, true, true, true},         {mavlink::MAV_CMD_NAV_LOITER_UNLIM, true, true, true},
    {mavlink::MAV_CMD_NAV_LOITER_TIME, true, true, true},      {mavlink::MAV_CMD_NAV_LOITER_TURNS, false, true, false},
    {mavlink::MAV_CMD_NAV_RETURN_TO_LAUNCH, true, true, true}, {mavlink::MAV_CMD_NAV_LAND, true, true, false},
    {mavlink::MAV_CMD_NAV_TAKEOFF, true, true, false},         {mavlink::MAV_CMD_NAV_DELAY, true, true, true},
    {mavlink::MAV_CMD_CONDITION_YAW, true, false, false},      {mavlink::MAV_CMD_DO_JUMP, true, true, true},
    {mavlink::MAV_CMD_DO_CHANGE_SPEED, true, true, true},
};

bool isSupported(std::uint16_t command, CraftKind kind)
{
    const auto at = std::find_if(std::begin(kCommands), std::end(kCommands),
                                 [&](const Supported &row) { return row.command == command; });
    if (at == std::end(kCommands))
        return false;
    return kind == CraftKind::Copter ? at->copter : kind == CraftKind::Plane ? at->plane : at->rover;
}

} // namespace

bool hasPlace(std::uint16_t command)
{
    using namespace mavlink;
    return command == MAV_CMD_NAV_WAYPOINT || command == MAV_CMD_NAV_LOITER_UNLIM || command == MAV_CMD_NAV_LOITER_TIME
        || command == MAV_CMD_NAV_LOITER_TURNS || command == MAV_CMD_NAV_LAND || command == MAV_CMD_NAV_TAKEOFF;
}

bool isGlobalFrame(std::uint8_t frame)
{
    return absoluteFrame(frame) || relativeFrame(frame);
}

double integerScale(std::uint16_t command)
{
    using namespace mavlink;
    const bool place = command < MAV_CMD_NAV_LAST
        || (command >= MAV_CMD_NAV_FENCE_RETURN_POINT && command <= MAV_CMD_NAV_RALLY_POINT);
    return place ? 1e7 : 1;
}

bool isOnGlobe(const StoredItem &item)
{
    return std::abs(static_cast<double>(item.x)) <= 90e7 && std::abs(static_cast<double>(item.y)) <= 180e7;
}

std::optional<ItemError> checkItem(const StoredItem &item, const VehicleType &type)
{
    if (!isSupported(item.command, type.kind))
        return ItemError::Unsupported;
    for (const float parameter : item.parameters) {
        if (std::isinf(parameter))
            return ItemError::Invalid; // not-a-number is fine: it means "the default"
    }
    if (!hasPlace(item.command))
        return std::nullopt;
    if (!isGlobalFrame(item.frame))
        return ItemError::UnsupportedFrame;
    if (std::abs(static_cast<double>(item.x)) > 90e7)
        return ItemError::InvalidX;
    if (std::abs(static_cast<double>(item.y)) > 180e7)
        return ItemError::InvalidY;
    if (!std::isfinite(item.z) || std::abs(item.z) > 10000)
        return ItemError::InvalidZ;
    return std::nullopt;
}

bool isNavigation(const StoredItem &item)
{
    return item.command < mavlink::MAV_CMD_NAV_LAST;
}

Vector3 placeOf(const StoredItem &item, const GeoFrame &world, const Vector3 &home, const Vector3 &here)
{
    Vector3 place = here;
    if (item.x != 0 || item.y != 0)
        place = world.toLocal({item.x * 1e-7, item.y * 1e-7, 0});
    place.z = absoluteFrame(item.frame) ? world.origin().altitude - static_cast<double>(item.z)
                                        : home.z - static_cast<double>(item.z);
    return place;
}

} // namespace skyseal::sim
