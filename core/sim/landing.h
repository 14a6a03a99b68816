// The descent to the ground: quick while high, slow near the ground, over one place if the position is known.
#pragma once

#include "core/sim/situation.h"

namespace skyseal::sim {

class Landing
{
public:
    void begin(const Situation &s) { begin(s, stoppingPoint(s)); }
    void begin(const Situation &s, const HoldPosition &place)
    {
        m_place = place;
        m_heading = {s.estimate.attitude.euler().yaw, 0};
    }

    FlightDemand update(const Situation &s) const;

private:
    HoldPosition m_place;
    Heading m_heading;
};

} // namespace skyseal::sim
