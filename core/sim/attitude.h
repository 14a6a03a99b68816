// Orientation of the body in the world as a unit quaternion, and its roll, pitch and yaw. A quaternion, so that nothing
// is singular when a vehicle with stopped motors tumbles.
#pragma once

#include "core/sim/vector3.h"

#include <algorithm>
#include <numbers>

namespace skyseal::sim {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double radians(double degrees)
{
    return degrees * kPi / 180;
}
inline constexpr double degrees(double radians)
{
    return radians * 180 / kPi;
}

/// An angle (rad) brought into [-pi, pi].
inline double wrapPi(double angle)
{
    return std::remainder(angle, 2 * kPi);
}

/// Roll, pitch, yaw in rad, in the aerospace order (yaw first).
struct Euler
{
    double roll = 0;
    double pitch = 0;
    double yaw = 0;
};

/// Rotation from body (FRD) to world (NED).
class Attitude
{
public:
    Attitude() = default;
    static Attitude fromEuler(const Euler &angles);

    Euler euler() const;
    double w() const { return m_w; }
    const Vector3 &vector() const { return m_v; }
    Vector3 toWorld(const Vector3 &body) const;
    Vector3 toBody(const Vector3 &world) const { return conjugate().toWorld(world); }
    /// Turned by `rates` (rad/s, body axes) for `dt` seconds.
    Attitude turned(const Vector3 &rates, double dt) const;
    /// The rotation vector (rad, body axes) that leads from here to `target` by the shorter way.
    Vector3 errorTo(const Attitude &target) const;
    /// Cosine of the angle between the body's and the world's vertical axis.
    double cosTilt() const { return 1 - 2 * (m_v.x * m_v.x + m_v.y * m_v.y); }

private:
    Attitude(double w, const Vector3 &v) : m_w(w), m_v(v) {}
    Attitude conjugate() const { return {m_w, -m_v}; }
    Attitude operator*(const Attitude &o) const;
    void normalise();

    double m_w = 1;
    Vector3 m_v;
};

} // namespace skyseal::sim
