#include "ui/map/fence_painter.h"

#include "ui/map/map_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtGui/QPainter>
#include <QtGui/QPainterPath>

#include <algorithm>

namespace skyseal::ui {

namespace {

constexpr double kFenceMark = 8;  ///< pixels: half of a mark's height
constexpr double kLabelRoom = 48; ///< pixels: half of a label's width, about

} // namespace

void FencePainter::paint(const FenceContent &content)
{
    for (const FenceArea &area : content.fence().areas)
        paintArea(area);
    // A plan may have as many points as its counter can tell; only those in the picture cost something.
    const QRectF picture = QRectF(QPointF(), m_viewport.size()).adjusted(-kLabelRoom, -kLabelRoom, kLabelRoom, kLabelRoom);
    for (const QPointF &point : content.fence().returnPoints)
        if (const QPointF at = m_viewport.toPixels(point); picture.contains(at))
            paintReturnPoint(at);
    for (std::size_t i = 0; i < content.rallyPoints().size(); ++i)
        if (const QPointF at = m_viewport.toPixels(content.rallyPoints()[i]); picture.contains(at))
            paintRallyPoint(at, i + 1);
}

/// The label stands on the northernmost point of the line, or next to it within the picture.
void FencePainter::paintArea(const FenceArea &area)
{
    const StateColors &colors = stateColors(m_palette);
    QPainterPath line;
    QPointF top;
    if (area.centre) {
        const double radius = area.radius * mercator::stretch(area.centre->y()) / m_viewport.metresPerPixel();
        const QPointF at = m_viewport.toPixels(*area.centre);
        line.addEllipse(at, radius, radius);
        top = at - QPointF(0, radius);
    } else {
        QPolygonF corners;
        for (const QPointF &corner : area.corners)
            corners << m_viewport.toPixels(corner);
        line.addPolygon(corners);
        line.closeSubpath();
        top = *std::ranges::min_element(corners, {}, &QPointF::y);
    }
    const QRectF picture(QPointF(), m_viewport.size());
    if (!line.boundingRect().intersects(picture))
        return;
    if (!area.inclusion)
        m_painter.fillPath(line, QBrush(colors.alarm, Qt::BDiagPattern));
    const QColor color = area.inclusion ? colors.good : colors.alarm;
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(QPen(m_palette.color(QPalette::Base), 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    m_painter.drawPath(line);
    m_painter.setPen(QPen(color, 2.5, area.inclusion ? Qt::SolidLine : Qt::DashLine, Qt::FlatCap, Qt::RoundJoin));
    m_painter.drawPath(line);
    const QRectF labels = picture.adjusted(kLabelRoom, kGrid, -kLabelRoom, -kGrid);
    paintLabel(m_painter,
               {std::clamp(top.x(), labels.left(), std::max(labels.left(), labels.right())),
                std::clamp(top.y(), labels.top(), std::max(labels.top(), labels.bottom()))},
               area.inclusion ? tr("Stay inside") : tr("Keep out"), m_palette);
}

void FencePainter::paintReturnPoint(const QPointF &at)
{
    m_painter.setPen(QPen(stateColors(m_palette).good, 2));
    m_painter.setBrush(m_palette.color(QPalette::Base));
    m_painter.drawRect(QRectF(at - QPointF(kFenceMark, kFenceMark), QSizeF(2 * kFenceMark, 2 * kFenceMark)));
    paintLabel(m_painter, at + QPointF(0, 2.4 * kFenceMark), tr("Fence return"), m_palette);
}

/// A flag on its place.
void FencePainter::paintRallyPoint(const QPointF &at, std::size_t number)
{
    const QPointF top = at - QPointF(0, 2.5 * kFenceMark);
    m_painter.setPen(QPen(m_palette.color(QPalette::WindowText), 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    m_painter.setBrush(m_palette.color(QPalette::Base));
    m_painter.drawLine(at, top);
    m_painter.drawPolygon(
        QPolygonF{top, top + QPointF(1.8 * kFenceMark, 0.6 * kFenceMark), top + QPointF(0, 1.2 * kFenceMark)});
    m_painter.drawEllipse(at, 2.5, 2.5);
    paintLabel(m_painter, at + QPointF(0, 1.6 * kFenceMark), tr("Rally %1").arg(number), m_palette);
}

} // namespace skyseal::ui
