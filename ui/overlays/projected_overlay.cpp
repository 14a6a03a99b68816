#include "ui/overlays/projected_overlay.h"

#include <algorithm>

namespace skyseal::ui {

using overlay::ShapeKind;

namespace {

/// Each point is taken on the short way from the one before it; the first one near `x`.
QPolygonF projectLine(const overlay::OverlayLine &line, double x)
{
    QPolygonF out;
    out.reserve(static_cast<qsizetype>(line.size()));
    for (const overlay::OverlayPoint &point : line) {
        QPointF metres = mercator::project({point.latitude, point.longitude});
        metres.setX(mercator::nearestTurn(metres.x(), x));
        x = metres.x();
        out << metres;
    }
    return out;
}

/// A ring that ends a whole turn beside its beginning encloses a pole: that on whose side most of it is.
void completeAroundPole(QPolygonF &ring)
{
    const double end = mercator::nearestTurn(ring.front().x(), ring.back().x());
    if (std::abs(end - ring.front().x()) < mercator::kHalfWorld)
        return;
    double sum = 0;
    for (const QPointF &point : ring)
        sum += point.y();
    const double edge = sum < 0 ? -mercator::kHalfWorld : mercator::kHalfWorld;
    const QPointF first = ring.front();
    ring << QPointF(end, first.y()) << QPointF(end, edge) << QPointF(first.x(), edge);
}

/// The widest part of the polygon on the horizontal line through the middle of its box, holes left out.
void placeInPolygon(ProjectedShape &shape)
{
    const double y = shape.box.center().y();
    std::vector<double> crossings;
    for (const QPolygonF &ring : shape.lines) {
        for (qsizetype i = 0; i < ring.size(); ++i) {
            const QPointF &a = ring[i], &b = ring[(i + 1) % ring.size()];
            if ((a.y() < y) != (b.y() < y))
                crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
        }
    }
    std::ranges::sort(crossings);
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
        if (const double width = crossings[i + 1] - crossings[i]; width > shape.captionRoom) {
            shape.captionRoom = width;
            shape.caption = {(crossings[i] + crossings[i + 1]) / 2, y};
        }
    }
}

void placeCaption(ProjectedShape &shape)
{
    const QPolygonF &line = shape.lines.front();
    switch (shape.kind) {
    case ShapeKind::Point: shape.caption = line.front(); return;
    case ShapeKind::Polygon: placeInPolygon(shape); return;
    case ShapeKind::Line: break;
    }
    const qsizetype middle = line.size() / 2;
    shape.caption = (line[middle - 1] + line[middle]) / 2;
    shape.captionRoom = std::max(shape.box.width(), shape.box.height());
}

} // namespace

ProjectedOverlay projectOverlay(const overlay::Overlay &overlay)
{
    ProjectedOverlay out;
    out.reserve(overlay.shapes.size());
    for (const overlay::OverlayShape &shape : overlay.shapes) {
        ProjectedShape projected{.kind = shape.kind, .name = shape.name};
        double x = 0;
        for (const overlay::OverlayLine &line : shape.lines) {
            projected.lines.push_back(projectLine(line, x));
            if (shape.kind == ShapeKind::Polygon)
                completeAroundPole(projected.lines.back());
            if (projected.lines.size() == 1)
                projected.box = projected.lines.front().boundingRect();
            x = projected.box.center().x();
        }
        placeCaption(projected);
        out.push_back(std::move(projected));
    }
    return out;
}

} // namespace skyseal::ui
