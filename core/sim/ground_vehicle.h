// A car on flat ground: it steers while it drives, slows down for turns, and stops at a place that it is to hold.
#pragma once

#include "core/sim/craft.h"

namespace skyseal::sim {

class GroundVehicle : public Craft
{
public:
    explicit GroundVehicle(const BodyState &start);

    void step(double dt, bool armed, const FlightDemand &demand, const Estimate &estimate, const FlightSettings &settings,
              const Surroundings &around) override;
    const BodyState &state() const override { return m_state; }
    bool idle() const override { return m_idle; }
    double throttle() const override { return m_throttle; }
    double load() const override { return 0.2 * m_throttle; }
    Euler target() const override { return {0, 0, m_heading}; }
    /// Steering, nothing, throttle, nothing.
    Signals signals(bool armed, const Parameters &parameters) const override;

private:
    struct Motion
    {
        double speed = 0;    ///< m/s, negative backwards
        double turnRate = 0; ///< rad/s
    };
    Motion wanted(const FlightDemand &demand, const Estimate &estimate, const FlightSettings &settings) const;
    Motion towards(double north, double east, double speed, const FlightSettings &settings) const;

    BodyState m_state;
    double m_heading = 0; ///< rad
    double m_speed = 0;   ///< m/s
    double m_turnRate = 0;
    double m_throttle = 0;
    bool m_idle = true;
};

} // namespace skyseal::sim
