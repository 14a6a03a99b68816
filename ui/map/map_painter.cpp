#include "ui/map/map_painter.h"

#include "ui/map/mission_painter.h"
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

/// A length for the scale bar: its text and its metres.
struct ScaleBar
{
    QString text;
    double metres;
};

/// The shortest round length of at least `least` metres.
ScaleBar scaleBar(double least, UnitSystem units)
{
    constexpr double kMetresPerFoot = 0.3048, kFeetPerMile = 5280;
    if (units == UnitSystem::Metric) {
        const double metres = niceStep(least);
        return {metres >= 1000 ? QStringLiteral("%1 km").arg(metres / 1000) : QStringLiteral("%1 m").arg(metres), metres};
    }
    if (const double feet = niceStep(least / kMetresPerFoot); feet < kFeetPerMile)
        return {QStringLiteral("%1 ft").arg(feet), feet * kMetresPerFoot};
    const double miles = niceStep(least / kMetresPerFoot / kFeetPerMile);
    return {QStringLiteral("%1 mi").arg(miles), miles * kFeetPerMile * kMetresPerFoot};
}

} // namespace

MapPainter::MapPainter(QPainter &painter, const MapContent &content, const MapViewport &viewport, const QPalette &palette)
    : m_painter(painter), m_content(content), m_viewport(viewport), m_palette(palette)
{}

void MapPainter::paintGround(UnitSystem units)
{
    paintGrid();
    m_painter.setRenderHint(QPainter::Antialiasing);
    paintMission();
    paintTrack();
    paintHome();
    paintScale(units);
    paintNorth();
}

void MapPainter::paintGrid()
{
    const StateColors &colors = stateColors(m_palette);
    const double width = m_viewport.size().width(), height = m_viewport.size().height();
    const double metres = m_viewport.metresPerPixel();
    const double step = niceStep(64 * metres);
    const double left = m_viewport.centre().x() - width / 2 * metres, bottom = m_viewport.centre().y() - height / 2 * metres;
    const auto inkAt = [&](double place) { return std::lround(place / step) % 5 == 0 ? colors.line : colors.grid; };
    for (double x = std::floor(left / step) * step; m_viewport.toPixels({x, 0}).x() < width; x += step) {
        m_painter.setPen(inkAt(x));
        const double at = std::floor(m_viewport.toPixels({x, 0}).x()) + 0.5;
        m_painter.drawLine(QPointF(at, 0), QPointF(at, height));
    }
    for (double y = std::floor(bottom / step) * step; m_viewport.toPixels({0, y}).y() > 0; y += step) {
        m_painter.setPen(inkAt(y));
        const double at = std::floor(m_viewport.toPixels({0, y}).y()) + 0.5;
        m_painter.drawLine(QPointF(0, at), QPointF(width, at));
    }
}

void MapPainter::paintTrack()
{
    const auto &points = m_content.track().points();
    std::size_t i = 0;
    while (i + 1 < points.size()) {
        QPolygonF line;
        const crypto::SuiteId suite = points[i].suite;
        line << m_viewport.toPixels(points[i].metres);
        if (points[i + 1].begins) { // nothing is known of the way between
            ++i;
            continue;
        }
        while (i + 1 < points.size() && points[i].suite == suite && !points[i + 1].begins) {
            const QPointF next = m_viewport.toPixels(points[++i].metres);
            if ((next - line.back()).manhattanLength() >= 1.0 || points[i].suite != suite)
                line << next;
        }
        m_painter.setPen(QPen(suiteColor(suite), 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        m_painter.drawPolyline(line);
    }
}

void MapPainter::paintMission()
{
    if (const auto &route = m_content.route())
        MissionPainter(m_painter, m_viewport, m_palette).paint(*route, m_content.missionCurrent());
}

void MapPainter::paintHome()
{
    if (!m_content.home())
        return;
    const QPointF at = m_viewport.toPixels(*m_content.home());
    QPainterPath house;
    house.moveTo(at + QPointF(0, -9));
    house.lineTo(at + QPointF(9, -1));
    house.lineTo(at + QPointF(6, -1));
    house.lineTo(at + QPointF(6, 7));
    house.lineTo(at + QPointF(-6, 7));
    house.lineTo(at + QPointF(-6, -1));
    house.lineTo(at + QPointF(-9, -1));
    house.closeSubpath();
    m_painter.setPen(QPen(m_palette.color(QPalette::WindowText), 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    m_painter.setBrush(m_palette.color(QPalette::Base));
    m_painter.drawPath(house);
}

void MapPainter::paintVehicle()
{
    if (!m_content.vehicle())
        return;
    const StateColors &colors = stateColors(m_palette);
    m_painter.save();
    m_painter.translate(m_viewport.toPixels(*m_content.vehicle()));
    m_painter.rotate(m_content.heading());
    QPainterPath arrow;
    arrow.moveTo(0, -15);
    arrow.lineTo(10, 12);
    arrow.lineTo(0, 6);
    arrow.lineTo(-10, 12);
    arrow.closeSubpath();
    m_painter.setPen(QPen(m_palette.color(QPalette::Base), 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    m_painter.setBrush(Qt::NoBrush);
    m_painter.drawPath(arrow);
    m_painter.setPen(QPen(m_palette.color(QPalette::WindowText), 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    m_painter.setBrush(m_content.isStale() ? colors.dim : suiteColor(m_content.suite()));
    m_painter.drawPath(arrow);
    m_painter.restore();
}

void MapPainter::paintScale(UnitSystem units)
{
    const QFontMetricsF metrics(m_painter.font());
    const auto [text, metres] = scaleBar(60 * m_viewport.metresPerPixel(), units);
    const double length = metres / m_viewport.metresPerPixel();
    const double right = m_viewport.size().width() - 2.0 * kGrid, y = m_viewport.size().height() - 2.0 * kGrid;
    m_painter.setPen(QPen(m_palette.color(QPalette::WindowText), 1.5));
    m_painter.drawPolyline(
        QPolygonF{QPointF(right - length, y - 5), QPointF(right - length, y), QPointF(right, y), QPointF(right, y - 5)});
    m_painter.drawText(QPointF(right - length / 2 - metrics.horizontalAdvance(text) / 2, y - 8), text);
}

void MapPainter::paintNorth()
{
    const QColor ink = m_palette.color(QPalette::WindowText);
    const QPointF north(m_viewport.size().width() - 3.0 * kGrid, 5.0 * kGrid);
    QPainterPath needle;
    needle.moveTo(north + QPointF(0, -12));
    needle.lineTo(north + QPointF(5, 4));
    needle.lineTo(north + QPointF(0, 1));
    needle.lineTo(north + QPointF(-5, 4));
    needle.closeSubpath();
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(ink);
    m_painter.drawPath(needle);
    m_painter.setPen(ink);
    m_painter.drawText(QRectF(north.x() - 12, north.y() + 4, 24, 18), Qt::AlignCenter, tr("N"));
}

} // namespace skyseal::ui
