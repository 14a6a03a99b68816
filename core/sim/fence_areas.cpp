#include "core/sim/fence_areas.h"

namespace skyseal::sim {

using namespace mavlink;

namespace {

constexpr float kMostCorners = 255;

bool isCorner(const StoredItem &item)
{
    return item.command == MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION
        || item.command == MAV_CMD_NAV_FENCE_POLYGON_VERTEX_EXCLUSION;
}
bool isCircle(const StoredItem &item)
{
    return item.command == MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION || item.command == MAV_CMD_NAV_FENCE_CIRCLE_EXCLUSION;
}
bool isInclusion(const StoredItem &item)
{
    return item.command == MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION || item.command == MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION;
}

} // namespace

std::optional<ItemError> FenceAreas::checkItem(const StoredItem &item)
{
    if (!isGlobalFrame(item.frame))
        return ItemError::UnsupportedFrame;
    if (!isCorner(item) && !isCircle(item) && item.command != MAV_CMD_NAV_FENCE_RETURN_POINT)
        return ItemError::Unsupported;
    return std::nullopt;
}

std::optional<std::string> FenceAreas::load(std::vector<StoredItem> items, const GeoFrame &world)
{
    std::vector<Area> areas;
    std::size_t cornersLeft = 0, returnPoints = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const StoredItem &item = items[i];
        const std::string where = "Fence item " + std::to_string(i) + ": ";
        if (!isOnGlobe(item))
            return where + "bad lat or lon";
        if (cornersLeft > 0 && (item.command != items[i - 1].command || item.parameters[0] != items[i - 1].parameters[0]))
            return where + "not the expected polygon vertex";
        const Vector3 place = world.toLocal({item.x * 1e-7, item.y * 1e-7, 0});
        const float size = item.parameters[0];
        if (isCorner(item)) {
            if (cornersLeft == 0) {
                if (!(size >= 3 && size <= kMostCorners))
                    return where + "invalid vertex count";
                cornersLeft = static_cast<std::size_t>(size);
                areas.push_back({isInclusion(item), 0, {}});
            }
            --cornersLeft;
            areas.back().corners.push_back({place.x, place.y});
        } else if (isCircle(item)) {
            if (!(size > 0) || std::isinf(size))
                return where + "non-positive circle radius";
            areas.push_back({isInclusion(item), static_cast<double>(size), {{place.x, place.y}}});
        } else if (++returnPoints > 1) {
            return where + "second return point";
        }
    }
    if (cornersLeft > 0)
        return "Fence: the last polygon misses " + std::to_string(cornersLeft) + " vertices";
    m_items = std::move(items);
    m_areas = std::move(areas);
    return std::nullopt;
}

bool FenceAreas::within(const Area &area, const Vector3 &place)
{
    const auto &corners = area.corners;
    if (area.radius > 0)
        return std::hypot(place.x - corners[0].north, place.y - corners[0].east) < area.radius;
    // Counts the edges that a ray to the north crosses.
    bool inside = false;
    for (std::size_t i = 0, last = corners.size() - 1; i < corners.size(); last = i++) {
        const Corner &a = corners[i], &b = corners[last];
        if ((a.east > place.y) == (b.east > place.y))
            continue;
        const double crossing = a.north + (b.north - a.north) * (place.y - a.east) / (b.east - a.east);
        if (crossing > place.x)
            inside = !inside;
    }
    return inside;
}

bool FenceAreas::allow(const Vector3 &place) const
{
    for (const Area &area : m_areas) {
        if (within(area, place) != area.inclusion)
            return false;
    }
    return true;
}

} // namespace skyseal::sim
