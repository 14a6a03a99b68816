#include "ui/map/map_painter.h"

#include "ui/map/clip.h"
#include "ui/map/fence_painter.h"
#include "ui/map/map_text.h"
#include "ui/map/mission_painter.h"
#include "ui/map/overlay_painter.h"
#include "ui/map/scale_bar.h"
#include "ui/map/tile_painter.h"
#include "ui/map/track_scale.h"
#include "ui/text/figures.h"
#include "ui/text/units.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"
#include "ui/theme/suite_style.h"

#include <QtGui/QPainter>
#include <QtGui/QPainterPath>

#include <algorithm>
#include <cmath>
#include <optional>

namespace skyseal::ui {

namespace {

constexpr double kNameOffset = 16; ///< pixels below the middle of a vehicle

} // namespace

MapPainter::MapPainter(QPainter &painter, const MapContent &content, const MapViewport &viewport, const QPalette &palette)
    : m_painter(painter), m_content(content), m_viewport(viewport), m_palette(palette)
{}

void MapPainter::paintGround(const TileLayer &tiles, const OverlayModel &overlays, const FenceContent &fence, bool moving)
{
    const Graticule graticule = graticuleOf(m_viewport);
    paintGraticule(graticule);
    if (tiles.isOn()) {
        m_painter.setRenderHint(QPainter::SmoothPixmapTransform, !moving);
        TilePainter(m_painter, tiles, m_viewport).paint();
    } else {
        paintLabels(graticule);
    }
    m_painter.setRenderHint(QPainter::Antialiasing);
    OverlayPainter(m_painter, m_viewport, m_palette).paint(overlays);
    FencePainter(m_painter, m_viewport, m_palette).paint(fence);
    paintMission();
    paintTrack();
    paintHome();
}

void MapPainter::paintLegends(const TileLayer &tiles, UnitSystem units)
{
    paintScale(units);
    paintNorth();
    paintTrackScale(units, paintAttribution(tiles));
}

void MapPainter::paintGraticule(const Graticule &graticule)
{
    const StateColors &colors = stateColors(m_palette);
    m_painter.setRenderHint(QPainter::Antialiasing, m_viewport.isRotated());
    for (const auto *lines : {&graticule.meridians, &graticule.parallels}) {
        for (const GraticuleLine &one : *lines) {
            QLineF line = one.line;
            if (!m_viewport.isRotated()) // on whole pixels
                line.translate(std::floor(line.x1()) + 0.5 - line.x1(), std::floor(line.y1()) + 0.5 - line.y1());
            m_painter.setPen(one.strong ? colors.line : colors.grid);
            m_painter.drawLine(line);
        }
    }
    m_painter.setRenderHint(QPainter::Antialiasing, false);
}

/// Upright, where the meridians enter the picture in the north and the parallels in the west: with north up along the upper and
/// the left edge, where nothing else stands.
void MapPainter::paintLabels(const Graticule &graticule)
{
    const QFontMetricsF metrics(m_painter.font());
    const QRectF picture = QRectF(QPointF(), m_viewport.size());
    const QRectF inner = picture.adjusted(kHalfGrid, kHalfGrid, -kHalfGrid, -kHalfGrid);
    constexpr QSizeF kScaleBar(26 * kGrid, 5 * kGrid); // in the lower right corner
    std::vector<QRectF> taken{QRectF(picture.bottomRight() - QPointF(kScaleBar.width(), kScaleBar.height()), kScaleBar)};
    m_painter.setPen(stateColors(m_palette).dim);
    const auto paint = [&](const GraticuleLine &line, bool above) {
        const auto pieces = clipLine(QPolygonF{line.line.p1(), line.line.p2()}, picture);
        if (pieces.empty())
            return;
        const QPointF at = pieces.front().front();
        QRectF place(at.x() + kHalfGrid, at.y() + (above ? -kHalfGrid - metrics.ascent() : kHalfGrid),
                     metrics.horizontalAdvance(line.label), metrics.height());
        place.moveLeft(std::clamp(place.left(), inner.left(), std::max(inner.left(), inner.right() - place.width())));
        place.moveTop(std::clamp(place.top(), inner.top(), std::max(inner.top(), inner.bottom() - place.height())));
        const QRectF room = place.adjusted(-kHalfGrid, 0, kHalfGrid, 0);
        if (std::ranges::any_of(taken, [&room](const QRectF &other) { return other.intersects(room); }))
            return;
        taken.push_back(room);
        m_painter.drawText(QPointF(place.left(), place.top() + metrics.ascent()), line.label);
    };
    for (const GraticuleLine &meridian : graticule.meridians)
        paint(meridian, false);
    for (const GraticuleLine &parallel : graticule.parallels)
        paint(parallel, true);
}

void MapPainter::paintTrack()
{
    const auto &points = m_content.track().points();
    std::optional<TrackScale> scale;
    if (m_content.trackColors() != TrackColors::Suite)
        scale.emplace(m_content.track(), m_content.trackColors());
    const auto colorAt = [&](std::size_t i) { return scale ? scale->colorOf(points[i]) : suiteColor(points[i].suite); };
    std::size_t i = 0;
    while (i + 1 < points.size()) {
        QPolygonF line;
        const QColor color = colorAt(i);
        line << m_viewport.toPixels(points[i].metres);
        if (points[i + 1].begins) { // nothing is known of the way between
            ++i;
            continue;
        }
        bool same = true;
        while (i + 1 < points.size() && same && !points[i + 1].begins) {
            const QPointF next = m_viewport.toPixels(points[++i].metres);
            same = colorAt(i) == color;
            if ((next - line.back()).manhattanLength() >= 1.0 || !same)
                line << next;
        }
        m_painter.setPen(QPen(color, 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        m_painter.drawPolyline(line);
    }
}

/// The colours of the track, from the lowest to the highest value, in the lower left corner.
void MapPainter::paintTrackScale(UnitSystem units, double bottom)
{
    const TrackColors colors = m_content.trackColors();
    if (colors == TrackColors::Suite || m_content.track().points().empty())
        return;
    const TrackScale scale(m_content.track(), colors);
    const auto text = [&](double value) {
        return colors == TrackColors::Altitude ? altitudeFigure(value, units).text()
            : colors == TrackColors::Speed     ? speedFigure(value, units).text()
                                               : number(value, 0) + QStringLiteral(" %");
    };
    const QString name = colors == TrackColors::Altitude ? tr("altitude")
        : colors == TrackColors::Speed                   ? tr("speed")
                                                         : tr("link quality");
    const QString low = name + QLatin1Char(' ') + text(scale.low()), high = text(scale.high());
    constexpr double kStepWidth = 2 * kGrid, kStepHeight = kHalfGrid;
    const QFontMetricsF metrics(m_painter.font());
    const double height = metrics.height() + kHalfGrid, top = bottom - height, lowWidth = metrics.horizontalAdvance(low);
    const double ramp = TrackScale::kSteps * kStepWidth;
    const QRectF box(kHalfGrid, top, lowWidth + ramp + metrics.horizontalAdvance(high) + 4 * kGrid, height);
    paintCaption(m_painter, box, {}, m_palette);
    const QRectF inner = box.adjusted(kGrid, 0, -kGrid, 0);
    m_painter.setPen(m_palette.color(QPalette::WindowText));
    m_painter.drawText(inner, Qt::AlignLeft | Qt::AlignVCenter, low);
    m_painter.drawText(inner, Qt::AlignRight | Qt::AlignVCenter, high);
    for (int step = 0; step < TrackScale::kSteps; ++step)
        m_painter.fillRect(QRectF(inner.left() + lowWidth + kGrid + step * kStepWidth, inner.center().y() - kStepHeight / 2,
                                  kStepWidth, kStepHeight),
                           scale.colorOfStep(step));
}

void MapPainter::paintMission()
{
    if (const auto &route = m_content.route())
        MissionPainter(m_painter, m_viewport, m_palette).paint(*route, m_content.missionCurrent(), m_content.isRouteOutdated());
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

void MapPainter::paintVehicles()
{
    constexpr double kSmall = 0.75; // of the selected one
    const StateColors &colors = stateColors(m_palette);
    const auto fill = [&colors](std::optional<crypto::SuiteId> suite, bool isStale) {
        return isStale ? colors.dim : suiteColor(suite.value_or(crypto::SuiteId::None));
    };
    const QRectF picture = QRectF(QPointF(), m_viewport.size()).adjusted(-kNameOffset, -kNameOffset, kNameOffset, kNameOffset);
    Names names;
    if (const auto &selected = m_content.vehicle(); selected && !m_content.others().empty())
        names.emplace_back(m_viewport.toPixels(*selected),
                           markerText(m_content.systemId(), m_content.suite(), m_content.age()));
    for (const VehicleMarker &other : m_content.others()) {
        const QPointF at = m_viewport.toPixels(other.metres);
        if (!picture.contains(at))
            continue;
        paintArrow(at, other.heading, kSmall, fill(other.suite, other.isStale()));
        names.emplace_back(at, markerText(other.systemId, other.suite, other.age));
    }
    if (m_content.vehicle())
        paintArrow(m_viewport.toPixels(*m_content.vehicle()), m_content.heading(), 1,
                   fill(m_content.suite(), m_content.isStale()));
    for (const auto &[place, text] : placesOfNames(names, QFontMetricsF(m_painter.font())))
        paintCaption(m_painter, place, text, m_palette);
}

/// Below each vehicle; where several stand at one place, below each other, as many as can be read there.
std::vector<std::pair<QRectF, QString>> MapPainter::placesOfNames(const Names &names, const QFontMetricsF &metrics)
{
    constexpr int kMostBelow = 4;
    std::vector<std::pair<QRectF, QString>> out;
    for (const auto &[at, text] : names) {
        const double width = metrics.horizontalAdvance(text) + kGrid;
        QRectF place(at.x() - width / 2, at.y() + kNameOffset, width, metrics.height());
        const auto isTaken = [&] {
            return std::ranges::any_of(out, [&place](const auto &other) { return other.first.intersects(place); });
        };
        for (int row = 1; row < kMostBelow && isTaken(); ++row)
            place.translate(0, metrics.height() + 1);
        if (!isTaken())
            out.emplace_back(place, text);
    }
    return out;
}

/// `heading` in degrees; NaN paints a disc.
void MapPainter::paintArrow(const QPointF &at, double heading, double size, const QColor &fill)
{
    m_painter.save();
    m_painter.translate(at);
    m_painter.scale(size, size);
    QPainterPath arrow;
    if (std::isfinite(heading))
        m_painter.rotate(heading - m_viewport.heading());
    else
        arrow.addEllipse(QPointF(), 10, 10);
    if (arrow.isEmpty()) {
        arrow.moveTo(0, -15);
        arrow.lineTo(10, 12);
        arrow.lineTo(0, 6);
        arrow.lineTo(-10, 12);
        arrow.closeSubpath();
    }
    m_painter.setPen(QPen(m_palette.color(QPalette::Base), 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    m_painter.setBrush(Qt::NoBrush);
    m_painter.drawPath(arrow);
    m_painter.setPen(QPen(m_palette.color(QPalette::WindowText), 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    m_painter.setBrush(fill);
    m_painter.drawPath(arrow);
    m_painter.restore();
}

void MapPainter::paintTarget(const QPointF &metres, const QString &label)
{
    if (m_content.vehicle()) {
        m_painter.setPen(QPen(stateColors(m_palette).accent, 2, Qt::DashLine));
        m_painter.drawLine(m_viewport.toPixels(*m_content.vehicle()), m_viewport.toPixels(metres));
    }
    paintMark(metres, label);
}

void MapPainter::paintMark(const QPointF &metres, const QString &label)
{
    const QPointF at = m_viewport.toPixels(metres);
    constexpr double kRadius = 9, kArm = 16;
    for (const bool halo : {true, false}) {
        m_painter.setPen(halo ? QPen(m_palette.color(QPalette::Base), 5) : QPen(stateColors(m_palette).accent, 2));
        m_painter.setBrush(Qt::NoBrush);
        m_painter.drawEllipse(at, kRadius, kRadius);
        for (const QPointF &arm : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            m_painter.drawLine(at + arm * kRadius / 2, at + arm * kArm);
    }
    if (!label.isEmpty())
        paintLabel(m_painter, at + QPointF(0, kArm + kNameOffset), label, m_palette);
}

void MapPainter::paintCentre()
{
    constexpr double kArm = 12, kCentreGap = 4; // pixels
    const QPointF at(m_viewport.size().width() / 2, m_viewport.size().height() / 2);
    for (const bool halo : {true, false}) {
        m_painter.setPen(halo ? QPen(m_palette.color(QPalette::Base), 5) : QPen(m_palette.color(QPalette::WindowText), 2));
        for (const QPointF &arm : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            m_painter.drawLine(at + arm * kCentreGap, at + arm * kArm);
    }
}

void MapPainter::paintScale(UnitSystem units)
{
    const QFontMetricsF metrics(m_painter.font());
    const double scale = m_viewport.groundMetresPerPixel();
    const auto [text, metres] = scaleBar(60 * scale, units);
    const double length = metres / scale;
    const double right = m_viewport.size().width() - 2.0 * kGrid, y = m_viewport.size().height() - 2.0 * kGrid;
    paintPlate(m_painter, {right - length - kGrid, y - metrics.height() - 10, length + 2 * kGrid, metrics.height() + 14},
               m_palette);
    m_painter.setPen(QPen(m_palette.color(QPalette::WindowText), 1.5));
    m_painter.drawPolyline(
        QPolygonF{QPointF(right - length, y - 5), QPointF(right - length, y), QPointF(right, y), QPointF(right, y - 5)});
    m_painter.drawText(QPointF(right - length / 2 - metrics.horizontalAdvance(text) / 2, y - 8), text);
}

QRectF MapPainter::placeOfCoordinates(const MapViewport &viewport, const QFontMetricsF &metrics, const QString &widest)
{
    const double width = figuresWidth(metrics, widest) + 2 * kGrid;
    const double height = metrics.height() + kHalfGrid;
    const double bottom = viewport.size().height() - 3.0 * kGrid - metrics.height() - 10; // of the scale bar's caption
    return {viewport.size().width() - kGrid - width, bottom - height, width, height};
}

void MapPainter::paintCoordinates(const QString &text)
{
    const QFontMetricsF metrics(m_painter.font());
    const QRectF place = placeOfCoordinates(m_viewport, metrics, text);
    paintPlate(m_painter, place, m_palette);
    drawFigures(m_painter, {place.left() + kGrid, place.top() + kHalfGrid / 2.0 + metrics.ascent()}, text);
}

QRectF MapPainter::placeOfNorth(const MapViewport &viewport)
{
    constexpr double kSide = 44; // pixels
    return {viewport.size().width() - 3.0 * kGrid - kSide / 2, 5.0 * kGrid - kSide / 2, kSide, kSide};
}

/// The needle turns, the letter stays upright. A rotated map shows it as the button that it then is.
void MapPainter::paintNorth()
{
    const QColor ink = m_palette.color(QPalette::WindowText);
    const QPointF north = placeOfNorth(m_viewport).center();
    constexpr double kRadius = 18;
    if (m_viewport.isRotated()) {
        m_painter.setPen(QPen(stateColors(m_palette).edge, 1));
        m_painter.setBrush(m_palette.color(QPalette::Base));
        m_painter.drawEllipse(north, kRadius, kRadius);
    }
    QTransform turn;
    turn.rotate(-m_viewport.heading());
    const double up = m_viewport.isRotated() ? 3 : 0; // pixels, so that both have room in the circle
    const QPolygonF needle{{0, -12 - up}, {5, 4 - up}, {0, 1 - up}, {-5, 4 - up}};
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(ink);
    m_painter.drawPolygon(turn.map(needle).translated(north));
    m_painter.setPen(ink);
    const QPointF letter = north + turn.map(QPointF(0, 13 - up));
    m_painter.drawText(QRectF(letter.x() - 12, letter.y() - 9, 24, 18), Qt::AlignCenter, tr("N"));
}

/// Where the pictures come from, and why they do not.
double MapPainter::paintAttribution(const TileLayer &tiles)
{
    double bottom = m_viewport.size().height() - kHalfGrid;
    if (!tiles.isOn())
        return bottom;
    const QFontMetricsF metrics(m_painter.font());
    const double widest = m_viewport.size().width() * 0.6;
    const QString problem = tiles.problem().isEmpty() ? QString() : tr("Map: %1").arg(tiles.problem());
    for (const QString &text : {tiles.attribution(), problem}) {
        if (text.isEmpty())
            continue;
        const QString shown = metrics.elidedText(text, Qt::ElideRight, widest);
        const double height = metrics.height() + kHalfGrid;
        paintCaption(m_painter, {kHalfGrid, bottom - height, metrics.horizontalAdvance(shown) + 2 * kGrid, height}, shown,
                     m_palette);
        bottom -= height + kHalfGrid;
    }
    return bottom;
}

} // namespace skyseal::ui
