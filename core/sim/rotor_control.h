// The cascade from the demand of a flight mode to the commands of the four rotors: position, then attitude controller.
#pragma once

#include "core/sim/airframe.h"
#include "core/sim/attitude_controller.h"
#include "core/sim/position_controller.h"

namespace skyseal::sim {

class RotorControl
{
public:
    /// Disarmed rotors stand still; those of an idle demand turn slowly, and the controllers start again.
    void update(double dt, bool armed, const FlightDemand &demand, const Estimate &estimate, const FlightSettings &settings);

    /// True if the rotors give no thrust.
    bool idle() const { return m_idle; }
    const Rotors &commands() const { return m_commands; }
    /// Demanded thrust, [0, 1].
    double thrust() const { return m_thrust; }
    const AttitudeController &attitude() const { return m_attitude; }

private:
    PositionController m_position;
    AttitudeController m_attitude;
    Rotors m_commands{};
    double m_thrust = 0;
    bool m_idle = true;
};

} // namespace skyseal::sim
