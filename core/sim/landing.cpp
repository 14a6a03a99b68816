#include "core/sim/landing.h"

namespace skyseal::sim {

FlightDemand Landing::update(const Situation &s) const
{
    const FlightSettings &settings = s.settings;
    const double fast = settings.landSpeedHigh > 0 ? settings.landSpeedHigh : settings.descent;
    // The shaped descent needs room to slow down before the last metres.
    const double room = std::max(s.heightAboveHome() - settings.landLow, 0.0);
    const double rate = std::min(fast,
                                 std::sqrt(settings.landSpeed * settings.landSpeed + settings.verticalAcceleration * room));

    FlightDemand demand;
    if (s.estimate.positionOk)
        demand.horizontal = m_place;
    else
        demand.horizontal = Lean{};
    demand.vertical = Climb{-std::max(rate, settings.landSpeed)};
    demand.yaw = m_heading;
    demand.touchdown = true;
    demand.idle = s.landed;
    return demand;
}

} // namespace skyseal::sim
