// Paints the files over the map: areas with a thin filling, lines, and points, with their names where they fit. Shapes
// outside of the picture cost hardly more than a look.
#pragma once

#include "ui/map/map_viewport.h"
#include "ui/overlays/projected_overlay.h"

#include <QtGui/QPalette>

#include <vector>

class QPainter;

namespace skyseal::ui {

class OverlayModel;

/// Made for one paint event; the references must outlive it.
class OverlayPainter
{
public:
    OverlayPainter(QPainter &painter, const MapViewport &viewport, const QPalette &palette);

    void paint(const OverlayModel &overlays);

private:
    struct Placed
    {
        const ProjectedShape *shape;
        double shift; ///< metres to the east: the world repeats itself
    };

    std::vector<Placed> placedOf(const ProjectedOverlay &shapes) const;
    void paintFile(const std::vector<Placed> &shapes, const QColor &color);
    void fillAreas(const std::vector<std::vector<QPolygonF>> &areas, const QColor &color);
    void drawLine(const QPolygonF &line);
    void paintPoints(const std::vector<QPointF> &points, const QColor &color);
    QPolygonF pixelsOf(const QPolygonF &line, double shift) const;
    bool takeCell(const QPointF &pixel);
    void paintNames(const std::vector<Placed> &shapes);

    QPainter &m_painter;
    const MapViewport &m_viewport;
    const QPalette &m_palette;
    const QRectF m_picture; ///< with a margin, in pixels
    int m_cellsAcross;
    std::vector<bool> m_cells;   ///< of the picture: where a mark was painted
    std::vector<QRectF> m_taken; ///< by names
    int m_tried = 0;             ///< names
};

} // namespace skyseal::ui
