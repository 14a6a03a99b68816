// Cuts lines to the picture. The painter of Qt takes long for what lies far outside of it, and not beyond 2^23 pixels.
#pragma once

#include <QtCore/QRectF>
#include <QtGui/QPolygonF>

#include <vector>

namespace skyseal::ui {

/// The part of a closed ring that lies in `area`; where the ring is outside, its cut runs along the edge (Sutherland, Hodgman).
QPolygonF clipRing(QPolygonF ring, const QRectF &area);

/// The pieces of a line that lie in `area` (Liang, Barsky).
std::vector<QPolygonF> clipLine(const QPolygonF &line, const QRectF &area);

} // namespace skyseal::ui
