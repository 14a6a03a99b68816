// GUIDED: the ground station flies. Take-off, go to a place, move at a velocity, turn; without a request it holds its position.
#pragma once

#include "core/sim/auto_yaw.h"
#include "core/sim/take_off_climb.h"

#include <optional>

namespace skyseal::sim {

class Guided
{
public:
    void begin(const Situation &s);
    FlightDemand update(double dt, const Situation &s);

    void takeOff(const Situation &s, double height);
    /// Fly to a place; the height in m over the origin.
    void goTo(const Situation &s, double north, double east, double altitude);
    /// Move at a velocity (m/s, NED) until it is not renewed for `timeout` seconds.
    void move(const Vector3 &velocity, double timeout);
    /// For this flight in GUIDED, m/s.
    void setSpeed(double speed) { m_speed = speed; }
    void setClimb(double speed) { m_climb = speed; }
    void setDescent(double speed) { m_descent = speed; }
    AutoYaw &yaw() { return m_yaw; }

    bool takingOff() const { return m_phase == Phase::TakeOff; }
    const HoldPosition &place() const { return m_place; }
    double altitude() const { return m_altitude; }

private:
    enum class Phase { Waiting, TakeOff, Hold, Moving };
    void hold(const Situation &s);

    Phase m_phase = Phase::Waiting;
    TakeOffClimb m_takeOff;
    HoldPosition m_place;
    double m_altitude = 0;
    Vector3 m_velocity;
    double m_velocityLeft = 0; ///< s
    std::optional<double> m_speed, m_climb, m_descent;
    AutoYaw m_yaw;
};

} // namespace skyseal::sim
