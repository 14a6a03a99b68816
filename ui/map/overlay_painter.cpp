#include "ui/map/overlay_painter.h"

#include "ui/map/clip.h"
#include "ui/map/map_text.h"
#include "ui/overlays/overlay_model.h"
#include "ui/theme/grid.h"

#include <QtGui/QPainter>
#include <QtGui/QPainterPath>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace skyseal::ui {

using overlay::ShapeKind;

namespace {

constexpr double kMargin = 16;       ///< pixels around the picture: the width of what is drawn
constexpr double kCell = 8;          ///< pixels; there is one mark in each square of this side
constexpr double kMark = 4;          ///< pixels: radius of a point
constexpr int kMarkRoom = 6;         ///< pixels: half of its picture
constexpr double kStep = 2;          ///< pixels: the width of a line
constexpr double kSmall = 3;         ///< pixels; a shape below it is drawn as a mark
constexpr int kMostNamesTried = 400; ///< each is measured, which takes longer than to draw a shape
constexpr double kFilling = 0.16;    ///< opacity

} // namespace

OverlayPainter::OverlayPainter(QPainter &painter, const MapViewport &viewport, const QPalette &palette)
    : m_painter(painter), m_viewport(viewport), m_palette(palette),
      m_picture(QRectF(QPointF(), viewport.size()).adjusted(-kMargin, -kMargin, kMargin, kMargin)),
      m_cellsAcross(static_cast<int>(m_picture.width() / kCell) + 1)
{}

void OverlayPainter::paint(const OverlayModel &overlays)
{
    std::vector<Placed> all;
    for (const OverlayModel::Entry &entry : overlays.entries()) {
        if (!entry.file.visible || !entry.shapes)
            continue;
        const auto shapes = placedOf(*entry.shapes);
        m_cells.assign(static_cast<std::size_t>(m_cellsAcross) * (static_cast<std::size_t>(m_picture.height() / kCell) + 1),
                       false);
        paintFile(shapes, overlayColor(entry.file.color, m_palette));
        all.insert(all.end(), shapes.begin(), shapes.end());
    }
    paintNames(all);
}

/// Those in the picture; several times where the picture shows a place several times.
std::vector<OverlayPainter::Placed> OverlayPainter::placedOf(const ProjectedOverlay &shapes) const
{
    constexpr double kTurn = 2 * mercator::kHalfWorld;
    const double margin = kMargin * m_viewport.metresPerPixel();
    const QRectF shown = m_viewport.visible().adjusted(-margin, -margin, margin, margin);
    std::vector<Placed> out;
    for (const ProjectedShape &shape : shapes) {
        if (shape.box.bottom() < shown.top() || shape.box.top() > shown.bottom())
            continue;
        const double first = std::ceil((shown.left() - shape.box.right()) / kTurn);
        for (double turn = first; shape.box.left() + turn * kTurn <= shown.right(); ++turn)
            out.push_back({&shape, turn * kTurn});
    }
    return out;
}

void OverlayPainter::paintFile(const std::vector<Placed> &shapes, const QColor &color)
{
    std::vector<std::vector<QPolygonF>> areas;
    std::vector<QPolygonF> lines;
    std::vector<QPointF> points;
    for (const auto &[shape, shift] : shapes) {
        if (std::max(shape->box.width(), shape->box.height()) < kSmall * m_viewport.metresPerPixel()) {
            const QPointF middle = m_viewport.toPixels(shape->box.center() + QPointF(shift, 0));
            if (m_picture.contains(middle) && takeCell(middle))
                points.push_back(middle);
        } else if (shape->kind == ShapeKind::Line) {
            std::ranges::move(clipLine(pixelsOf(shape->lines.front(), shift), m_picture), std::back_inserter(lines));
        } else {
            auto &rings = areas.emplace_back();
            for (const QPolygonF &line : shape->lines)
                if (QPolygonF ring = clipRing(pixelsOf(line, shift), m_picture); !ring.isEmpty())
                    rings.push_back(std::move(ring));
        }
    }
    fillAreas(areas, color);
    m_painter.setPen(QPen(color, 2, Qt::SolidLine, Qt::SquareCap, Qt::BevelJoin)); // round joins take several times as long
    for (std::vector<QPolygonF> &rings : areas) {
        for (QPolygonF &ring : rings) {
            ring << QPointF(ring.front());
            drawLine(ring);
        }
    }
    std::ranges::for_each(lines, [this](const QPolygonF &line) { drawLine(line); });
    paintPoints(points, color);
}

