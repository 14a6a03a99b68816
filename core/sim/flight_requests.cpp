#include "core/sim/flight_requests.h"

namespace skyseal::sim {

Refusal FlightRequests::enterMode(FlightMode mode)
{
    if (const char *reason = m_flight.modes.enter(mode, m_flight.situation())) {
        const ModeRow *row = m_flight.modes.table().find(mode);
        return "Mode change to " + std::string(row ? row->name : "an unknown mode") + " failed: " + reason;
    }
    m_flight.landDetector.resetIdle();
    m_flight.fence.beginRecovery(m_flight.time);
    return std::nullopt;
}

Refusal FlightRequests::takeOff(double height)
{
    if (!m_flight.settings.hovers)
        return "Takeoff: this vehicle takes off by its mode or mission";
    if (!m_flight.type.isPx4() && m_flight.modes.current() != FlightMode::Guided)
        return "Takeoff: needs GUIDED";
    if (!m_flight.type.isPx4() && !m_arming.armed())
        return "Takeoff: not armed";
    if (!m_flight.landed())
        return "Takeoff: already flying";
    if (!(height >= 0.5) || height > 1000)
        return "Takeoff: bad altitude";
    if (m_flight.type.isPx4()) { // it may be armed later
        if (Refusal reason = enterMode(FlightMode::TakeOff))
            return reason;
    }
    m_flight.landDetector.resetIdle();
    m_flight.modes.guided().takeOff(m_flight.situation(), height);
    return std::nullopt;
}

Refusal FlightRequests::goTo(const Vector3 &place)
{
    if (!m_flight.modes.isGuided())
        return "Goto: needs " + guidedName();
    if (!place.finite() || place.length() > 1e5)
        return "Goto: too far away";
    if (!m_flight.fence.allows(place, m_flight.home.orOrigin()))
        return "Goto: outside the fence";
    m_flight.modes.guided().goTo(m_flight.situation(), place.x, place.y, -place.z);
    return std::nullopt;
}

Refusal FlightRequests::move(const Vector3 &velocity)
{
    if (!m_flight.modes.isGuided())
        return "Velocity: needs " + guidedName();
    if (!velocity.finite() || velocity.length() > 100)
        return "Velocity: out of range";
    m_flight.modes.guided().move(velocity, m_flight.settings.guidedTimeout);
    return std::nullopt;
}

Refusal FlightRequests::face(double heading, double rate)
{
    if (!std::isfinite(heading) || !std::isfinite(rate))
        return "Yaw: bad angle";
    const double limited = std::clamp(std::abs(rate), 0.0, 3.0);
    if (m_flight.modes.isGuided())
        m_flight.modes.guided().yaw().fix(heading, limited);
    else if (m_flight.modes.current() == FlightMode::Auto)
        m_flight.modes.mission().yaw().fix(heading, limited);
    else
        return "Yaw: needs " + guidedName() + " or AUTO";
    return std::nullopt;
}

void FlightRequests::pointAt(const std::optional<Vector3> &place)
{
    const auto set = [&](AutoYaw &yaw) { place ? yaw.face(*place) : yaw.reset(m_flight.situation()); };
    if (m_flight.modes.isGuided())
        set(m_flight.modes.guided().yaw());
    else if (m_flight.modes.current() == FlightMode::Auto)
        set(m_flight.modes.mission().yaw());
}

Refusal FlightRequests::changeSpeed(SpeedKind kind, double speed)
{
    if (!(speed > 0) || speed > 30)
        return "Speed: out of range";
    const auto set = [&](auto &mode) {
        switch (kind) {
        case SpeedKind::Ground: mode.setSpeed(speed); break;
        case SpeedKind::Climb: mode.setClimb(speed); break;
        case SpeedKind::Descent: mode.setDescent(speed); break;
        }
    };
    if (m_flight.modes.isGuided())
        set(m_flight.modes.guided());
    else if (m_flight.modes.current() == FlightMode::Auto)
        set(m_flight.modes.mission());
    else
        return "Speed: needs " + guidedName() + " or AUTO";
    return std::nullopt;
}

Refusal FlightRequests::startMission()
{
    if (!m_arming.armed())
        return "Mission: not armed";
    if (Refusal reason = enterMode(FlightMode::Auto))
        return reason;
    m_flight.modes.mission().start();
    return std::nullopt;
}

std::string FlightRequests::guidedName() const
{
    return std::string(m_flight.modes.table().row(FlightMode::Guided).name);
}

bool FlightRequests::setHome(const Vector3 &place)
{
    if (!place.finite() || !m_flight.estimate().positionOk || place.horizontal() > 5e4)
        return false;
    m_flight.home.place(place);
    return true;
}

} // namespace skyseal::sim
