// An aeroplane as a point mass in coordinated flight: it turns by banking, needs airspeed to stay up, rolls along the ground to
// take off, and circles around a place that it is to hold.
#pragma once

#include "core/sim/craft.h"

namespace skyseal::sim {

class FixedWing : public Craft
{
public:
    explicit FixedWing(const BodyState &start);

    void step(double dt, bool armed, const FlightDemand &demand, const Estimate &estimate, const FlightSettings &settings,
              const Surroundings &around) override;
    const BodyState &state() const override { return m_state; }
    double takeImpact() override;
    bool idle() const override { return m_idle; }
    double throttle() const override { return m_throttle; }
    double load() const override { return m_throttle; }
    Euler target() const override { return m_wanted; }
    /// Aileron, elevator, throttle, rudder.
    Signals signals(bool armed, const Parameters &parameters) const override;

    double airspeed() const { return m_airspeed; } ///< m/s

private:
    /// Course over ground (rad) that leads to a place and then around it, clockwise.
    static double courseAround(const HoldPosition &place, const Vector3 &position, double radius);
    double wantedRoll(const FlightDemand &demand, const Estimate &estimate, const FlightSettings &settings) const;
    double wantedClimb(const FlightDemand &demand, const Estimate &estimate, const FlightSettings &settings) const;
    void rollAlongGround(double dt, const FlightSettings &settings);
    void fly(double dt, const FlightDemand &demand, const Estimate &estimate, const FlightSettings &settings,
             const Vector3 &wind);
    void setAttitude(double dt, double turnRate);

    BodyState m_state;
    Euler m_wanted;
    double m_heading = 0;  ///< rad, through the air
    double m_roll = 0;     ///< rad
    double m_climb = 0;    ///< m/s
    double m_airspeed = 0; ///< m/s
    double m_throttle = 0;
    double m_impact = 0;
    bool m_idle = true;
};

} // namespace skyseal::sim
