// The modes that keep a place and a height without the pilot: LOITER and CIRCLE of an aeroplane, LOITER of a rover.
#pragma once

#include "core/sim/situation.h"

namespace skyseal::sim {

class HoldHere
{
public:
    void begin(const Situation &s)
    {
        m_place = stoppingPoint(s);
        m_altitude = s.estimate.altitude();
    }

    FlightDemand update(const Situation &s) const
    {
        FlightDemand demand;
        demand.horizontal = HoldPosition{m_place.north, m_place.east, s.settings.speed};
        demand.vertical = HoldAltitude{m_altitude, s.settings.climb, s.settings.descent};
        demand.idle = s.landed;
        return demand;
    }

    Vector3 place() const { return {m_place.north, m_place.east, -m_altitude}; }

private:
    HoldPosition m_place;
    double m_altitude = 0; ///< m over the origin
};

} // namespace skyseal::sim
