// The shapes of a file as the map draws them: in metres of the projection (see mercator.h), in one piece where they cross the
// 180th meridian, so that x may lie beyond the world, which the map repeats to both sides.
#pragma once

#include "core/overlay/overlay.h"
#include "ui/tiles/mercator.h"

#include <QtCore/QRectF>
#include <QtGui/QPolygonF>

#include <vector>

namespace skyseal::ui {

struct ProjectedShape
{
    overlay::ShapeKind kind{};
    QString name = {};
    std::vector<QPolygonF> lines = {}; ///< as those of OverlayShape
    QRectF box = {};                   ///< of the first line; its top is the southern edge
    QPointF caption = {};              ///< middle of the name: of a polygon within it, of a line on it
    double captionRoom = 0; ///< metres: the width at `caption` that is free for the name; 0: of a point, which needs none
};

using ProjectedOverlay = std::vector<ProjectedShape>;

/// A ring around a pole is completed along the edge of the map.
ProjectedOverlay projectOverlay(const overlay::Overlay &overlay);

} // namespace skyseal::ui
