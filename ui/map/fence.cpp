#include "ui/map/fence.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "core/mavlink/enums.h"
#include "core/vehicle/mission_place.h"
#include "ui/tiles/mercator.h"

#include <cmath>

namespace skyseal::ui {

namespace {

using namespace mavlink;

QPointF placeOf(const vehicle::MissionItem &item)
{
    return mercator::project({item.latitude, item.longitude});
}

bool isCorner(const vehicle::MissionItem &item)
{
    return item.command == MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION
        || item.command == MAV_CMD_NAV_FENCE_POLYGON_VERTEX_EXCLUSION;
}

/// The corners from `begin` on that belong together: each names their number.
FenceArea polygonAt(const std::vector<vehicle::MissionItem> &items, std::size_t begin)
{
    const vehicle::MissionItem &first = items[begin];
    FenceArea area{.inclusion = first.command == MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION};
    for (std::size_t i = begin; i < items.size() && static_cast<float>(area.corners.size()) < first.parameters[0]; ++i) {
        if (items[i].command != first.command || items[i].parameters[0] != first.parameters[0] || !hasPlace(items[i]))
            break;
        area.corners << placeOf(items[i]);
    }
    return area;
}

bool isWhole(const FenceArea &area, const vehicle::MissionItem &first)
{
    return area.corners.size() >= 3 && static_cast<float>(area.corners.size()) == first.parameters[0];
}

} // namespace

FenceShapes fenceOf(const std::vector<vehicle::MissionItem> &items)
{
    FenceShapes out;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const vehicle::MissionItem &item = items[i];
        if (isCorner(item)) {
            const FenceArea area = polygonAt(items, i);
            if (isWhole(area, item))
                out.areas.push_back(area);
            i += static_cast<std::size_t>(std::max<qsizetype>(area.corners.size(), 1)) - 1;
            continue;
        }
        if (!hasPlace(item))
            continue;
        const bool inclusion = item.command == MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION;
        if (item.command == MAV_CMD_NAV_FENCE_RETURN_POINT)
            out.returnPoints.push_back(placeOf(item));
        else if ((inclusion || item.command == MAV_CMD_NAV_FENCE_CIRCLE_EXCLUSION) && item.parameters[0] > 0)
            out.areas.push_back({.inclusion = inclusion, .centre = placeOf(item), .radius = item.parameters[0]});
    }
    return out;
}

std::vector<QPointF> rallyPointsOf(const std::vector<vehicle::MissionItem> &items)
{
    std::vector<QPointF> out;
    for (const vehicle::MissionItem &item : items)
        if (item.command == MAV_CMD_NAV_RALLY_POINT && hasPlace(item))
            out.push_back(placeOf(item));
    return out;
}

bool FenceContent::show(const ViewState &view)
{
    const vehicle::MissionItems fence = view.vehicle ? view.vehicle->fence : nullptr;
    const vehicle::MissionItems rally = view.vehicle ? view.vehicle->rally : nullptr;
    if (fence == m_fenceItems && rally == m_rallyItems)
        return false;
    m_fenceItems = fence;
    m_rallyItems = rally;
    m_fence = fence ? fenceOf(*fence) : FenceShapes();
    m_rallyPoints = rally ? rallyPointsOf(*rally) : std::vector<QPointF>();
    return true;
}

} // namespace skyseal::ui
