// Common to the readers of both formats: checks of positions, and shapes that can be drawn.
#pragma once

#include "core/base/result.h"
#include "core/overlay/overlay.h"

namespace skyseal::overlay {

class OverlayBuilder
{
public:
    /// Counts the position and checks its range. The error is a sentence that says what is wrong, but not where in the file.
    Result<OverlayPoint, Reason> point(double longitude, double latitude);

    /// Leaves the shape out if it has too few points. A polygon counts by its outer ring, the first of `lines`.
    void add(ShapeKind kind, const QString &name, std::vector<OverlayLine> lines);
    void leaveOut() { ++m_overlay.leftOut; }

    std::size_t shapes() const { return m_overlay.shapes.size(); }
    /// Names all shapes from the number `first` on that have no name yet.
    void nameFrom(std::size_t first, const QString &name);

    Overlay take() { return std::move(m_overlay); }

private:
    Overlay m_overlay;
    std::size_t m_points = 0;
};

/// In one line, without invisible characters, and cut to 100 characters.
QString shownName(const QString &name);

} // namespace skyseal::overlay
