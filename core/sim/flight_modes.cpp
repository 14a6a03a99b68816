#include "core/sim/flight_modes.h"

namespace skyseal::sim {

const char *FlightModes::enter(FlightMode mode, const Situation &s)
{
    if (mode == m_current)
        return nullptr;
    const ModeRow *row = m_table.find(mode);
    if (!row)
        return "this vehicle has no such mode";
    if (row->needsPosition && !s.estimate.positionOk)
        return "requires position";
    if (mode == FlightMode::Auto) {
        if (const char *refusal = m_auto.refusal(s.landed))
            return refusal;
    }
    m_current = mode;
    switch (mode) {
    case FlightMode::Stabilize:
    case FlightMode::Manual:
    case FlightMode::FlyByWireA:
    case FlightMode::Steering:
    case FlightMode::AltHold: break;
    case FlightMode::Circle: m_hold.begin(s); break;
    case FlightMode::Loiter:
        m_loiter.begin(s);
        m_hold.begin(s);
        break;
    case FlightMode::Hold:
    case FlightMode::Brake: m_brake.begin(s); break;
    case FlightMode::Land: m_landing.begin(s); break;
    case FlightMode::Rtl: m_return.begin(s); break;
    case FlightMode::Guided:
    case FlightMode::Offboard: m_guided.begin(s); break;
    case FlightMode::TakeOff:
        m_guided.begin(s);
        m_guided.takeOff(s, s.settings.takeOffHeight);
        break;
    case FlightMode::Auto: m_auto.begin(s); break;
    }
    return nullptr;
}

FlightDemand FlightModes::update(double dt, const Situation &s)
{
    switch (m_current) {
    case FlightMode::Stabilize:
    case FlightMode::Manual:
    case FlightMode::FlyByWireA:
    case FlightMode::Steering: return stabilize(s);
    case FlightMode::AltHold: return holdAltitude(s);
    case FlightMode::Circle: return m_hold.update(s);
    case FlightMode::Loiter: return s.settings.hovers ? m_loiter.update(s) : m_hold.update(s);
    case FlightMode::Hold:
    case FlightMode::Brake: return m_brake.update(s);
    case FlightMode::Land: return m_landing.update(s);
    case FlightMode::Rtl: return m_return.update(dt, s);
    case FlightMode::Guided:
    case FlightMode::Offboard: return m_guided.update(dt, s);
    case FlightMode::TakeOff: {
        const FlightDemand demand = m_guided.update(dt, s);
        if (s.settings.hovers && !m_guided.takingOff())
            m_current = FlightMode::Guided; // PX4 holds after a take-off; an aeroplane circles in the same mode
        return demand;
    }
    case FlightMode::Auto: return m_auto.update(dt, s);
    }
    return {};
}

std::optional<Vector3> FlightModes::place(const Situation &s) const
{
    switch (m_current) {
    case FlightMode::TakeOff:
    case FlightMode::Offboard:
    case FlightMode::Guided: return Vector3{m_guided.place().north, m_guided.place().east, -m_guided.altitude()};
    case FlightMode::Circle: return m_hold.place();
    case FlightMode::Loiter: return s.settings.hovers ? std::nullopt : std::optional(m_hold.place());
    case FlightMode::Rtl: return Vector3{m_return.place().north, m_return.place().east, s.estimate.position.z};
    case FlightMode::Auto: return m_auto.place();
    default: return std::nullopt;
    }
}

} // namespace skyseal::sim
