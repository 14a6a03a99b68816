// The physical side of a simulated flight: craft, battery and wind, and the sensors and the estimator that observe them.
#pragma once

#include "core/sim/battery.h"
#include "core/sim/craft.h"
#include "core/sim/estimator.h"
#include "core/sim/flight_settings.h"
#include "core/sim/gps.h"
#include "core/sim/wind.h"

#include <memory>

namespace skyseal::sim {

class FlightPhysics
{
public:
    /// `heading` in degrees; `firstFix`: seconds until the GPS has a fix. The vehicle stands at the origin.
    FlightPhysics(const VehicleType &type, std::uint64_t seed, double heading, double firstFix);

    /// `time`: µs of flight time at the end of the step of `dt` seconds.
    void step(double dt, std::uint64_t time, const FlightSettings &settings, const FlightDemand &demand, bool armed);

    const Craft &craft() const { return *m_craft; }
    const BodyState &truth() const { return m_craft->state(); }
    const GpsReport &gps() const { return m_gps.report(); }
    const Estimator &estimator() const { return m_estimator; }
    const Estimate &estimate() const { return m_estimator.estimate(); }
    const Wind &wind() const { return m_wind; }
    Battery &battery() { return m_battery; }
    const Battery &battery() const { return m_battery; }
    /// Speed of the last hit on the ground in m/s, once; 0 without one.
    double takeImpact() { return m_craft->takeImpact(); }

private:
    Wind m_wind;
    std::unique_ptr<Craft> m_craft;
    Battery m_battery;
    double m_restVoltage = Faults{}.restVoltage;
    Gps m_gps;
    Estimator m_estimator;
};

} // namespace skyseal::sim
