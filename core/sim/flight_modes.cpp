#include "core/sim/flight_modes.h"

namespace skyseal::sim {

const char *FlightModes::enter(FlightMode mode, const Situation &s)
{
    if (mode == m_current)
        return nullptr;
    if (needsPosition(mode) && !s.estimate.positionOk)
        return "requires position";
    if (mode == FlightMode::Auto) {
        if (const char *refusal = m_auto.refusal(s.landed))
            return refusal;
    }
    m_current = mode;
    switch (mode) {
    case FlightMode::Stabilize:
    case FlightMode::AltHold: break;
    case FlightMode::Loiter: m_loiter.begin(s); break;
    case FlightMode::Brake: m_brake.begin(s); break;
    case FlightMode::Land: m_landing.begin(s); break;
    case FlightMode::Rtl: m_return.begin(s); break;
    case FlightMode::Guided: m_guided.begin(s); break;
    case FlightMode::Auto: m_auto.begin(s); break;
    }
    return nullptr;
}

FlightDemand FlightModes::update(double dt, const Situation &s)
{
    switch (m_current) {
    case FlightMode::Stabilize: return stabilize(s);
    case FlightMode::AltHold: return holdAltitude(s);
    case FlightMode::Loiter: return m_loiter.update(s);
    case FlightMode::Brake: return m_brake.update(s);
    case FlightMode::Land: return m_landing.update(s);
    case FlightMode::Rtl: return m_return.update(dt, s);
    case FlightMode::Guided: return m_guided.update(dt, s);
    case FlightMode::Auto: return m_auto.update(dt, s);
    }
    return {};
}

std::optional<Vector3> FlightModes::place(const Situation &s) const
{
    switch (m_current) {
    case FlightMode::Guided: return Vector3{m_guided.place().north, m_guided.place().east, -m_guided.altitude()};
    case FlightMode::Rtl: return Vector3{m_return.place().north, m_return.place().east, s.estimate.position.z};
    case FlightMode::Auto: return m_auto.place();
    default: return std::nullopt;
    }
}

} // namespace skyseal::sim