/// First in full into a picture of its own, and this thinly over the map: areas that overlap are one. To mix each with the map,
/// Qt would wake its threads, which takes longer than to fill it.
void OverlayPainter::fillAreas(const std::vector<std::vector<QPolygonF>> &areas, const QColor &color)
{
    if (areas.empty())
        return;
    const qreal ratio = m_painter.device()->devicePixelRatioF();
    QImage layer((m_viewport.size() * ratio).toSize(), QImage::Format_ARGB32_Premultiplied);
    layer.setDevicePixelRatio(ratio);
    layer.fill(Qt::transparent);
    QPainter painter(&layer);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    for (const std::vector<QPolygonF> &rings : areas) {
        QPainterPath area; // odd-even: the holes are left out
        for (const QPolygonF &ring : rings) {
            area.addPolygon(ring);
            area.closeSubpath();
        }
        painter.drawPath(area);
    }
    painter.end();
    m_painter.setOpacity(kFilling);
    m_painter.drawImage(QPointF(), layer);
    m_painter.setOpacity(1);
}

/// In short parts: the time that Qt takes for one grows faster than its points.
void OverlayPainter::drawLine(const QPolygonF &line)
{
    constexpr qsizetype kPart = 16;
    for (qsizetype from = 0; from + 1 < line.size(); from += kPart)
        m_painter.drawPolyline(line.constData() + from, static_cast<int>(std::min(kPart + 1, line.size() - from)));
}

/// True once for each square of the picture.
bool OverlayPainter::takeCell(const QPointF &pixel)
{
    const QPointF from = (pixel - m_picture.topLeft()) / kCell;
    const auto cell = static_cast<std::size_t>(from.y()) * static_cast<std::size_t>(m_cellsAcross)
        + static_cast<std::size_t>(from.x());
    if (cell >= m_cells.size() || m_cells[cell])
        return false;
    m_cells[cell] = true;
    return true;
}

/// By a picture of one, since there may be thousands.
void OverlayPainter::paintPoints(const std::vector<QPointF> &points, const QColor &color)
{
    if (points.empty())
        return;
    const qreal ratio = m_painter.device()->devicePixelRatioF();
    QPixmap mark((QSizeF(2, 2) * kMarkRoom * ratio).toSize());
    mark.setDevicePixelRatio(ratio);
    mark.fill(Qt::transparent);
    QPainter painter(&mark);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(m_palette.color(QPalette::Base), 1.5));
    painter.setBrush(color);
    painter.drawEllipse(QPointF(kMarkRoom, kMarkRoom), kMark, kMark);
    painter.end();
    for (const QPointF &point : points)
        m_painter.drawPixmap((point - QPointF(kMarkRoom, kMarkRoom)).toPoint(), mark);
}

/// Without points that are hardly apart from the one before.
QPolygonF OverlayPainter::pixelsOf(const QPolygonF &line, double shift) const
{
    QPolygonF out;
    out << m_viewport.toPixels(line.front() + QPointF(shift, 0));
    for (qsizetype i = 1; i < line.size(); ++i) {
        const QPointF next = m_viewport.toPixels(line[i] + QPointF(shift, 0));
        if ((next - out.back()).manhattanLength() >= kStep || i + 1 == line.size())
            out << next;
    }
    return out;
}

/// Names that have room in their shape, and next to a point; where two would overlap, that of the first file and shape.
void OverlayPainter::paintNames(const std::vector<Placed> &shapes)
{
    const QFontMetricsF metrics(m_painter.font());
    const QRectF picture(QPointF(), m_viewport.size());
    const double narrowest = metrics.averageCharWidth() + kGrid;
    for (const auto &[shape, shift] : shapes) {
        const double room = shape->captionRoom / m_viewport.metresPerPixel();
        if (shape->name.isEmpty() || (shape->kind != ShapeKind::Point && room < narrowest))
            continue;
        QPointF middle = m_viewport.toPixels(shape->caption + QPointF(shift, 0));
        if (shape->kind == ShapeKind::Point)
            middle += QPointF(0, kMark + metrics.height());
        if (!picture.contains(middle))
            continue;
        if (++m_tried > kMostNamesTried)
            return;
        QRectF place(0, 0, metrics.horizontalAdvance(shape->name) + kGrid, metrics.height() + 2);
        place.moveCenter(middle);
        const bool fits = shape->kind == ShapeKind::Point || place.width() <= room;
        if (!fits || std::ranges::any_of(m_taken, [&place](const QRectF &other) { return other.intersects(place); }))
            continue;
        m_taken.push_back(place);
        paintCaption(m_painter, place, shape->name, m_palette);
    }
}

} // namespace skyseal::ui
