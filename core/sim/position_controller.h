// The outer loops: places, velocities, heights and headings become an attitude and a thrust. Demands are shaped by
// acceleration and jerk, so that the vehicle leans smoothly and hardly overshoots.
#pragma once

#include "core/sim/attitude_controller.h"
#include "core/sim/estimate.h"
#include "core/sim/flight_demand.h"

namespace skyseal::sim {

/// A velocity that follows a wanted one within acceleration and jerk limits.
class ShapedVelocity
{
public:
    void reset(const Vector3 &velocity);
    /// Advances by `dt` seconds towards `wanted`; the vertical part has separate limits.
    void step(double dt, const Vector3 &wanted, double acceleration, double verticalAcceleration);
    const Vector3 &velocity() const { return m_velocity; }
    const Vector3 &acceleration() const { return m_acceleration; }

private:
    Vector3 m_velocity;
    Vector3 m_acceleration;
};

class PositionController
{
public:
    /// The attitude and thrust that serve `demand` for the next `dt` seconds.
    AttitudeDemand update(double dt, const FlightDemand &demand, const Estimate &estimate, const FlightSettings &settings);

    /// Starts afresh from where the vehicle is: before take-off and after a switch from manual flight.
    void reset(const Estimate &estimate);


private:
    Vector3 wantedVelocity(const FlightDemand &demand, const Estimate &estimate, const FlightSettings &settings) const;
    void steer(double dt, const Yaw &yaw, const Estimate &estimate, const FlightSettings &settings);

    ShapedVelocity m_shaped;
    Vector3 m_push; ///< integral of the velocity error, m/s²: wind and weight that the model does not know
    double m_heading = 0;
    double m_turnRate = 0;
};

} // namespace skyseal::sim
