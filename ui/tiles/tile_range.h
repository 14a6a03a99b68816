// The tiles of one level that cover a rectangle, and those of a region over several levels.
#pragma once

#include "ui/tiles/mercator.h"
#include "ui/tiles/tile_id.h"

#include <QtCore/QRectF>

#include <optional>

namespace skyseal::ui {

/// Both ends are included. Columns may lie beyond the world, which repeats itself to the east and the west.
struct TileRange
{
    int level = 0, left = 0, right = -1, top = 0, bottom = -1;

    qint64 count() const { return qint64{right - left + 1} * (bottom - top + 1); }
    /// The tile of a column that may lie beyond the world.
    TileId at(int column, int row) const
    {
        const int columns = 1 << level;
        return {level, ((column % columns) + columns) % columns, row};
    }
};

/// `metres`: of the projection, its top being the southern edge.
inline TileRange tilesIn(const QRectF &metres, int level)
{
    const int tiles = 1 << level;
    const double side = 2 * mercator::kHalfWorld / tiles; // metres
    const auto number = [side](double from) { return static_cast<int>(std::floor(from / side)); };
    return {level, number(metres.left() + mercator::kHalfWorld), number(metres.right() + mercator::kHalfWorld),
            std::clamp(number(mercator::kHalfWorld - metres.bottom()), 0, tiles - 1),
            std::clamp(number(mercator::kHalfWorld - metres.top()), 0, tiles - 1)};
}

/// A rectangle of the map over several levels, to be fetched for use without a network.
struct TileRegion
{
    QRectF metres;
    int shallowest = 0, deepest = 0;

    qint64 count() const
    {
        qint64 out = 0;
        for (int level = shallowest; level <= deepest; ++level)
            out += tilesIn(metres, level).count();
        return out;
    }
};

/// Walks over the tiles of a region, level by level.
class RegionWalk
{
public:
    explicit RegionWalk(const TileRegion &region) : m_region(region), m_range(tilesIn(region.metres, region.shallowest))
    {
        m_column = m_range.left;
        m_row = m_range.top;
    }

    std::optional<TileId> next()
    {
        if (m_range.level > m_region.deepest)
            return std::nullopt;
        const TileId out = m_range.at(m_column, m_row);
        if (++m_column > m_range.right) {
            m_column = m_range.left;
            ++m_row;
        }
        if (m_row > m_range.bottom) {
            m_range = tilesIn(m_region.metres, std::min(m_range.level + 1, TileId::kDeepest + 1));
            m_column = m_range.left;
            m_row = m_range.top;
        }
        return out;
    }

private:
    TileRegion m_region;
    TileRange m_range;
    int m_column = 0, m_row = 0;
};

} // namespace skyseal::ui
