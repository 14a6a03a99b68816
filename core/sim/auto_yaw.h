// Heading in automatic modes: towards the next place, or as the operator requested.
#pragma once

#include "core/sim/situation.h"

namespace skyseal::sim {

class AutoYaw
{
public:
    /// Back to the direction of flight; keeps the present heading until there is one.
    void reset(const Situation &s)
    {
        m_fixed = false;
        m_heading = {s.estimate.attitude.euler().yaw, 0};
    }

    /// Keeps a heading (rad) until the next reset; `rate` in rad/s, 0 = as the parameter says.
    void fix(double heading, double rate = 0)
    {
        m_fixed = true;
        m_heading = {wrapPi(heading), rate};
    }

    Yaw towards(const Situation &s, const HoldPosition &place)
    {
        const double north = place.north - s.estimate.position.x;
        const double east = place.east - s.estimate.position.y;
        if (!m_fixed && std::hypot(north, east) > kNear)
            m_heading = {std::atan2(east, north), 0};
        return m_heading;
    }

    Yaw hold() const { return m_heading; }

private:
    static constexpr double kNear = 3; // m: nearer than this a direction means nothing
    bool m_fixed = false;
    Heading m_heading;
};

} // namespace skyseal::sim
