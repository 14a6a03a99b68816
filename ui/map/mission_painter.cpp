#include "ui/map/mission_painter.h"

#include "ui/map/map_text.h"
#include "ui/theme/palettes.h"

#include <QtGui/QPainter>
#include <QtGui/QPainterPath>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

namespace {

constexpr double kStopRadius = 10, kLeastLoiter = 15; ///< pixels

double lengthOf(const QPointF &vector)
{
    return std::hypot(vector.x(), vector.y());
}

QString loiterText(const RouteStop &stop)
{
    switch (stop.loiter) {
    case RouteStop::Loiter::Unlimited: return QStringLiteral("∞");
    case RouteStop::Loiter::Turns: return QStringLiteral("×%1").arg(stop.amount);
    case RouteStop::Loiter::Time: return QStringLiteral("%1 s").arg(stop.amount);
    default: return {};
    }
}

} // namespace

void MissionPainter::paint(const MissionRoute &route, int current, bool outdated)
{
    paintLegs(route, outdated ? Qt::DashDotLine : Qt::SolidLine);
    for (const RouteStop &stop : route.stops)
        if (stop.loiter != RouteStop::Loiter::None)
            paintLoiter(stop);
    for (const RouteJump &jump : route.jumps) {
        const RouteStop *from = route.stopOf(jump.from), *to = route.stopOf(jump.to);
        if (from && to)
            paintJump(m_viewport.toPixels(from->at), m_viewport.toPixels(to->at), jump.times);
    }
    for (const RouteMark &mark : route.marks)
        paintMark(mark);
    for (const RouteStop &stop : route.stops)
        if (stop.sequence >= 0)
            paintStop(stop, stop.sequence == current);
    const auto first = std::ranges::find_if(route.stops, [](const RouteStop &stop) { return stop.sequence >= 0; });
    if (outdated && first != route.stops.end())
        paintLabel(m_painter, m_viewport.toPixels(first->at) - QPointF(0, 2.5 * kStopRadius), tr("outdated"), m_palette);
}

void MissionPainter::paintLegs(const MissionRoute &route, Qt::PenStyle style)
{
    const StateColors &colors = stateColors(m_palette);
    for (std::size_t i = 1; i < route.stops.size(); ++i) {
        const RouteStop &stop = route.stops[i];
        const QPointF from = m_viewport.toPixels(route.stops[i - 1].at), to = m_viewport.toPixels(stop.at);
        QPainterPath leg(from);
        QPointF arrival = to - from;
        if (stop.spline) {
            leg.cubicTo(m_viewport.toPixels(stop.controlIn), m_viewport.toPixels(stop.controlOut), to);
            arrival = to - m_viewport.toPixels(stop.controlOut);
        } else {
            leg.lineTo(to);
        }
        m_painter.setPen(QPen(colors.dim, 1.5, style));
        m_painter.setBrush(Qt::NoBrush);
        m_painter.drawPath(leg);
        const double length = lengthOf(arrival);
        if (leg.length() > 4 * kStopRadius && length > 0)
            paintArrow(to - arrival / length * (kStopRadius + 1), arrival / length);
    }
}

void MissionPainter::paintArrow(const QPointF &tip, const QPointF &direction)
{
    const QPointF back = tip - direction * 8, aside(-direction.y() * 4, direction.x() * 4);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(stateColors(m_palette).dim);
    m_painter.drawPolygon(QPolygonF{tip, back + aside, back - aside});
}

/// A bow beside the legs, so that a jump between neighbours does not hide the leg.
void MissionPainter::paintJump(const QPointF &from, const QPointF &to, int times)
{
    const QPointF way = to - from;
    const double length = lengthOf(way);
    const QString text = times < 0 ? QStringLiteral("↺ ∞") : QStringLiteral("↺ ×%1").arg(times);
    m_painter.setPen(QPen(stateColors(m_palette).accent, 1.5, Qt::DashLine));
    m_painter.setBrush(Qt::NoBrush);
    if (length < 1) {
        paintLabel(m_painter, from + QPointF(0, -2 * kStopRadius), text, m_palette);
        return;
    }
    const QPointF aside(-way.y() / length, way.x() / length);
    const QPointF bend = (from + to) / 2 + aside * std::min(0.25 * length, 80.0);
    QPainterPath bow(from);
    bow.quadTo(bend, to);
    m_painter.drawPath(bow);
    const QPointF arrival = (to - bend) / std::max(1.0, lengthOf(to - bend));
    paintArrow(to - arrival * (kStopRadius + 1), arrival);
    paintLabel(m_painter, bow.pointAtPercent(0.5), text, m_palette);
}

void MissionPainter::paintLoiter(const RouteStop &stop)
{
    const QPointF at = m_viewport.toPixels(stop.at);
    const double onMap = stop.radius * mercator::stretch(stop.at.y());
    const double radius = std::max(kLeastLoiter, onMap / m_viewport.metresPerPixel());
    m_painter.setPen(QPen(stateColors(m_palette).dim, 1.5, stop.radius > 0 ? Qt::SolidLine : Qt::DotLine));
    m_painter.setBrush(Qt::NoBrush);
    m_painter.drawEllipse(at, radius, radius);
    if (const QString text = loiterText(stop); !text.isEmpty())
        paintLabel(m_painter, at + QPointF(0, radius), text, m_palette);
}

void MissionPainter::paintStop(const RouteStop &stop, bool current)
{
    const StateColors &colors = stateColors(m_palette);
    const QPointF at = m_viewport.toPixels(stop.at);
    m_painter.setPen(QPen(current ? colors.accent : colors.dim, current ? 2.5 : 1.5));
    m_painter.setBrush(m_palette.color(QPalette::Base));
    m_painter.drawEllipse(at, kStopRadius, kStopRadius);
    m_painter.setPen(current ? colors.accent : m_palette.color(QPalette::WindowText));
    m_painter.drawText(QRectF(at.x() - 12, at.y() - 12, 24, 24), Qt::AlignCenter, QString::number(stop.sequence));
}

void MissionPainter::paintMark(const RouteMark &mark)
{
    const QPointF at = m_viewport.toPixels(mark.at);
    m_painter.setPen(QPen(stateColors(m_palette).dim, 1.5, Qt::DotLine));
    m_painter.setBrush(m_palette.color(QPalette::Base));
    m_painter.drawPolygon(QPolygonF{at + QPointF(0, -12), at + QPointF(12, 0), at + QPointF(0, 12), at + QPointF(-12, 0)});
    m_painter.setPen(m_palette.color(QPalette::WindowText));
    m_painter.drawText(QRectF(at.x() - 12, at.y() - 12, 24, 24), Qt::AlignCenter, QString::number(mark.sequence));
}

} // namespace skyseal::ui
