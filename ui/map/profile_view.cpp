#include "ui/map/profile_view.h"

#include "ui/map/axis_ticks.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtCore/QEvent>
#include <QtGui/QPainter>

#include <algorithm>
#include <cmath>
#include <limits>

namespace skyseal::ui {

namespace {

constexpr double kRadius = 9;                        ///< pixels: circle of a point
constexpr double kRowHeight = 32, kColumnWidth = 96; ///< pixels between two lines of the grid, at least
constexpr double kLeastRange = 10;                   ///< metres, so that a level route is a level line
constexpr double kLeastLength = 10;                  ///< metres, of a route of one point

} // namespace

ProfileView::ProfileView(QWidget *parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("profileView"));
    setAccessibleName(tr("Altitude profile of the mission"));
}

void ProfileView::showProfile(std::vector<ProfilePoint> points, int current)
{
    m_points = std::move(points);
    m_current = current;
    setAccessibleDescription(summary());
    setToolTip(summary());
    update();
}

void ProfileView::setUnits(UnitSystem units)
{
    m_units = units;
    setAccessibleDescription(summary());
    setToolTip(summary());
    update();
}

QString ProfileView::summary() const
{
    if (m_points.empty())
        return {};
    double highest = std::numeric_limits<double>::quiet_NaN();
    for (const ProfilePoint &point : m_points)
        if (!point.overTerrain)
            highest = std::fmax(highest, point.altitude);
    const QString length = distanceFigure(m_points.back().distance, m_units).text();
    return std::isnan(highest) ? length : tr("%1 · highest %2 above home").arg(length, altitudeFigure(highest, m_units).text());
}

ProfileView::Range ProfileView::range() const
{
    Range range{m_points.empty() ? 0 : m_points.back().distance, 0, kLeastRange};
    for (const ProfilePoint &point : m_points) {
        if (std::isnan(point.altitude))
            continue;
        range.lowest = std::min(range.lowest, point.altitude);
        range.highest = std::max(range.highest, point.altitude);
    }
    const double margin = 0.1 * (range.highest - range.lowest);
    range.highest += margin;
    if (range.lowest < 0)
        range.lowest -= margin;
    range.length = std::max(range.length, kLeastLength);
    return range;
}

QSize ProfileView::minimumSizeHint() const
{
    return {30 * kGrid, 12 * kGrid};
}

void ProfileView::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Range shown = range();
    const QFontMetricsF metrics(font());
    const auto widthOf = [&](double altitude) { return metrics.horizontalAdvance(altitudeFigure(altitude, m_units).text()); };
    const double labels = std::max(widthOf(shown.highest), widthOf(shown.lowest)) + kRadius + kGrid;
    const QRectF area = QRectF(rect()).adjusted(labels, kGrid, -2 * kGrid, -metrics.height() - kHalfGrid);
    if (area.width() <= 0 || area.height() <= 0)
        return;
    paintGrid(painter, area, shown);
    std::vector<QPointF> places;
    places.reserve(m_points.size());
    for (const ProfilePoint &point : m_points)
        places.emplace_back(area.left() + area.width() * point.distance / shown.length,
                            area.bottom() - area.height() * (point.altitude - shown.lowest) / (shown.highest - shown.lowest));
    paintLine(painter, places);
    paintPoints(painter, places);
}

void ProfileView::paintGrid(QPainter &painter, const QRectF &area, const Range &range)
{
    const StateColors &colors = stateColors(palette());
    const double height = QFontMetricsF(font()).height();
    const auto line = [&](const QPointF &from, const QPointF &to) {
        painter.setPen(QPen(colors.line, 1));
        painter.drawLine(from, to);
        painter.setPen(colors.dim);
    };
    const double rise = range.highest - range.lowest;
    for (const AxisTick &tick :
         axisTicks(range.lowest, range.highest, rise * kRowHeight / area.height(), altitudeScale(m_units))) {
        const double y = std::floor(area.bottom() - area.height() * (tick.value - range.lowest) / rise) + 0.5;
        line({area.left(), y}, {area.right(), y});
        painter.drawText(QRectF(0, y - height / 2, area.left() - kRadius - kHalfGrid, height),
                         Qt::AlignRight | Qt::AlignVCenter, tick.text);
    }
    const UnitScale ways = distanceScale(range.length, m_units); // one unit along the axis
    for (const AxisTick &tick : axisTicks(0, range.length, range.length * kColumnWidth / area.width(), ways)) {
        const double x = std::floor(area.left() + area.width() * tick.value / range.length) + 0.5;
        line({x, area.top()}, {x, area.bottom()});
        painter.drawText(QRectF(x - kColumnWidth / 2, area.bottom() + kHalfGrid, kColumnWidth, height), Qt::AlignCenter,
                         tick.text);
    }
}

void ProfileView::paintLine(QPainter &painter, const std::vector<QPointF> &places)
{
    const StateColors &colors = stateColors(palette());
    for (std::size_t i = 1; i < places.size(); ++i) {
        if (std::isnan(places[i - 1].y()) || std::isnan(places[i].y()))
            continue; // an interrupted line says that the altitude is not known
        const bool overTerrain = m_points[i - 1].overTerrain || m_points[i].overTerrain;
        painter.setPen(QPen(colors.accent, 2, overTerrain ? Qt::DotLine : Qt::SolidLine));
        painter.drawLine(places[i - 1], places[i]);
    }
}

void ProfileView::paintPoints(QPainter &painter, const std::vector<QPointF> &places)
{
    const StateColors &colors = stateColors(palette());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const ProfilePoint &point = m_points[i];
        if (point.sequence < 0 || std::isnan(places[i].y()))
            continue;
        const bool current = point.sequence == m_current;
        painter.setPen(QPen(current ? colors.accent : colors.dim, current ? 2.5 : 1.5));
        painter.setBrush(palette().color(QPalette::Base));
        painter.drawEllipse(places[i], kRadius, kRadius);
        painter.setPen(current ? colors.accent : palette().color(QPalette::WindowText));
        const QPointF corner(2 * kRadius, kRadius);
        painter.drawText(QRectF(places[i] - corner, places[i] + corner), Qt::AlignCenter, QString::number(point.sequence));
    }
}

void ProfileView::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        update();
}

} // namespace skyseal::ui

#include "moc_profile_view.cpp"
