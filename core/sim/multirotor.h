// A quadcopter: the cascade of controllers on an airframe with four rotors.
#pragma once

#include "core/sim/craft.h"
#include "core/sim/rotor_control.h"

namespace skyseal::sim {

class Multirotor : public Craft
{
public:
    explicit Multirotor(const BodyState &start) : m_airframe(AirframeModel{}, start) {}

    void step(double dt, bool armed, const FlightDemand &demand, const Estimate &estimate, const FlightSettings &settings,
              const Surroundings &around) override;
    const BodyState &state() const override { return m_airframe.state(); }
    double takeImpact() override { return m_airframe.takeImpact(); }
    bool idle() const override { return m_control.idle(); }
    double throttle() const override { return m_control.thrust(); }
    double load() const override;
    Euler target() const override { return m_control.attitude().target(); }
    Signals signals(bool armed, const Parameters &parameters) const override;

private:
    RotorControl m_control;
    Airframe m_airframe;
};

} // namespace skyseal::sim
