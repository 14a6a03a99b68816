#include "core/sim/rotor_control.h"

#include <algorithm>

namespace skyseal::sim {

namespace {

constexpr double kIdleCommand = 0.05;

} // namespace

void RotorControl::update(double dt, bool armed, const FlightDemand &demand, const Estimate &estimate,
                          const FlightSettings &settings)
{
    m_idle = !armed || demand.idle;
    if (m_idle) {
        m_commands.fill(armed ? kIdleCommand : 0);
        m_thrust = 0;
        m_position.reset(estimate);
        m_attitude.reset({0, 0, estimate.attitude.euler().yaw});
        return;
    }
    const AttitudeDemand attitude = m_position.update(dt, demand, estimate, settings);
    m_thrust = std::clamp(attitude.thrust, 0.0, 1.0);
    m_commands = m_attitude.update(dt, attitude, estimate.attitude, estimate.rates, settings);
}

} // namespace skyseal::sim
