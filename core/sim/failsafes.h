// The failsafes: watches battery, radio, position, estimator, fence and ground contact in flight, reports to the station, and
// acts as the parameters say. The station's heartbeats are watched by the owner of the link, who calls trigger().
#pragma once

#include "core/sim/arming.h"

namespace skyseal::sim {

class Failsafes
{
public:
    Failsafes(FlightContext &flight, Arming &arming) : m_flight(flight), m_arming(arming) {}

    /// Once per step, after the physics.
    void step();

    /// Changes to a mode, or lands if that is impossible; on the ground it disarms.
    void trigger(std::string_view cause, FlightMode action);
    /// The cause is gone; the vehicle goes on with what it began.
    void clear(std::string_view cause);
    /// Whether a failsafe was triggered in this flight and not cleared.
    bool active() const { return m_arming.armed() && m_activeIn == m_arming.count(); }

private:
    void watchGround();
    void watchPosition();
    void watchBattery();
    void watchRadio();
    void watchEstimator();
    void watchFence();

    FlightContext &m_flight;
    Arming &m_arming;
    EstimatorWatch m_estimatorWatch;
    unsigned m_activeIn = 0; ///< number of the arming; 0 for none
    bool m_hadPosition = false;
    bool m_glitching = false;
};

} // namespace skyseal::sim
