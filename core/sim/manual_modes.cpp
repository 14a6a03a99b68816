#include "core/sim/manual_modes.h"

namespace skyseal::sim {

namespace {

constexpr double kThrottleDeadZone = 0.1;
constexpr double kAtRest = 0.5; // m/s: slow enough to call the present place the one to hold

Turn turnRate(const Situation &s)
{
    return {s.sticks.yaw * s.settings.pilotYawRate};
}

/// Climb rate by the throttle stick: nothing around its middle.
Climb climbRate(const Situation &s)
{
    const double offset = s.sticks.throttle - 0.5;
    if (std::abs(offset) < kThrottleDeadZone)
        return {0};
    const double share = (std::abs(offset) - kThrottleDeadZone) / (0.5 - kThrottleDeadZone);
    return {offset > 0 ? share * s.settings.pilotClimb : -share * s.settings.pilotDescent};
}

} // namespace

FlightDemand stabilize(const Situation &s)
{
    // The middle of the stick hovers, whatever the vehicle weighs.
    const double t = s.sticks.throttle;
    const double hover = s.settings.hoverThrottle;
    FlightDemand demand;
    demand.horizontal = Lean{s.sticks.roll * s.settings.leanLimit, s.sticks.pitch * s.settings.leanLimit};
    demand.vertical = Thrust{t < 0.5 ? 2 * t * hover : hover + (2 * t - 1) * (1 - hover)};
    demand.yaw = turnRate(s);
    demand.idle = s.landed && t < 0.1;
    return demand;
}

FlightDemand holdAltitude(const Situation &s)
{
    FlightDemand demand;
    demand.horizontal = Lean{s.sticks.roll * s.settings.leanLimit, s.sticks.pitch * s.settings.leanLimit};
    const Climb climb = climbRate(s);
    demand.vertical = climb;
    demand.yaw = turnRate(s);
    demand.idle = s.landed && climb.rate <= 0;
    return demand;
}

FlightDemand LoiterMode::update(const Situation &s)
{
    FlightDemand demand = holdAltitude(s);
    if (s.landed)
        m_place = stoppingPoint(s);
    const double forward = -s.sticks.pitch * s.settings.loiterSpeed;
    const double right = s.sticks.roll * s.settings.loiterSpeed;
    if (forward != 0 || right != 0) {
        const double yaw = s.estimate.attitude.euler().yaw;
        demand.horizontal = Velocity{forward * std::cos(yaw) - right * std::sin(yaw),
                                     forward * std::sin(yaw) + right * std::cos(yaw)};
        m_place.reset();
        return demand;
    }
    if (!m_place && s.estimate.velocity.horizontal() < kAtRest)
        m_place = stoppingPoint(s);
    if (m_place)
        demand.horizontal = *m_place;
    else
        demand.horizontal = Velocity{};
    return demand;
}

void Brake::begin(const Situation &s)
{
    m_place.reset();
    m_altitude = s.estimate.altitude();
    m_heading = {s.estimate.attitude.euler().yaw, 0};
}

FlightDemand Brake::update(const Situation &s)
{
    if (!m_place && s.estimate.velocity.horizontal() < kAtRest)
        m_place = stoppingPoint(s);
    FlightDemand demand;
    if (m_place)
        demand.horizontal = *m_place;
    else
        demand.horizontal = Velocity{};
    demand.vertical = HoldAltitude{m_altitude, s.settings.climb, s.settings.descent};
    demand.yaw = m_heading;
    demand.idle = s.landed;
    return demand;
}

} // namespace skyseal::sim
