#include "ui/map/map_camera.h"

#include "ui/tiles/mercator.h"

#include <cmath>

namespace skyseal::ui {

namespace {
constexpr double kFirstScale = 0.5;    ///< metres on the ground per pixel, when the first vehicle is shown
constexpr double kWorldScale = 40'000; ///< metres per pixel, until then
} // namespace

MapCamera::MapCamera(QObject *parent) : QObject(parent)
{
    m_viewport.setMetresPerPixel(kWorldScale);
    connect(&m_motion, &MapMotion::moved, this, &MapCamera::changed);
    connect(&m_motion, &MapMotion::settled, this, &MapCamera::changed);
    connect(&m_rotation, &MapRotation::toggled, this, &MapCamera::turn);
}

void MapCamera::setSize(const QSizeF &size)
{
    m_viewport.setSize(size);
    Q_EMIT changed();
}

void MapCamera::showVehicle(const std::optional<QPointF> &metres, bool moved)
{
    m_vehicle = metres;
    if (!m_vehicle || !moved)
        return;
    if (!m_placed)
        showFirst();
    if (!m_follow || m_held)
        return;
    // Follow in steps: the ground is redrawn only when the vehicle leaves the middle of the picture.
    const QPointF off = m_viewport.toPixels(*m_vehicle) - middle();
    if (std::abs(off.x()) > middle().x() / 2 || std::abs(off.y()) > middle().y() / 2) {
        m_viewport.setCentre(*m_vehicle);
        Q_EMIT changed();
    }
}

void MapCamera::showFirst()
{
    m_placed = true;
    m_viewport.setCentre(*m_vehicle);
    m_viewport.setMetresPerPixel(kFirstScale * mercator::stretch(m_vehicle->y()));
    Q_EMIT changed();
}

void MapCamera::showHeading(double heading, double groundSpeed)
{
    m_rotation.showHeading(heading, groundSpeed);
    if (m_follow)
        turn();
}

/// Around the vehicle, if the map follows it. A map that the operator has moved stays as it is, until it follows again or north
/// is to point up.
void MapCamera::turn()
{
    if (m_held || (m_rotation.isOn() && !m_follow))
        return;
    if (m_rotation.target() != m_viewport.heading())
        m_motion.turn(m_follow && m_vehicle ? m_viewport.toPixels(*m_vehicle) : middle(), m_rotation.target());
}

void MapCamera::follow()
{
    m_follow = true;
    m_motion.stop();
    if (m_vehicle)
        m_viewport.setCentre(*m_vehicle);
    turn();
    Q_EMIT changed();
}

void MapCamera::leaveVehicle()
{
    m_follow = false;
    m_placed = true;
}

void MapCamera::pan(const QPointF &pixels)
{
    leaveVehicle();
    m_motion.pan(pixels);
}

void MapCamera::hold()
{
    m_held = true;
    m_motion.stop();
}

void MapCamera::drag(const QPointF &pixels)
{
    leaveVehicle();
    m_viewport.pan(pixels);
    Q_EMIT changed();
}

void MapCamera::pinch(const QPointF &from, const QPointF &to, double factor)
{
    leaveVehicle();
    m_motion.stop();
    m_viewport.pan(to - from);
    m_viewport.zoomAt(to, factor);
    Q_EMIT changed();
}

} // namespace skyseal::ui

#include "moc_map_camera.cpp"
