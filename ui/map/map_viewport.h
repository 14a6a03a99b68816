// The part of the map that is shown: its centre, scale and size. North is up. Positions are in metres of the projection (see
// mercator.h).
#pragma once

#include "ui/tiles/mercator.h"

#include <QtCore/QPointF>
#include <QtCore/QRectF>
#include <QtCore/QSizeF>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

class MapViewport
{
public:
    static constexpr double kNearest = 0.01, kFarthest = 80'000; ///< metres per pixel
    static constexpr double kTilePixels = 256;                   ///< the side of a tile, and of the world at zoom level 0

    const QPointF &centre() const { return m_centre; }
    void setCentre(const QPointF &metres)
    {
        m_centre = {metres.x(), std::clamp(metres.y(), -mercator::kHalfWorld, mercator::kHalfWorld)};
    }
    double metresPerPixel() const { return m_metresPerPixel; }
    void setMetresPerPixel(double scale) { m_metresPerPixel = std::clamp(scale, kNearest, kFarthest); }
    /// On the ground in the middle of the picture.
    double groundMetresPerPixel() const { return m_metresPerPixel / mercator::stretch(m_centre.y()); }
    /// The level as tile servers count them, with a fraction.
    double zoomLevel() const { return std::log2(2 * mercator::kHalfWorld / kTilePixels / m_metresPerPixel); }
    /// Pixels.
    const QSizeF &size() const { return m_size; }
    void setSize(const QSizeF &size) { m_size = size; }
    /// The shown part in metres; its top is the southern edge.
    QRectF visible() const
    {
        const QSizeF extent = m_size * m_metresPerPixel;
        return {m_centre.x() - extent.width() / 2, m_centre.y() - extent.height() / 2, extent.width(), extent.height()};
    }

    /// Returns the pixel of a position.
    QPointF toPixels(const QPointF &metres) const
    {
        const QPointF from = (metres - m_centre) / m_metresPerPixel;
        return {m_size.width() / 2 + from.x(), m_size.height() / 2 - from.y()};
    }
    QPointF toMetres(const QPointF &pixel) const
    {
        return m_centre + QPointF(pixel.x() - m_size.width() / 2, m_size.height() / 2 - pixel.y()) * m_metresPerPixel;
    }

    /// Enlarges by `factor` and keeps the position under this pixel where it is.
    void zoomAt(const QPointF &pixel, double factor)
    {
        const double next = std::clamp(m_metresPerPixel / factor, kNearest, kFarthest);
        const QPointF from(pixel.x() - m_size.width() / 2, m_size.height() / 2 - pixel.y());
        setCentre(m_centre + from * (m_metresPerPixel - next));
        m_metresPerPixel = next;
    }

    /// Moves the picture to the right and down.
    void pan(const QPointF &pixels) { setCentre(m_centre + QPointF(-pixels.x(), pixels.y()) * m_metresPerPixel); }

    bool operator==(const MapViewport &) const = default;

private:
    QPointF m_centre;
    double m_metresPerPixel = 0.5;
    QSizeF m_size;
};

} // namespace skyseal::ui
