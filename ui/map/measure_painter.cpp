#include "ui/map/measure_painter.h"

#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtGui/QPainter>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

namespace {

/// `x` moved by whole turns around the globe, nearest to `to`.
double nearestTurn(double x, double to)
{
    constexpr double kTurn = 2 * mercator::kHalfWorld;
    return x + kTurn * std::round((to - x) / kTurn);
}

} // namespace

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
    for (qsizetype i = 1; i < set; ++i)
        paintLeg(all[i - 1], all[i], legText(tool.legs()[static_cast<std::size_t>(i - 1)], units), !wayOn && i + 1 == set);
    if (wayOn)
        paintLeg(all[set - 1], all[set], legText(geodesicBetween(tool.points().back(), *pointed), units), true);
    paintTotal(measuredText(tool, units));
}

/// Each near the one before it, and the first near the middle of the picture, so that no line goes around the globe.
QPolygonF MeasurePainter::pixelsOf(std::vector<LatLong> places) const
{
    QPolygonF out;
    double near = m_viewport.centre().x();
    for (const LatLong &place : places) {
        QPointF metres = mercator::project(place);
        metres.setX(nearestTurn(metres.x(), near));
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
    constexpr double kRadius = 4;
    m_painter.setPen(QPen(stateColors(m_palette).accent, 2));
    m_painter.setBrush(m_palette.color(QPalette::Base));
    m_painter.drawEllipse(at, kRadius, kRadius);
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
    const QFontMetricsF metrics(m_painter.font());
    const double width = metrics.horizontalAdvance(text) + 2 * kGrid, height = metrics.height() + kHalfGrid;
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    if (!always && length < width)
        return;
    // Aside from the line by half the text, upwards or to the right.
    QPointF aside = length > 0 ? QPointF(way.y(), -way.x()) / length : QPointF(0, -1);
    if (aside.y() > 0)
        aside = -aside;
    const QPointF middle = (from + to) / 2 + QPointF(aside.x() * (width / 2 + kGrid), aside.y() * (height / 2 + kGrid));
    QRectF place(0, 0, width, height);
    place.moveCenter(middle);
    paintCaption(place, {text});
}

/// At the top, where neither the coordinates of the grid nor the arrow to the north stand.
void MeasurePainter::paintTotal(const QString &total)
{
    QFont strong = m_painter.font();
    strong.setBold(true);
    const QString help = tr("Click or Return sets a point, Backspace removes the last, Esc ends");
    const QFontMetricsF metrics(strong);
    const double room = m_viewport.size().width() - 12 * kGrid;
    const double width = std::min(std::max(metrics.horizontalAdvance(total), metrics.horizontalAdvance(help)) + 2 * kGrid,
                                  room);
    const QRectF place((m_viewport.size().width() - width) / 2, 3 * kGrid, width, 2 * metrics.height() + kGrid);
    paintCaption(place, {total, QFontMetricsF(m_painter.font()).elidedText(help, Qt::ElideRight, width - kGrid)});
}

/// Text that can be read on any ground; of two lines, the first is bold.
void MeasurePainter::paintCaption(const QRectF &place, const QStringList &lines)
{
    QColor ground = m_palette.color(QPalette::Base);
    ground.setAlpha(225);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(ground);
    m_painter.drawRoundedRect(place, 3, 3);
    m_painter.setPen(m_palette.color(QPalette::WindowText));
    const double height = place.height() / static_cast<double>(lines.size());
    const QFont usual = m_painter.font();
    for (qsizetype i = 0; i < lines.size(); ++i) {
        QFont font = usual;
        font.setBold(lines.size() > 1 && i == 0);
        m_painter.setFont(font);
        m_painter.drawText(QRectF(place.left(), place.top() + height * static_cast<double>(i), place.width(), height),
                           Qt::AlignCenter, lines[i]);
    }
    m_painter.setFont(usual);
}

} // namespace skyseal::ui
