// The modes in which the pilot's sticks fly: STABILIZE, ALT_HOLD and LOITER; and BRAKE, which ignores them.
#pragma once

#include "core/sim/situation.h"

#include <optional>

namespace skyseal::sim {

FlightDemand stabilize(const Situation &s);
FlightDemand holdAltitude(const Situation &s);

/// Sticks command a velocity; centred, the place is held.
class LoiterMode
{
public:
    void begin(const Situation &s) { m_place = stoppingPoint(s); }
    FlightDemand update(const Situation &s);

private:
    std::optional<HoldPosition> m_place;
};

class Brake
{
public:
    void begin(const Situation &s);
    FlightDemand update(const Situation &s);

private:
    std::optional<HoldPosition> m_place; ///< once it is nearly at rest
    double m_altitude = 0;
    Heading m_heading;
};

} // namespace skyseal::sim
