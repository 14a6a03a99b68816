// Input of a flight mode for its next decision.
#pragma once

#include "core/sim/estimate.h"
#include "core/sim/flight_demand.h"
#include "core/sim/flight_settings.h"
#include "core/sim/pilot_input.h"

namespace skyseal::sim {

struct Situation
{
    Estimate estimate;
    FlightSettings settings;
    Sticks sticks;
    Vector3 home;        ///< m, NED from the origin
    Vector3 returnPoint; ///< m, NED from the origin: home, or the rally point at which RTL from here ends
    bool landed = true;

    double heightAboveHome() const { return home.z - estimate.position.z; }
};

/// Where the vehicle comes to rest when it brakes now.
inline HoldPosition stoppingPoint(const Situation &s)
{
    const Vector3 &v = s.estimate.velocity;
    const double lead = 0.5 + v.horizontal() / (2 * std::max(s.settings.acceleration, 0.5));
    return {s.estimate.position.x + v.x * lead, s.estimate.position.y + v.y * lead, std::max(s.settings.speed, v.horizontal())};
}

} // namespace skyseal::sim
