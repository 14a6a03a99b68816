// The painting of MapView.
#include "ui/map/map_view.h"

#include "core/mavlink/enums.h"
#include "ui/text/units.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"
#include "ui/theme/suite_style.h"

#include <QtGui/QPainter>
#include <QtGui/QPainterPath>

#include <cmath>

namespace skyseal::ui {

namespace {

/// 1, 2 or 5 times a power of ten, at least `least`.
double niceStep(double least)
{
    const double power = std::pow(10, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (power * factor >= least)
            return power * factor;
    return power * 10;
}

QString lengthText(double metres)
{
    return metres >= 1000 ? QStringLiteral("%1 km").arg(metres / 1000) : QStringLiteral("%1 m").arg(metres);
}

} // namespace

void MapView::paintEvent(QPaintEvent *)
{
    if (m_groundDirty)
        paintGround();
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_ground);
    painter.setRenderHint(QPainter::Antialiasing);
    paintVehicle(painter);
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void MapView::paintGround()
{
    const qreal ratio = devicePixelRatioF();
    const QSize wanted = size() * ratio;
    if (m_ground.size() != wanted) {
        m_ground = QPixmap(wanted);
        m_ground.setDevicePixelRatio(ratio);
    }
    m_groundDirty = false;
    const StateColors &colors = stateColors(palette());
    m_ground.fill(palette().color(QPalette::Base));
    QPainter painter(&m_ground);
    const double step = niceStep(64 * m_metresPerPixel);
    const double left = m_centre.x() - width() / 2.0 * m_metresPerPixel,
                 bottom = m_centre.y() - height() / 2.0 * m_metresPerPixel;
    const QColor major = colors.line;
    for (double x = std::floor(left / step) * step; toPixels({x, 0}).x() < width(); x += step) {
        painter.setPen(std::lround(x / step) % 5 == 0 ? major : colors.grid);
        const double at = std::floor(toPixels({x, 0}).x()) + 0.5;
        painter.drawLine(QPointF(at, 0), QPointF(at, height()));
    }
    for (double y = std::floor(bottom / step) * step; toPixels({0, y}).y() > 0; y += step) {
        painter.setPen(std::lround(y / step) % 5 == 0 ? major : colors.grid);
        const double at = std::floor(toPixels({0, y}).y()) + 0.5;
        painter.drawLine(QPointF(0, at), QPointF(width(), at));
    }
    painter.setRenderHint(QPainter::Antialiasing);
    paintMission(painter);
    paintTrack(painter);
    paintHome(painter);
    paintFurniture(painter);
}

void MapView::paintTrack(QPainter &painter) const
{
    const auto &points = m_track.points();
    std::size_t i = 0;
    while (i + 1 < points.size()) {
        QPolygonF line;
        const crypto::SuiteId suite = points[i].suite;
        line << toPixels(points[i].metres);
        while (i + 1 < points.size() && points[i].suite == suite) {
            const QPointF next = toPixels(points[++i].metres);
            if ((next - line.back()).manhattanLength() >= 1.0 || points[i].suite != suite)
                line << next;
        }
        painter.setPen(QPen(suiteColor(suite), 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(line);
    }
}

void MapView::paintMission(QPainter &painter) const
{
    if (!m_mission || !m_frame)
        return;
    const StateColors &colors = stateColors(palette());
    QPolygonF route;
    for (const vehicle::MissionItem &item : *m_mission) {
        const bool hasPlace = item.command == mavlink::MAV_CMD_NAV_WAYPOINT || item.command == mavlink::MAV_CMD_NAV_LAND
            || item.command == mavlink::MAV_CMD_NAV_TAKEOFF;
        if (!hasPlace || item.sequence == 0 || (item.latitude == 0 && item.longitude == 0))
            continue; // item 0 is home
        route << toPixels(m_frame->toMetres(item.latitude, item.longitude));
    }
    painter.setPen(QPen(colors.dim, 1.5, Qt::DashLine));
    painter.drawPolyline(route);
    for (const vehicle::MissionItem &item : *m_mission) {
        if (item.sequence == 0 || (item.latitude == 0 && item.longitude == 0))
            continue;
        const QPointF at = toPixels(m_frame->toMetres(item.latitude, item.longitude));
        const bool current = item.sequence == m_missionCurrent;
        painter.setPen(QPen(current ? colors.accent : colors.dim, current ? 2.5 : 1.5));
        painter.setBrush(palette().color(QPalette::Base));
        painter.drawEllipse(at, 10, 10);
        painter.setPen(current ? colors.accent : palette().color(QPalette::WindowText));
        painter.drawText(QRectF(at.x() - 12, at.y() - 12, 24, 24), Qt::AlignCenter, QString::number(item.sequence));
    }
}

void MapView::paintHome(QPainter &painter) const
{
    if (!m_home)
        return;
    const QPointF at = toPixels(*m_home);
    QPainterPath house;
    house.moveTo(at + QPointF(0, -9));
    house.lineTo(at + QPointF(9, -1));
    house.lineTo(at + QPointF(6, -1));
    house.lineTo(at + QPointF(6, 7));
    house.lineTo(at + QPointF(-6, 7));
    house.lineTo(at + QPointF(-6, -1));
    house.lineTo(at + QPointF(-9, -1));
    house.closeSubpath();
    painter.setPen(QPen(palette().color(QPalette::WindowText), 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawPath(house);
}

void MapView::paintVehicle(QPainter &painter) const
{
    if (!m_vehicle)
        return;
    const StateColors &colors = stateColors(palette());
    painter.save();
    painter.translate(toPixels(*m_vehicle));
    painter.rotate(m_heading);
    QPainterPath arrow;
    arrow.moveTo(0, -15);
    arrow.lineTo(10, 12);
    arrow.lineTo(0, 6);
    arrow.lineTo(-10, 12);
    arrow.closeSubpath();
    painter.setPen(QPen(palette().color(QPalette::Base), 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(arrow);
    painter.setPen(QPen(palette().color(QPalette::WindowText), 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(m_stale ? colors.dim : suiteColor(m_suite));
    painter.drawPath(arrow);
    painter.restore();
}

void MapView::paintFurniture(QPainter &painter) const
{
    const QColor ink = palette().color(QPalette::WindowText);
    const QFontMetricsF metrics(painter.font());
    const double bar = niceStep(60 * m_metresPerPixel);
    const double length = bar / m_metresPerPixel;
    const double right = width() - 2.0 * kGrid, y = height() - 2.0 * kGrid;
    painter.setPen(QPen(ink, 1.5));
    painter.drawPolyline(
        QPolygonF{QPointF(right - length, y - 5), QPointF(right - length, y), QPointF(right, y), QPointF(right, y - 5)});
    const QString text = lengthText(bar);
    painter.drawText(QPointF(right - length / 2 - metrics.horizontalAdvance(text) / 2, y - 8), text);

    const QPointF north(width() - 3.0 * kGrid, 5.0 * kGrid);
    QPainterPath needle;
    needle.moveTo(north + QPointF(0, -12));
    needle.lineTo(north + QPointF(5, 4));
    needle.lineTo(north + QPointF(0, 1));
    needle.lineTo(north + QPointF(-5, 4));
    needle.closeSubpath();
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.drawPath(needle);
    painter.setPen(ink);
    painter.drawText(QRectF(north.x() - 12, north.y() + 4, 24, 18), Qt::AlignCenter, tr("N"));
}

} // namespace skyseal::ui
