// Shapes from a file of another program, such as fields and areas to keep out of, which are drawn over the map. Plain values.
#pragma once

#include <QtCore/QString>

#include <cstddef>
#include <vector>

namespace skyseal::overlay {

/// Limits of a file; a larger one is refused.
inline constexpr qint64 kMostBytes = 64 * 1024 * 1024;
inline constexpr std::size_t kMostPoints = 200'000;
inline constexpr int kDeepest = 64; ///< elements or collections within one another

/// Degrees (WGS84): latitude −90 to 90, longitude −180 to 180.
struct OverlayPoint
{
    double latitude = 0, longitude = 0;
    bool operator==(const OverlayPoint &) const = default;
};

using OverlayLine = std::vector<OverlayPoint>;

enum class ShapeKind { Point, Line, Polygon };

struct OverlayShape
{
    ShapeKind kind = ShapeKind::Point;
    QString name; ///< one line without characters that are invisible, at most 100; often empty
    /// A point: one line of one point. A line: one of at least two. A polygon: its outer ring, then its holes, each of at least
    /// three points; the last one is joined to the first.
    std::vector<OverlayLine> lines;
};

struct Overlay
{
    std::vector<OverlayShape> shapes;
    std::size_t leftOut = 0; ///< shapes without a place, with too few points, or of a kind that is not drawn
};

} // namespace skyseal::overlay
