// The vertical climb from the ground to a height, for GUIDED and for the mission's NAV_TAKEOFF.
#pragma once

#include "core/sim/situation.h"

namespace skyseal::sim {

class TakeOffClimb
{
public:
    /// `height` in m above home.
    void begin(const Situation &s, double height);
    FlightDemand update(double dt, const Situation &s);
    bool done(const Situation &s) const { return std::abs(s.heightAboveHome() - m_height) < std::max(0.3, m_height * 0.02); }
    double height() const { return m_height; }

private:
    double m_height = 0;
    double m_spooling = 0; ///< s since the rotors were asked to spin up
    HoldPosition m_place;
    Heading m_heading;
};

} // namespace skyseal::sim
