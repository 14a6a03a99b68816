// Heading in automatic modes: towards the next place, towards a region of interest, or as the operator requested.
#pragma once

#include "core/sim/situation.h"

#include <optional>

namespace skyseal::sim {

class AutoYaw
{
public:
    /// Back to the direction of flight; keeps the present heading until there is one.
    void reset(const Situation &s)
    {
        m_fixed = false;
        m_interest.reset();
        m_heading = {s.estimate.attitude.euler().yaw, 0};
    }

    /// Keeps a heading (rad) until the next reset; `rate` in rad/s, 0 = as the parameter says.
    void fix(double heading, double rate = 0)
    {
        m_fixed = true;
        m_interest.reset();
        m_heading = {wrapPi(heading), rate};
    }

    /// Faces a place, NED, until the next reset or request.
    void face(const Vector3 &place)
    {
        m_fixed = false;
        m_interest = place;
    }

    Yaw towards(const Situation &s, const HoldPosition &place)
    {
        if (!m_interest && !m_fixed)
            turnTo(s, place.north, place.east);
        return hold(s);
    }

    /// The heading without a place to fly to.
    Yaw hold(const Situation &s)
    {
        if (m_interest)
            turnTo(s, m_interest->x, m_interest->y);
        return m_heading;
    }

private:
    void turnTo(const Situation &s, double placeNorth, double placeEast)
    {
        const double north = placeNorth - s.estimate.position.x;
        const double east = placeEast - s.estimate.position.y;
        if (std::hypot(north, east) > kNear)
            m_heading = {std::atan2(east, north), 0};
    }

    static constexpr double kNear = 3; // m: nearer than this a direction means nothing
    bool m_fixed = false;
    std::optional<Vector3> m_interest;
    Heading m_heading;
};

} // namespace skyseal::sim
