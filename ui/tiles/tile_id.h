// The number of a map tile, as tile servers count: level 0 is the world in one tile, columns from the west, rows from the
// north. https://wiki.openstreetmap.org/wiki/Slippy_map_tilenames
#pragma once

#include <QtCore/QHashFunctions>

namespace skyseal::ui {

struct TileId
{
    static constexpr int kDeepest = 22;

    int level = 0, column = 0, row = 0;

    /// True if the world has such a tile.
    bool exists() const
    {
        return level >= 0 && level <= kDeepest && column >= 0 && row >= 0 && column < 1 << level && row < 1 << level;
    }
    bool operator==(const TileId &) const = default;
};

inline size_t qHash(const TileId &tile, size_t seed = 0)
{
    return qHashMulti(seed, tile.level, tile.column, tile.row);
}

} // namespace skyseal::ui
