// The part of the map that is shown: its centre, scale, size and the direction that points up. Positions are in metres of the
// projection (see mercator.h).
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
    /// The direction that points up, in degrees clockwise from north, from 0 to below 360.
    double heading() const { return m_heading; }
    void setHeading(double degrees)
    {
        m_heading = degrees - 360 * std::floor(degrees / 360);
        m_cos = std::cos(m_heading * mercator::kRadians);
        m_sin = std::sin(m_heading * mercator::kRadians);
    }
    bool isRotated() const { return m_heading != 0; }
    /// The shorter turn between two directions, from −180 to below 180 degrees; positive: clockwise.
    static double turnBetween(double from, double to) { return to - from - 360 * std::floor((to - from) / 360 + 0.5); }
    /// The shown part in metres, and of a rotated picture all of its corners; its top is the southern edge.
    QRectF visible() const
    {
        const double c = std::abs(m_cos), s = std::abs(m_sin);
        const QSizeF extent = QSizeF(m_size.width() * c + m_size.height() * s, m_size.width() * s + m_size.height() * c)
            * m_metresPerPixel;
        return {m_centre.x() - extent.width() / 2, m_centre.y() - extent.height() / 2, extent.width(), extent.height()};
    }

    /// Returns the pixel of a position.
    QPointF toPixels(const QPointF &metres) const
    {
        const QPointF from = (metres - m_centre) / m_metresPerPixel;
        const double right = from.x() * m_cos - from.y() * m_sin, up = from.x() * m_sin + from.y() * m_cos;
        return {m_size.width() / 2 + right, m_size.height() / 2 - up};
    }
    QPointF toMetres(const QPointF &pixel) const { return m_centre + toGround(fromMiddle(pixel)) * m_metresPerPixel; }

    /// Enlarges by `factor` and keeps the position under this pixel where it is.
    void zoomAt(const QPointF &pixel, double factor)
    {
        const double next = std::clamp(m_metresPerPixel / factor, kNearest, kFarthest);
        setCentre(m_centre + toGround(fromMiddle(pixel)) * (m_metresPerPixel - next));
        m_metresPerPixel = next;
    }

    /// Lets `heading` point up, and keeps the position under this pixel where it is.
    void turnAt(const QPointF &pixel, double heading)
    {
        const QPointF kept = toMetres(pixel);
        setHeading(heading);
        setCentre(m_centre + kept - toMetres(pixel));
    }

    /// Moves the picture to the right and down.
    void pan(const QPointF &pixels) { setCentre(m_centre + toGround({-pixels.x(), pixels.y()}) * m_metresPerPixel); }

    bool operator==(const MapViewport &) const = default;

private:
    /// To the right and up.
    QPointF fromMiddle(const QPointF &pixel) const { return {pixel.x() - m_size.width() / 2, m_size.height() / 2 - pixel.y()}; }
    /// From a way on the picture, to the right and up, to one to the east and north.
    QPointF toGround(const QPointF &way) const
    {
        return {way.x() * m_cos + way.y() * m_sin, way.y() * m_cos - way.x() * m_sin};
    }

    QPointF m_centre;
    double m_metresPerPixel = 0.5;
    QSizeF m_size;
    double m_heading = 0, m_cos = 1, m_sin = 0;
};

} // namespace skyseal::ui
