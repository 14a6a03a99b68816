#include "core/sim/take_off_climb.h"

namespace skyseal::sim {

void TakeOffClimb::begin(const Situation &s, double height)
{
    m_height = height;
    m_spooling = 0;
    m_place = {s.estimate.position.x, s.estimate.position.y, s.settings.speed};
    m_heading = {s.estimate.attitude.euler().yaw, 0};
}

FlightDemand TakeOffClimb::update(double dt, const Situation &s)
{
    m_spooling += dt;
    FlightDemand demand;
    demand.horizontal = m_place;
    demand.vertical = HoldAltitude{m_height - s.home.z, s.settings.climb, s.settings.descent};
    demand.yaw = m_heading;
    demand.idle = s.landed && m_spooling < s.settings.spoolTime;
    return demand;
}

} // namespace skyseal::sim
