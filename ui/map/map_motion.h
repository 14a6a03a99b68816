// Moves the map smoothly: each key and each notch of the wheel adds to a way that is covered in a fraction of a second.
// Lives on the GUI thread.
#pragma once

#include <QtCore/QElapsedTimer>
#include <QtCore/QObject>
#include <QtCore/QPointF>
#include <QtCore/QTimer>

#include <optional>

namespace skyseal::ui {

class MapViewport;

class MapMotion : public QObject
{
    Q_OBJECT

public:
    /// `viewport` must outlive this object.
    explicit MapMotion(MapViewport &viewport, QObject *parent = nullptr);

    /// Enlarges by `factor` around this pixel.
    void zoom(const QPointF &pixel, double factor);
    /// Moves the picture to the right and down.
    void pan(const QPointF &pixels);
    /// Lets `heading` point up, by the shorter way around this pixel.
    void turn(const QPointF &pixel, double heading);
    void stop();
    bool isMoving() const { return m_ticker.isActive(); }
    /// Without animation, everything happens at once.
    void setAnimated(bool animated) { m_animated = animated; }

Q_SIGNALS:
    /// The viewport has changed.
    void moved();
    /// The last change of this movement has been reported.
    void settled();

private:
    void start();
    void tick();
    void advance(double fraction);

    static constexpr int kFrameMs = 16;
    static constexpr double kHalfLifeMs = 40; ///< in which half of the way is covered

    MapViewport &m_viewport;
    QTimer m_ticker;
    QElapsedTimer m_since;
    bool m_animated = true;
    QPointF m_anchor;                ///< of the zoom, in pixels
    double m_zoomLeft = 0;           ///< binary logarithm of the factor
    QPointF m_panLeft;               ///< pixels
    QPointF m_pivot;                 ///< of the turn, in pixels
    std::optional<double> m_heading; ///< at the end of the turn, degrees
};

} // namespace skyseal::ui
