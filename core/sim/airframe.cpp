#include "core/sim/airframe.h"

#include <utility>

namespace skyseal::sim {

void Airframe::step(double dt, const Rotors &commands, double supply, const Vector3 &wind, const Vector3 &turbulence)
{
    const double follow = std::min(dt / m_model.rotorLag, 1.0);
    for (std::size_t i = 0; i < commands.size(); ++i)
        m_state.rotors[i] += (std::clamp(commands[i], 0.0, 1.0) * supply - m_state.rotors[i]) * follow;
    const auto &[frontRight, backLeft, frontLeft, backRight] = m_state.rotors;
    const double lift = (frontRight + backLeft + frontLeft + backRight) / 4;

    const Vector3 &authority = m_model.turnAuthority;
    Vector3 turn{(frontLeft + backLeft - frontRight - backRight) / 4 * authority.x,
                 (frontRight + frontLeft - backLeft - backRight) / 4 * authority.y,
                 (frontRight + backLeft - frontLeft - backRight) / 4 * authority.z};
    turn += {-m_state.rates.x * m_model.rateDamping.x, -m_state.rates.y * m_model.rateDamping.y,
             -m_state.rates.z * m_model.rateDamping.z};

    const Vector3 air = m_state.velocity - wind;
    const Vector3 drag = air * -(m_model.linearDrag + m_model.quadraticDrag * air.length());
    const Vector3 thrust{0, 0, -kGravity * lift / m_model.hoverThrust};
    Vector3 acceleration = m_state.attitude.toWorld(thrust) + drag + Vector3{0, 0, kGravity};

    if (m_state.onGround && acceleration.z >= 0) { // the ground carries the rest of its weight
        m_state.velocity = {};
        m_state.rates = {};
        m_state.specificForce = m_state.attitude.toBody({0, 0, -kGravity});
        return;
    }
    m_state.onGround = false;
    m_state.specificForce = thrust + m_state.attitude.toBody(drag);
    m_state.velocity += acceleration * dt;
    m_state.position += m_state.velocity * dt;
    m_state.rates += (turn + turbulence) * dt;
    m_state.attitude = m_state.attitude.turned(m_state.rates, dt);
    if (m_state.position.z > 0)
        meetGround();
}

void Airframe::meetGround()
{
    m_impact = std::max(m_impact, m_state.velocity.z);
    m_state.position.z = 0;
    m_state.velocity = {};
    m_state.rates = {};
    m_state.attitude = Attitude::fromEuler({0, 0, m_state.attitude.euler().yaw}); // the legs level it
    m_state.onGround = true;
}

double Airframe::takeImpact()
{
    return std::exchange(m_impact, 0);
}

} // namespace skyseal::sim
