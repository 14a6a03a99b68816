// The moving scales beside and under the artificial horizon.
#pragma once

#include <QtCore/QRectF>
#include <QtGui/QColor>

class QPainter;

namespace skyseal::ui {

struct TapeStyle
{
    QColor back, ink, dim, box;
};

/// A vertical scale that slides behind a fixed box with the value. `pixelsPerUnit` and `step` set its density;
/// `boxOnLeft` puts the box's pointer on the side of the horizon.
void paintVerticalTape(QPainter &painter, const QRectF &area, double value, double step, double pixelsPerUnit, int decimals,
                       bool pointsRight, const TapeStyle &style);

/// The compass: degrees with N, E, S and W, sliding behind a fixed mark.
void paintCompassTape(QPainter &painter, const QRectF &area, double heading, const TapeStyle &style);

} // namespace skyseal::ui
