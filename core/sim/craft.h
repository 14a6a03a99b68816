// A vehicle body with its actuators and control loops. A demand of the flight mode goes in; the
// true state comes out. One class per kind of vehicle.
#pragma once

#include "core/sim/airframe.h"
#include "core/sim/estimate.h"
#include "core/sim/flight_demand.h"
#include "core/sim/flight_settings.h"

#include <array>

namespace skyseal::sim {

class Parameters;

class Craft
{
public:
    /// Inputs of a step besides the demand.
    struct Surroundings
    {
        double supply = 1;  ///< voltage relative to a full battery
        Vector3 wind;       ///< m/s, NED
        Vector3 turbulence; ///< rad/s², body axes
    };
    using Signals = std::array<std::uint16_t, 4>; ///< µs, as SERVO_OUTPUT_RAW carries them; 0 = not driven

    virtual ~Craft() = default;

    /// Moves on by `dt` seconds.
    virtual void step(double dt, bool armed, const FlightDemand &demand, const Estimate &estimate,
                      const FlightSettings &settings, const Surroundings &around) = 0;

    virtual const BodyState &state() const = 0;
    /// Speed (m/s) of the last hit on the ground since the last call; 0 if there was none.
    virtual double takeImpact() { return 0; }
    /// Whether the motors give no thrust.
    virtual bool idle() const = 0;
    /// Demanded thrust, [0, 1].
    virtual double throttle() const = 0;
    /// Load of the motors, a share of their full thrust: scales current and vibration.
    virtual double load() const = 0;
    /// The angles that the control loops follow, rad.
    virtual Euler target() const = 0;
    virtual Signals signals(bool armed, const Parameters &parameters) const = 0;
};

} // namespace skyseal::sim
