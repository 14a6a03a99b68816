// Moving air: a steady wind with gusts, and the small torques that turbulence puts on the frame.
#pragma once

#include "core/sim/noise.h"
#include "core/sim/vector3.h"

namespace skyseal::sim {

class Wind
{
public:
    explicit Wind(std::uint64_t seed) : m_noise(seed, 1) {}

    /// Advances by `dt` seconds. `speed` in m/s and `from` in rad (where it blows from) are the steady part.
    void step(double dt, double speed, double from)
    {
        const double gustiness = 0.25 + speed * 0.15;
        m_velocity = {-std::cos(from) * speed + m_north.step(m_noise, dt) * gustiness,
                      -std::sin(from) * speed + m_east.step(m_noise, dt) * gustiness,
                      m_down.step(m_noise, dt) * gustiness * 0.4};
        m_torque = {m_roll.step(m_noise, dt) * gustiness, m_pitch.step(m_noise, dt) * gustiness,
                    m_yaw.step(m_noise, dt) * gustiness};
    }

    const Vector3 &velocity() const { return m_velocity; } ///< m/s, NED
    const Vector3 &torque() const { return m_torque; }     ///< rad/s², body axes

private:
    Noise m_noise;
    Drift m_north{1, 3}, m_east{1, 3}, m_down{1, 1.5};
    Drift m_roll{1, 0.1}, m_pitch{1, 0.1}, m_yaw{0.2, 0.2};
    Vector3 m_velocity;
    Vector3 m_torque;
};

} // namespace skyseal::sim
