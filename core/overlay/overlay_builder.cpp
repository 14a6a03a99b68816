#include "core/overlay/overlay_builder.h"

#include "core/base/printable.h"

#include <algorithm>

namespace skyseal::overlay {

namespace {

constexpr qsizetype kLongestName = 100; ///< characters

bool isWithin(double degrees, double limit)
{
    return degrees >= -limit && degrees <= limit; // false for NaN
}

std::string textOf(double degrees)
{
    return QString::number(degrees).toStdString();
}

/// Files close a ring by its first point.
void openRing(OverlayLine &ring)
{
    while (ring.size() > 1 && ring.front() == ring.back())
        ring.pop_back();
}

} // namespace

Result<OverlayPoint, Reason> OverlayBuilder::point(double longitude, double latitude)
{
    if (++m_points > kMostPoints)
        return tl::unexpected(sentence("Reason", "the file has more than %1 positions")(kMostPoints));
    if (!isWithin(longitude, 180))
        return tl::unexpected(sentence("Reason", "the longitude %1 is not within -180 and 180")(textOf(longitude)));
    if (!isWithin(latitude, 90))
        return tl::unexpected(sentence("Reason", "the latitude %1 is not within -90 and 90")(textOf(latitude)));
    return OverlayPoint{latitude, longitude};
}

void OverlayBuilder::add(ShapeKind kind, const QString &name, std::vector<OverlayLine> lines)
{
    if (kind == ShapeKind::Polygon)
        std::ranges::for_each(lines, openRing);
    const std::size_t least = kind == ShapeKind::Polygon ? 3 : kind == ShapeKind::Line ? 2 : 1;
    if (lines.empty() || lines.front().size() < least)
        return leaveOut();
    std::erase_if(lines, [least](const OverlayLine &line) { return line.size() < least; }); // holes
    m_overlay.shapes.push_back({kind, shownName(name), std::move(lines)});
}

void OverlayBuilder::nameFrom(std::size_t first, const QString &name)
{
    const QString shown = shownName(name);
    for (std::size_t i = first; i < m_overlay.shapes.size(); ++i)
        if (m_overlay.shapes[i].name.isEmpty())
            m_overlay.shapes[i].name = shown;
}

QString shownName(const QString &name)
{
    // Cut first, since a name may be as long as a file.
    const QString start = name.left(4 * kLongestName).simplified();
    return QString::fromStdString(printable(start.toStdString())).left(kLongestName);
}

} // namespace skyseal::overlay
