// The arrow at the edge of the map that points to the selected vehicle while it is beyond the edge, with its number and its
// distance from the centre of the map. A click on it centres the map on the vehicle.
#pragma once

#include "ui/text/units.h"

#include <QtCore/QPointF>
#include <QtCore/QRectF>
#include <QtCore/QString>

#include <optional>

class QFontMetricsF;
class QPainter;
class QPalette;

namespace skyseal::ui {

class MapContent;
class MapViewport;

/// Pixels.
struct EdgeArrow
{
    QPointF tip;
    QPointF direction; ///< of length 1
    QRectF caption;
    QString text;     ///< "Vehicle 1 · 320 m"
    QString distance; ///< "320 m"

    /// Whether a finger on this pixel means the arrow.
    bool contains(const QPointF &pixel) const;
};

/// nullopt while the selected vehicle is on the map, and without one.
std::optional<EdgeArrow> edgeArrowOf(const MapContent &content, const MapViewport &viewport, UnitSystem units,
                                     const QFontMetricsF &metrics);

void paintEdgeArrow(QPainter &painter, const EdgeArrow &arrow, const QPalette &palette);

} // namespace skyseal::ui
