// The fence and the rally points of a vehicle, as the map draws them, made from the items of the mission protocol.
// https://mavlink.io/en/services/mission.html#geofence_rally_points
#pragma once

#include "core/vehicle/mission.h"
#include "ui/view_state.h"

#include <QtCore/QPointF>
#include <QtGui/QPolygonF>

#include <optional>
#include <vector>

namespace skyseal::ui {

/// An area that the vehicle must stay in or keep out of. Positions are in metres of the projection, see mercator.h.
struct FenceArea
{
    bool inclusion = true;
    QPolygonF corners = {};             ///< of a polygon
    std::optional<QPointF> centre = {}; ///< of a circle
    double radius = 0;                  ///< of a circle, metres on the ground
};

struct FenceShapes
{
    std::vector<FenceArea> areas;
    std::vector<QPointF> returnPoints; ///< where the vehicle flies after it left the fence
};

/// Items without a place, and polygons with fewer corners than they name or than three, are left out.
FenceShapes fenceOf(const std::vector<vehicle::MissionItem> &items);
std::vector<QPointF> rallyPointsOf(const std::vector<vehicle::MissionItem> &items);

/// Both of the selected vehicle, as last read.
class FenceContent
{
public:
    /// Returns true if anything changed.
    bool show(const ViewState &view);

    const FenceShapes &fence() const { return m_fence; }
    const std::vector<QPointF> &rallyPoints() const { return m_rallyPoints; }

private:
    vehicle::MissionItems m_fenceItems, m_rallyItems;
    FenceShapes m_fence;
    std::vector<QPointF> m_rallyPoints;
};

} // namespace skyseal::ui
