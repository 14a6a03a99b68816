// Requests of an operator to the flight: modes, take-off, destinations, speeds. Independent of MAVLink: every request is a
// method, every refusal a sentence.
#pragma once

#include "core/sim/arming.h"

namespace skyseal::sim {

class FlightRequests
{
public:
    FlightRequests(FlightContext &flight, const Arming &arming) : m_flight(flight), m_arming(arming) {}

    Refusal enterMode(FlightMode mode);
    /// Climbs to a height in m above home: ArduCopter in GUIDED and armed, PX4 by a mode of its own.
    Refusal takeOff(double height);
    /// Goes to a place in GUIDED, NED from the origin.
    Refusal goTo(const Vector3 &place);
    /// Moves at a velocity (m/s, NED) in GUIDED.
    Refusal move(const Vector3 &velocity);
    /// Turns the nose (rad) in GUIDED and AUTO; `rate` in rad/s, 0 = as the parameter says.
    Refusal face(double heading, double rate);
    /// Turns the nose of a copter to a place, NED, and keeps it there while GUIDED or AUTO lasts; nullopt: no longer. In other
    /// modes it changes nothing, as in ArduCopter.
    void pointAt(const std::optional<Vector3> &place);
    enum class SpeedKind { Ground, Climb, Descent };
    Refusal changeSpeed(SpeedKind kind, double speed);
    Refusal startMission();
    /// NED from the origin; refused before the first fix and far away.
    bool setHome(const Vector3 &place);

private:
    std::string guidedName() const;

    FlightContext &m_flight;
    const Arming &m_arming;
};

} // namespace skyseal::sim
