#include "core/sim/return_flight.h"

namespace skyseal::sim {

void ReturnFlight::begin(const Situation &s)
{
    const FlightSettings &settings = s.settings;
    const double height = s.heightAboveHome();
    m_goal = s.returnPoint;
    const double distance = (m_goal - s.estimate.position).horizontal();
    m_height = std::max({height + settings.rtlClimbMin, settings.rtlAltitude, s.home.z - m_goal.z});
    if (settings.rtlCone >= 0.5) // near home there is no need to climb high: stay below a cone over it
        m_height = std::max({std::min(m_height, std::max(distance * settings.rtlCone, 2.0)), height + settings.rtlClimbMin});
    m_waited = 0;
    m_yaw.reset(s);
    if (!settings.hovers)
        m_height = std::max(settings.rtlAltitude, s.home.z - m_goal.z); // climbs or descends on the way
    enter(settings.hovers ? Phase::Climb : Phase::Return, s);
}

void ReturnFlight::enter(Phase phase, const Situation &s)
{
    m_phase = phase;
    if (phase == Phase::Climb)
        m_place = stoppingPoint(s);
    else
        m_place = {m_goal.x, m_goal.y, s.settings.rtlSpeed > 0 ? s.settings.rtlSpeed : s.settings.speed};
    if (phase == Phase::Land)
        m_landing.begin(s, m_place);
}

bool ReturnFlight::reached(const Situation &s) const
{
    return std::hypot(m_place.north - s.estimate.position.x, m_place.east - s.estimate.position.y) < s.settings.waypointRadius;
}

FlightDemand ReturnFlight::update(double dt, const Situation &s)
{
    switch (m_phase) {
    case Phase::Climb:
        if (s.heightAboveHome() > m_height - 0.3)
            enter(Phase::Return, s);
        break;
    case Phase::Return:
        if (s.settings.hovers && reached(s)) // the others stay there, in circles or at rest
            enter(Phase::Wait, s);
        break;
    case Phase::Wait:
        m_waited += dt;
        if (m_waited >= s.settings.rtlLoiter)
            enter(s.settings.rtlFinalAltitude > 0 ? Phase::Descend : Phase::Land, s);
        break;
    case Phase::Descend: break;
    case Phase::Land: return m_landing.update(s);
    }

    FlightDemand demand;
    demand.horizontal = m_place;
    const double height = m_phase == Phase::Descend ? s.settings.rtlFinalAltitude : m_height;
    demand.vertical = HoldAltitude{height - s.home.z, s.settings.climb, s.settings.descent};
    demand.yaw = m_phase == Phase::Return ? m_yaw.towards(s, m_place) : m_yaw.hold(s);
    demand.idle = s.landed;
    return demand;
}

} // namespace skyseal::sim
