#include "ui/map/tile_painter.h"

#include <QtGui/QPainter>

namespace skyseal::ui {

namespace {
constexpr int kCoarsest = 6; ///< levels above a tile that may stand in for it
} // namespace

void TilePainter::paint()
{
    const TileRange &range = m_tiles.range();
    m_painter.save();
    const QSizeF middle = m_viewport.size() / 2;
    m_painter.translate(middle.width(), middle.height());
    m_painter.rotate(-m_heading);
    m_painter.translate(-middle.width(), -middle.height());
    for (int row = range.top; row <= range.bottom; ++row)
        for (int column = range.left; column <= range.right; ++column)
            paintTile(column, row);
    m_painter.restore();
}

/// In whole pixels: neighbours share their edges. Rotated ones overlap by a pixel, since their edges lie between pixels.
QRect TilePainter::placeOf(int level, int column, int row) const
{
    const double side = 2 * mercator::kHalfWorld / (1 << level);
    const auto corner = [&](int c, int r) {
        return m_viewport.toPixels({c * side - mercator::kHalfWorld, mercator::kHalfWorld - r * side}).toPoint();
    };
    const QPoint end = corner(column + 1, row + 1);
    return {corner(column, row), m_heading == 0 ? end - QPoint(1, 1) : end};
}

void TilePainter::paintTile(int column, int row)
{
    const TileRange &range = m_tiles.range();
    const TileId tile = range.at(column, row);
    const QRect place = placeOf(range.level, column, row);
    if (const QImage *image = m_tiles.find(tile))
        m_painter.drawImage(place, *image);
    else if (!paintCoarser(tile, place))
        paintFiner(tile, column, row);
}

bool TilePainter::paintCoarser(const TileId &tile, const QRect &place)
{
    for (int up = 1; up <= std::min(kCoarsest, tile.level); ++up) {
        const QImage *image = m_tiles.find({tile.level - up, tile.column >> up, tile.row >> up});
        if (!image)
            continue;
        const double parts = 1 << up, width = image->width() / parts, height = image->height() / parts;
        m_painter.drawImage(QRectF(place), *image,
                            QRectF((tile.column % (1 << up)) * width, (tile.row % (1 << up)) * height, width, height));
        return true;
    }
    return false;
}

void TilePainter::paintFiner(const TileId &tile, int column, int row)
{
    for (int part = 0; part < 4; ++part) {
        const int right = part % 2, down = part / 2;
        if (const QImage *image = m_tiles.find({tile.level + 1, 2 * tile.column + right, 2 * tile.row + down}))
            m_painter.drawImage(placeOf(tile.level + 1, 2 * column + right, 2 * row + down), *image);
    }
}

} // namespace skyseal::ui
