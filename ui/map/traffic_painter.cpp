#include "ui/map/traffic_painter.h"

#include "ui/map/map_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtGui/QPainter>
#include <QtGui/QPainterPath>
#include <QtGui/QTransform>

#include <cmath>
#include <iterator>

namespace skyseal::ui {

namespace {

/// From above, nose up: unlike the arrow of a vehicle it has wings and a tail.
QPainterPath aeroplane()
{
    QPainterPath out;
    const QPointF half[] = {{0, -12}, {2, -4}, {12, 3}, {12, 6}, {2, 3}, {1.5, 8}, {5, 11}, {5, 13}, {0, 11.5}};
    QPolygonF outline;
    for (const QPointF &point : half)
        outline << point;
    for (auto point = std::rbegin(half) + 1; point != std::rend(half) - 1; ++point)
        outline << QPointF(-point->x(), point->y());
    out.addPolygon(outline);
    out.closeSubpath();
    return out;
}

} // namespace

void TrafficPainter::paint(const TrafficContent &content, UnitSystem units)
{
    constexpr double kMargin = 100; // of a text beside the picture's edge
    const QRectF picture = QRectF(QPointF(), m_viewport.size()).adjusted(-kMargin, -kMargin, kMargin, kMargin);
    for (const AircraftMark &mark : content.marks())
        if (picture.contains(m_viewport.toPixels(mark.at)))
            paintAircraft(mark, units);
}

void TrafficPainter::paintAircraft(const AircraftMark &mark, UnitSystem units)
{
    const StateColors &colors = stateColors(m_palette);
    const QPointF at = m_viewport.toPixels(mark.at);
    QPainterPath shape;
    if (std::isfinite(mark.heading))
        shape = QTransform().rotate(mark.heading - m_viewport.heading()).map(aeroplane());
    else
        shape.addPolygon(QPolygonF{{0, -10}, {10, 0}, {0, 10}, {-10, 0}, {0, -10}});
    shape.translate(at);
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(QPen(m_palette.color(QPalette::Base), 4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    m_painter.drawPath(shape);
    m_painter.setPen(QPen(m_palette.color(QPalette::WindowText), 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    m_painter.setBrush(mark.sight.isNear ? colors.alarm : m_palette.color(QPalette::Base));
    m_painter.drawPath(shape);
    const QString text = aircraftText(mark.sight, units);
    const QFontMetricsF metrics(m_painter.font());
    paintLabel(m_painter, at + QPointF(0, 16 + metrics.height() / 2), text, m_palette);
}

} // namespace skyseal::ui
