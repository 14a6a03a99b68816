#include "core/sim/guided.h"

namespace skyseal::sim {

void Guided::begin(const Situation &s)
{
    m_speed.reset();
    m_climb.reset();
    m_descent.reset();
    m_yaw.reset(s);
    hold(s);
    if (s.landed)
        m_phase = Phase::Waiting;
}

void Guided::hold(const Situation &s)
{
    m_phase = Phase::Hold;
    m_place = stoppingPoint(s);
    m_altitude = s.estimate.altitude();
}

void Guided::takeOff(const Situation &s, double height)
{
    m_takeOff.begin(s, height);
    m_phase = Phase::TakeOff;
    m_place = {s.estimate.position.x, s.estimate.position.y, s.settings.speed};
    m_altitude = height - s.home.z;
}

void Guided::goTo(const Situation &s, double north, double east, double altitude)
{
    m_phase = Phase::Hold;
    m_place = {north, east, s.settings.speed};
    m_altitude = altitude;
}

void Guided::move(const Vector3 &velocity, double timeout)
{
    m_phase = Phase::Moving;
    m_velocity = velocity;
    m_velocityLeft = timeout;
}

FlightDemand Guided::update(double dt, const Situation &s)
{
    if (m_phase == Phase::TakeOff) {
        if (!m_takeOff.done(s))
            return m_takeOff.update(dt, s);
        m_phase = Phase::Hold;
    }
    if (m_phase == Phase::Moving && (m_velocityLeft -= dt) <= 0)
        hold(s);

    FlightDemand demand;
    demand.idle = s.landed;
    if (m_phase == Phase::Moving) {
        const Vector3 limited = m_velocity.horizontalLimited(m_speed.value_or(s.settings.speed));
        demand.horizontal = Velocity{limited.x, limited.y};
        demand.vertical = Climb{
            std::clamp(-m_velocity.z, -m_descent.value_or(s.settings.descent), m_climb.value_or(s.settings.climb))};
        demand.yaw = m_yaw.hold(s);
        return demand;
    }
    m_place.speed = m_speed.value_or(s.settings.speed);
    demand.horizontal = m_place;
    demand.vertical = HoldAltitude{m_altitude, m_climb.value_or(s.settings.climb), m_descent.value_or(s.settings.descent)};
    demand.yaw = m_yaw.towards(s, m_place);
    return demand;
}

} // namespace skyseal::sim
