#include "ui/map/measure_painter.h"

#include "ui/map/map_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtGui/QPainter>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

void MeasurePainter::paint(const MeasureTool &tool, const std::optional<LatLong> &pointed, UnitSystem units)
{
    std::vector<LatLong> places = tool.points();
    const auto set = static_cast<qsizetype>(places.size());
    if (pointed)
        places.push_back(*pointed);
    const QPolygonF all = pixelsOf(places);
    const bool wayOn = pointed && set > 0;
    if (wayOn)
        paintLine(QPolygonF{all[set - 1], all[set]}, Qt::DashLine);
    paintLine(all.first(set), Qt::SolidLine);
    for (qsizetype i = 0; i < set; ++i)
        paintPoint(all[i]);
    if (pointed)
        paintCross(all.last());
    if (wayOn)
        paintNextLeg(all.last(), legText(geodesicBetween(tool.points().back(), *pointed), units));
    for (qsizetype i = set - 1; i > 0; --i)
        paintLeg(all[i - 1], all[i], legText(tool.legs()[static_cast<std::size_t>(i - 1)], units), !wayOn && i + 1 == set);
    paintTotal(measuredText(tool, units));
}

/// Each near the one before it, and the first near the middle of the picture, so that no line goes around the globe.
QPolygonF MeasurePainter::pixelsOf(const std::vector<LatLong> &places) const
{
    QPolygonF out;
    double near = m_viewport.centre().x();
    for (const LatLong &place : places) {
        QPointF metres = mercator::project(place);
        metres.setX(mercator::nearestTurn(metres.x(), near));
        near = metres.x();
        out << m_viewport.toPixels(metres);
    }
    return out;
}

void MeasurePainter::paintLine(const QPolygonF &line, Qt::PenStyle style)
{
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(QPen(m_palette.color(QPalette::Base), 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    m_painter.drawPolyline(line);
    m_painter.setPen(QPen(stateColors(m_palette).accent, 2, style, Qt::RoundCap, Qt::RoundJoin));
    m_painter.drawPolyline(line);
}

void MeasurePainter::paintPoint(const QPointF &at)
{
    constexpr double kPointRadius = 4;
    m_painter.setPen(QPen(stateColors(m_palette).accent, 2));
    m_painter.setBrush(m_palette.color(QPalette::Base));
    m_painter.drawEllipse(at, kPointRadius, kPointRadius);
}

/// Where a key or a click sets the next point.
void MeasurePainter::paintCross(const QPointF &at)
{
    constexpr double kInner = 4, kOuter = 12;
    for (const bool halo : {true, false}) {
        m_painter.setPen(halo ? QPen(m_palette.color(QPalette::Base), 4) : QPen(m_palette.color(QPalette::WindowText), 1.5));
        for (const QPointF &arm : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            m_painter.drawLine(at + arm * kInner, at + arm * kOuter);
    }
}

/// Beside the middle of the leg, unless it is shorter than its text.
void MeasurePainter::paintLeg(const QPointF &from, const QPointF &to, const QString &text, bool always)
{
    QRectF place = captionFor(text);
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    if (!always && length < place.width())
        return;
    // Aside from the line by half the text, upwards or to the right.
    QPointF aside = length > 0 ? QPointF(way.y(), -way.x()) / length : QPointF(0, -1);
    if (aside.y() > 0)
        aside = -aside;
    place.moveCenter((from + to) / 2
                     + QPointF(aside.x() * (place.width() / 2 + kGrid), aside.y() * (place.height() / 2 + kGrid)));
    paintFreeCaption(place, text);
}

/// Beside the cross, and within the picture.
void MeasurePainter::paintNextLeg(const QPointF &cross, const QString &text)
{
    QRectF place = captionFor(text);
    place.moveTopLeft(cross + QPointF(1.5 * kGrid, 1.5 * kGrid));
    if (place.right() > m_viewport.size().width())
        place.moveRight(cross.x() - 1.5 * kGrid);
    if (place.bottom() > m_viewport.size().height())
        place.moveBottom(cross.y() - 1.5 * kGrid);
    paintFreeCaption(place, text);
}

/// At the top, between the corner and the arrow to the north; the help wraps where the map is narrow.
void MeasurePainter::paintTotal(const QString &total)
{
    const QFont usual = m_painter.font();
    QFont strong = usual;
    strong.setBold(true);
    const QString help = tr("Click or Enter sets a point, Backspace removes the last, Esc ends");
    const QFontMetricsF bold(strong), metrics(usual);
    const double room = std::max(m_viewport.size().width() - 14 * kGrid, 20.0 * kGrid);
    const QRectF lines = metrics.boundingRect(QRectF(0, 0, room, 1000), Qt::AlignHCenter | Qt::TextWordWrap, help);
    const double width = std::max(bold.horizontalAdvance(total), lines.width()) + 2 * kGrid;
    const QRectF place((m_viewport.size().width() - width) / 2, 3 * kGrid, width, bold.height() + lines.height() + kGrid);
    paintPlate(m_painter, place, m_palette);
    m_painter.setFont(strong);
    m_painter.drawText(place.adjusted(0, kHalfGrid, 0, 0), Qt::AlignHCenter | Qt::AlignTop, total);
    m_painter.setFont(usual);
    m_painter.drawText(place.adjusted(kGrid, 0, -kGrid, -kHalfGrid), Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap,
                       help);
}

QRectF MeasurePainter::captionFor(const QString &text) const
{
    const QFontMetricsF metrics(m_painter.font());
    return {0, 0, metrics.horizontalAdvance(text) + 2 * kGrid, metrics.height() + kHalfGrid};
}

/// Where it would overlap another one, the newer one stands alone.
void MeasurePainter::paintFreeCaption(const QRectF &place, const QString &text)
{
    if (std::ranges::any_of(m_taken, [&place](const QRectF &other) { return other.intersects(place); }))
        return;
    m_taken.push_back(place);
    paintCaption(m_painter, place, text, m_palette);
}

} // namespace skyseal::ui
