// RTL: climb to a safe height, fly home or to a rally point, wait a little, land. Phases and parameters as ArduCopter has them.
#pragma once

#include "core/sim/auto_yaw.h"
#include "core/sim/landing.h"

namespace skyseal::sim {

class ReturnFlight
{
public:
    void begin(const Situation &s);
    FlightDemand update(double dt, const Situation &s);

    enum class Phase { Climb, Return, Wait, Descend, Land };
    Phase phase() const { return m_phase; }
    /// Where it is heading for now.
    const HoldPosition &place() const { return m_place; }

private:
    void enter(Phase phase, const Situation &s);
    bool reached(const Situation &s) const;

    Phase m_phase = Phase::Climb;
    double m_height = 0; ///< m above home, of the way back
    double m_waited = 0; ///< s
    Vector3 m_goal;      ///< home or a rally point, as it was when the return began
    HoldPosition m_place;
    AutoYaw m_yaw;
    Landing m_landing;
};

} // namespace skyseal::sim
