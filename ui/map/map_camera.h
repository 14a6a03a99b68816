// The part of the map that is shown, and all that moves it. It follows the vehicle until the operator moves it, and turns with
// the vehicle if the operator wants that. Lives on the GUI thread.
#pragma once

#include "ui/map/map_motion.h"
#include "ui/map/map_rotation.h"
#include "ui/map/map_viewport.h"

#include <QtCore/QObject>

#include <optional>

namespace skyseal::ui {

class MapCamera : public QObject
{
    Q_OBJECT

public:
    explicit MapCamera(QObject *parent = nullptr);

    const MapViewport &viewport() const { return m_viewport; }
    MapRotation &rotation() { return m_rotation; }
    bool isFollowing() const { return m_follow; }
    /// Until a zoom or a movement by keys has ended.
    bool isMoving() const { return m_motion.isMoving(); }
    /// Without animation, everything happens at once.
    void setAnimated(bool animated) { m_motion.setAnimated(animated); }
    /// Pixels.
    void setSize(const QSizeF &size);

    /// Takes the position of the selected vehicle, in metres of the projection; `moved` if it is a new one. The first one is
    /// shown from near.
    void showVehicle(const std::optional<QPointF> &metres, bool moved);
    /// Takes its heading in degrees and its speed over the ground in metres a second; unknown ones are NaN.
    void showHeading(double heading, double groundSpeed);
    /// Another vehicle may come; where the map stands, it stays.
    void forgetVehicle() { m_vehicle.reset(); }
    /// Follows the next position of a vehicle.
    void followNext() { m_follow = true; }
    /// Moves to the vehicle at once, and follows it.
    void follow();

    /// Enlarges by `factor` around this pixel, or around the middle.
    void zoom(const QPointF &pixel, double factor) { m_motion.zoom(pixel, factor); }
    void zoom(double factor) { zoom(middle(), factor); }
    /// Moves the picture to the right and down, smoothly. Leaves the vehicle, as drag() and pinch() do.
    void pan(const QPointF &pixels);
    /// The operator holds the map: until letGo(), it neither follows nor turns.
    void hold();
    void letGo() { m_held = false; }
    bool isHeld() const { return m_held; }
    /// Moves the picture at once.
    void drag(const QPointF &pixels);
    /// Two fingers: their middle has moved, and their distance has grown by `factor`.
    void pinch(const QPointF &from, const QPointF &to, double factor);

Q_SIGNALS:
    /// The viewport has changed, or a movement has ended.
    void changed();

private:
    QPointF middle() const { return {m_viewport.size().width() / 2, m_viewport.size().height() / 2}; }
    void showFirst();
    void turn();
    void leaveVehicle();

    MapViewport m_viewport;
    MapMotion m_motion{m_viewport};
    MapRotation m_rotation;
    std::optional<QPointF> m_vehicle; ///< metres of the projection
    bool m_follow = true;
    bool m_placed = false; ///< a vehicle was shown, or the operator has moved the map
    bool m_held = false;
};

} // namespace skyseal::ui
