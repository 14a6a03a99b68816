// Paints the route of a mission on the map: legs with their direction, splines, loiters, jumps, and the numbers of the items.
#pragma once

#include "ui/map/map_viewport.h"
#include "ui/map/mission_route.h"

#include <QtCore/QCoreApplication>
#include <QtGui/QPalette>

class QPainter;

namespace skyseal::ui {

/// Made for one paint event; the references must outlive it.
class MissionPainter
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::MissionPainter)

public:
    MissionPainter(QPainter &painter, const MapViewport &viewport, const QPalette &palette)
        : m_painter(painter), m_viewport(viewport), m_palette(palette)
    {}

    /// `current`: sequence of the item that the vehicle executes; -1 if unknown. `outdated`: the vehicle may have another one.
    void paint(const MissionRoute &route, int current, bool outdated);

private:
    void paintLegs(const MissionRoute &route, Qt::PenStyle style);
    void paintJump(const QPointF &from, const QPointF &to, int times);
    void paintLoiter(const RouteStop &stop);
    void paintStop(const RouteStop &stop, bool current);
    void paintMark(const RouteMark &mark);
    void paintArrow(const QPointF &tip, const QPointF &direction);

    QPainter &m_painter;
    const MapViewport &m_viewport;
    const QPalette &m_palette;
};

} // namespace skyseal::ui
