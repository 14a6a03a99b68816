#include "ui/map/clip.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace skyseal::ui {

namespace {

/// How far a point is inside of one of the four edges; negative: outside.
double inside(const QPointF &point, const QRectF &area, int edge)
{
    switch (edge) {
    case 0: return point.x() - area.left();
    case 1: return area.right() - point.x();
    case 2: return point.y() - area.top();
    default: return area.bottom() - point.y();
    }
}

/// The part from `a` to `b` within the area, as shares of the way; nothing if it has none.
std::optional<std::pair<double, double>> partWithin(const QPointF &a, const QPointF &b, const QRectF &area)
{
    double from = 0, to = 1;
    for (int edge = 0; edge < 4; ++edge) {
        const double first = inside(a, area, edge), last = inside(b, area, edge);
        if (first < 0 && last < 0)
            return std::nullopt;
        if (first < 0)
            from = std::max(from, first / (first - last));
        else if (last < 0)
            to = std::min(to, first / (first - last));
    }
    return from <= to ? std::optional(std::pair(from, to)) : std::nullopt;
}

} // namespace

QPolygonF clipRing(QPolygonF ring, const QRectF &area)
{
    for (int edge = 0; edge < 4 && !ring.isEmpty(); ++edge) {
        QPolygonF kept;
        kept.reserve(ring.size());
        QPointF before = ring.back();
        double beforeInside = inside(before, area, edge);
        for (const QPointF &point : std::as_const(ring)) {
            const double pointInside = inside(point, area, edge);
            if ((beforeInside < 0) != (pointInside < 0))
                kept << before + (point - before) * (beforeInside / (beforeInside - pointInside));
            if (pointInside >= 0)
                kept << point;
            before = point;
            beforeInside = pointInside;
        }
        ring = std::move(kept);
    }
    return ring;
}

std::vector<QPolygonF> clipLine(const QPolygonF &line, const QRectF &area)
{
    std::vector<QPolygonF> out;
    bool continues = false; // the last piece ends at the next point
    for (qsizetype i = 0; i + 1 < line.size(); ++i) {
        const QPointF way = line[i + 1] - line[i];
        const auto part = partWithin(line[i], line[i + 1], area);
        if (!part) {
            continues = false;
            continue;
        }
        if (!continues || part->first > 0)
            out.emplace_back().append(line[i] + way * part->first);
        out.back() << line[i] + way * part->second;
        continues = part->second >= 1;
    }
    return out;
}

} // namespace skyseal::ui
