// The inner loops: a demanded attitude and thrust become rotor commands. Angles follow through a lag, an angle loop and a
// rate loop, as on the autopilots that this imitates.
#pragma once

#include "core/sim/airframe.h"
#include "core/sim/flight_settings.h"

namespace skyseal::sim {

struct AttitudeDemand
{
    double roll = 0;    ///< rad
    double pitch = 0;   ///< rad
    double yaw = 0;     ///< rad
    double yawRate = 0; ///< rad/s, how fast `yaw` is meant to move
    double thrust = 0;  ///< mean of the four rotors, [0, 1]
};

class AttitudeController
{
public:
    /// Rotor commands for the next `dt` seconds, from the attitude and rates as the vehicle knows them.
    Rotors update(double dt, const AttitudeDemand &demand, const Attitude &attitude, const Vector3 &rates,
                  const FlightSettings &settings);

    /// Forgets what it was following: before take-off and after landing.
    void reset(const Euler &angles);

    /// The angles that are followed now, after the input lag (rad).
    const Euler &target() const { return m_target; }

private:
    Euler m_target;
    Vector3 m_trim; ///< integral of the rate errors, rad/s²
};

} // namespace skyseal::sim
