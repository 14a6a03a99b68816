// Paints the tiles under the map. Where one has not come yet, the part of a coarser one, or finer ones, stand in for it.
#pragma once

#include "ui/map/tile_layer.h"

class QPainter;

namespace skyseal::ui {

/// Made for one paint event; the references must outlive it.
class TilePainter
{
public:
    TilePainter(QPainter &painter, const TileLayer &tiles, const MapViewport &viewport)
        : m_painter(painter), m_tiles(tiles), m_viewport(viewport), m_heading(viewport.heading())
    {
        m_viewport.setHeading(0);
    }

    void paint();

private:
    void paintTile(int column, int row);
    bool paintCoarser(const TileId &tile, const QRect &place);
    void paintFiner(const TileId &tile, int column, int row);
    QRect placeOf(int level, int column, int row) const;

    QPainter &m_painter;
    const TileLayer &m_tiles;
    MapViewport m_viewport; ///< with north up
    const double m_heading; ///< degrees, by which the painter turns
};

} // namespace skyseal::ui
