#include "core/sim/attitude.h"

namespace skyseal::sim {

Attitude Attitude::fromEuler(const Euler &angles)
{
    const Attitude yaw(std::cos(angles.yaw / 2), {0, 0, std::sin(angles.yaw / 2)});
    const Attitude pitch(std::cos(angles.pitch / 2), {0, std::sin(angles.pitch / 2), 0});
    const Attitude roll(std::cos(angles.roll / 2), {std::sin(angles.roll / 2), 0, 0});
    return yaw * pitch * roll;
}

Euler Attitude::euler() const
{
    const auto &[x, y, z] = m_v;
    return {std::atan2(2 * (m_w * x + y * z), 1 - 2 * (x * x + y * y)), std::asin(std::clamp(2 * (m_w * y - z * x), -1.0, 1.0)),
            std::atan2(2 * (m_w * z + x * y), 1 - 2 * (y * y + z * z))};
}

Vector3 Attitude::toWorld(const Vector3 &body) const
{
    const Vector3 t = cross(m_v, body) * 2;
    return body + t * m_w + cross(m_v, t);
}

Attitude Attitude::turned(const Vector3 &rates, double dt) const
{
    Attitude out = *this * Attitude(1, rates * (dt / 2));
    out.normalise();
    return out;
}

Vector3 Attitude::errorTo(const Attitude &target) const
{
    Attitude difference = conjugate() * target;
    if (difference.m_w < 0)
        difference = {-difference.m_w, -difference.m_v};
    const double size = difference.m_v.length();
    if (size < 1e-9)
        return difference.m_v * 2;
    return difference.m_v * (2 * std::atan2(size, difference.m_w) / size);
}

Attitude Attitude::operator*(const Attitude &o) const
{
    return {m_w * o.m_w - m_v.x * o.m_v.x - m_v.y * o.m_v.y - m_v.z * o.m_v.z, o.m_v * m_w + m_v * o.m_w + cross(m_v, o.m_v)};
}

void Attitude::normalise()
{
    const double size = std::sqrt(m_w * m_w + m_v.x * m_v.x + m_v.y * m_v.y + m_v.z * m_v.z);
    m_w /= size;
    m_v = m_v * (1 / size);
}

} // namespace skyseal::sim
