#include "ui/map/edge_arrow.h"

#include "ui/map/geodesic.h"
#include "ui/map/map_content.h"
#include "ui/map/map_text.h"
#include "ui/map/map_viewport.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtCore/QCoreApplication>
#include <QtGui/QFontMetricsF>
#include <QtGui/QPainter>
#include <QtGui/QPainterPath>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

namespace {

struct EdgeArrowText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::EdgeArrow)
};

constexpr double kArrowMargin = 2 * kGrid;                     ///< pixels from the edge to the tip
constexpr double kArrowLength = 2 * kGrid, kArrowHalf = kGrid; ///< pixels

} // namespace

bool EdgeArrow::contains(const QPointF &pixel) const
{
    constexpr double kReach = kTouchTarget / 2.0;
    const QPointF way = tip - direction * (kArrowLength / 2) - pixel;
    return caption.contains(pixel) || std::hypot(way.x(), way.y()) <= kReach;
}

std::optional<EdgeArrow> edgeArrowOf(const MapContent &content, const MapViewport &viewport, UnitSystem units,
                                     const QFontMetricsF &metrics)
{
    if (!content.vehicle())
        return std::nullopt;
    const QRectF picture(QPointF(), viewport.size());
    const QPointF at = viewport.toPixels(*content.vehicle());
    const QRectF inner = picture.adjusted(kArrowMargin, kArrowMargin, -kArrowMargin, -kArrowMargin);
    if (picture.contains(at) || inner.width() <= 0 || inner.height() <= 0)
        return std::nullopt;
    const QPointF way = at - picture.center();
    EdgeArrow out;
    out.direction = way / std::hypot(way.x(), way.y());
    const auto untilEdge = [](double half, double step) { return step == 0 ? HUGE_VAL : half / std::abs(step); };
    out.tip = picture.center()
        + out.direction
            * std::min(untilEdge(inner.width() / 2, out.direction.x()), untilEdge(inner.height() / 2, out.direction.y()));
    const double metres =
        geodesicBetween(mercator::unproject(viewport.centre()), mercator::unproject(*content.vehicle())).metres;
    out.distance = distanceFigure(metres, units).text();
    out.text = EdgeArrowText::tr("Vehicle %1 · %2").arg(content.systemId()).arg(out.distance);
    out.caption = QRectF(0, 0, metrics.horizontalAdvance(out.text) + 2 * kGrid, metrics.height() + kHalfGrid);
    const double back = kArrowLength + kHalfGrid + std::abs(out.direction.x()) * out.caption.width() / 2
        + std::abs(out.direction.y()) * out.caption.height() / 2;
    out.caption.moveCenter(out.tip - out.direction * back);
    out.caption.moveLeft(
        std::clamp(out.caption.left(), inner.left(), std::max(inner.left(), inner.right() - out.caption.width())));
    out.caption.moveTop(
        std::clamp(out.caption.top(), inner.top(), std::max(inner.top(), inner.bottom() - out.caption.height())));
    return out;
}

void paintEdgeArrow(QPainter &painter, const EdgeArrow &arrow, const QPalette &palette)
{
    const QPointF across(-arrow.direction.y(), arrow.direction.x()), foot = arrow.tip - arrow.direction * kArrowLength;
    QPainterPath head(arrow.tip);
    head.lineTo(foot + across * kArrowHalf);
    head.lineTo(foot - across * kArrowHalf);
    head.closeSubpath();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette.color(QPalette::Base), 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(head);
    painter.fillPath(head, stateColors(palette).accent);
    paintCaption(painter, arrow.caption, arrow.text, palette);
}

} // namespace skyseal::ui
