#include "core/sim/flight_requests.h"

namespace skyseal::sim {

Refusal FlightRequests::enterMode(FlightMode mode)
{
    if (const char *reason = m_flight.modes.enter(mode, m_flight.situation()))
        return "Mode change to " + std::string(name(mode)) + " failed: " + reason;
    m_flight.landDetector.resetIdle();
    m_flight.fence.beginRecovery(m_flight.time);
    return std::nullopt;
}

Refusal FlightRequests::takeOff(double height)
{
    if (m_flight.modes.current() != FlightMode::Guided)
        return "Takeoff: needs GUIDED";
    if (!m_arming.armed())
        return "Takeoff: not armed";
    if (!m_flight.landed())
        return "Takeoff: already flying";
    if (!(height >= 0.5) || height > 1000)
        return "Takeoff: bad altitude";
    m_flight.landDetector.resetIdle();
    m_flight.modes.guided().takeOff(m_flight.situation(), height);
    return std::nullopt;
}

Refusal FlightRequests::goTo(const Vector3 &place)
{
    if (m_flight.modes.current() != FlightMode::Guided)
        return "Goto: needs GUIDED";
    if (!place.finite() || place.length() > 1e5)
        return "Goto: too far away";
    if (!m_flight.fence.allows(place, m_flight.home.orOrigin()))
        return "Goto: outside the fence";
    m_flight.modes.guided().goTo(m_flight.situation(), place.x, place.y, -place.z);
    return std::nullopt;
}

Refusal FlightRequests::move(const Vector3 &velocity)
{
    if (m_flight.modes.current() != FlightMode::Guided)
        return "Velocity: needs GUIDED";
    if (!velocity.finite() || velocity.length() > 100)
        return "Velocity: out of range";
    m_flight.modes.guided().move(velocity, m_flight.parameter("GUID_TIMEOUT"));
    return std::nullopt;
}

Refusal FlightRequests::face(double heading, double rate)
{
    if (!std::isfinite(heading) || !std::isfinite(rate))
        return "Yaw: bad angle";
    const double limited = std::clamp(std::abs(rate), 0.0, 3.0);
    if (m_flight.modes.current() == FlightMode::Guided)
        m_flight.modes.guided().yaw().fix(heading, limited);
    else if (m_flight.modes.current() == FlightMode::Auto)
        m_flight.modes.mission().yaw().fix(heading, limited);
    else
        return "Yaw: needs GUIDED or AUTO";
    return std::nullopt;
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
    if (m_flight.modes.current() == FlightMode::Guided)
        set(m_flight.modes.guided());
    else if (m_flight.modes.current() == FlightMode::Auto)
        set(m_flight.modes.mission());
    else
        return "Speed: needs GUIDED or AUTO";
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

bool FlightRequests::setHome(const Vector3 &place)
{
    if (!place.finite() || !m_flight.estimate().positionOk || place.horizontal() > 5e4)
        return false;
    m_flight.home.place(place);
    return true;
}

} // namespace skyseal::sim
