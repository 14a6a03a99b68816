// The part of the plane that the map shows: its centre, scale and size. North is up.
#pragma once

#include <QtCore/QPointF>
#include <QtCore/QSizeF>

#include <algorithm>

namespace skyseal::ui {

class MapViewport
{
public:
    static constexpr double kNearest = 0.02, kFarthest = 200; ///< metres per pixel

    /// Metres, see LocalFrame.
    const QPointF &centre() const { return m_centre; }
    void setCentre(const QPointF &metres) { m_centre = metres; }
    double metresPerPixel() const { return m_metresPerPixel; }
    /// Pixels.
    const QSizeF &size() const { return m_size; }
    void setSize(const QSizeF &size) { m_size = size; }

    /// Returns the pixel of a position in metres.
    QPointF toPixels(const QPointF &metres) const
    {
        const QPointF from = (metres - m_centre) / m_metresPerPixel;
        return {m_size.width() / 2 + from.x(), m_size.height() / 2 - from.y()};
    }

    /// Enlarges by `factor` and keeps the position under this pixel where it is.
    void zoomAt(const QPointF &pixel, double factor)
    {
        const double next = std::clamp(m_metresPerPixel / factor, kNearest, kFarthest);
        const QPointF from(pixel.x() - m_size.width() / 2, m_size.height() / 2 - pixel.y());
        m_centre += from * (m_metresPerPixel - next);
        m_metresPerPixel = next;
    }

    /// Moves the picture to the right and down.
    void pan(const QPointF &pixels) { m_centre += QPointF(-pixels.x(), pixels.y()) * m_metresPerPixel; }

private:
    QPointF m_centre;
    double m_metresPerPixel = 0.5;
    QSizeF m_size;
};

} // namespace skyseal::ui
