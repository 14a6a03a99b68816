// Where a dialog stands that is about a point of the window: beside it, so that the point stays visible.
#pragma once

#include <QtCore/QPoint>
#include <QtCore/QRect>
#include <QtCore/QSize>

namespace skyseal::ui {

/// The upper left corner of a box of this size, frame included. `point` and `room`, the free part of the screen, are in global
/// coordinates. At the first side with room for the box: right, left, below, above; without any, in the corner farthest from
/// the point.
QPoint placeBeside(const QSize &box, const QPoint &point, const QRect &room);

} // namespace skyseal::ui
