// Requests of an operator to the autopilot: the conditions of each and the texts of its refusals.
#include "core/sim/autopilot.h"

namespace skyseal::sim {

namespace {

constexpr int kAllChecks = 1, kBatteryCheck = 256, kRcCheck = 64;

} // namespace

Autopilot::Refusal Autopilot::preArm() const
{
    const int checks = m_parameters.integer("ARMING_CHECK");
    const auto checked = [&](int bit) { return (checks & (kAllChecks | bit)) != 0; };

    if (!estimate().attitudeOk)
        return "AHRS: waiting for tilt alignment";
    if (needsPosition(m_modes.current())) { // cannot be switched off: the mode could not be flown
        if (!gps().fixed)
            return "GPS 1: Bad fix";
        if (!estimate().positionOk)
            return "Need Position Estimate";
    }
    if (checked(kBatteryCheck)) {
        if (m_batteryWatch.level() != BatteryLevel::Good)
            return "Battery 1 low voltage failsafe";
        if (m_battery.voltage() < static_cast<double>(m_parameters.value("BATT_ARM_VOLT")))
            return "Battery 1 below minimum arming voltage";
    }
    if (checked(kRcCheck) && hasManualThrottle(m_modes.current()) && m_pilot.sticks().throttle > 0.1)
        return "Throttle too high";
    return std::nullopt;
}

Autopilot::Refusal Autopilot::arm(bool force)
{
    if (m_armed)
        return std::nullopt;
    if (!force) {
        if (!allowsArming(m_modes.current(), m_parameters.integer("AUTO_OPTIONS")))
            return "Arm: " + std::string(name(m_modes.current())) + " mode not armable";
        if (const Refusal reason = preArm())
            return "PreArm: " + *reason;
        if (!landed())
            return "Arm: not landed";
    }
    m_armed = true;
    m_flown = false;
    m_inFailsafe = false;
    m_landDetector.resetIdle();
    if (estimate().positionOk && landed() && !m_homeLocked)
        m_home = Vector3{estimate().position.x, estimate().position.y, estimate().position.z};
    m_texts.say(Severity::Info, "Arming motors");
    return std::nullopt;
}

Autopilot::Refusal Autopilot::disarm(bool force)
{
    if (!m_armed)
        return std::nullopt;
    const bool stickDown = m_modes.current() == FlightMode::Stabilize && m_pilot.sticks().throttle <= 0.0;
    if (!force && !landed() && !stickDown)
        return "Disarm: not landed";
    disarmNow();
    return std::nullopt;
}

void Autopilot::disarmNow()
{
    m_armed = false;
    m_inFailsafe = false;
    m_texts.say(Severity::Info, "Disarming motors");
}

Autopilot::Refusal Autopilot::enterMode(FlightMode mode)
{
    if (const char *reason = m_modes.enter(mode, situation()))
        return "Mode change to " + std::string(name(mode)) + " failed: " + reason;
    m_landDetector.resetIdle();
    return std::nullopt;
}

Autopilot::Refusal Autopilot::takeOff(double height)
{
    if (m_modes.current() != FlightMode::Guided)
        return "Takeoff: needs GUIDED";
    if (!m_armed)
        return "Takeoff: not armed";
    if (!landed())
        return "Takeoff: already flying";
    if (!(height >= 0.5) || height > 1000)
        return "Takeoff: bad altitude";
    m_landDetector.resetIdle();
    m_modes.guided().takeOff(situation(), height);
    return std::nullopt;
}

Autopilot::Refusal Autopilot::goTo(const Vector3 &place)
{
    if (m_modes.current() != FlightMode::Guided)
        return "Goto: needs GUIDED";
    if (!place.finite() || place.length() > 1e5)
        return "Goto: too far away";
    m_modes.guided().goTo(situation(), place.x, place.y, -place.z);
    return std::nullopt;
}

Autopilot::Refusal Autopilot::move(const Vector3 &velocity)
{
    if (m_modes.current() != FlightMode::Guided)
        return "Velocity: needs GUIDED";
    if (!velocity.finite() || velocity.length() > 100)
        return "Velocity: out of range";
    m_modes.guided().move(velocity, static_cast<double>(m_parameters.value("GUID_TIMEOUT")));
    return std::nullopt;
}

Autopilot::Refusal Autopilot::face(double heading, double rate)
{
    if (!std::isfinite(heading) || !std::isfinite(rate))
        return "Yaw: bad angle";
    if (m_modes.current() == FlightMode::Guided)
        m_modes.guided().yaw().fix(heading, std::clamp(std::abs(rate), 0.0, 3.0));
    else if (m_modes.current() == FlightMode::Auto)
        m_modes.mission().yaw().fix(heading, std::clamp(std::abs(rate), 0.0, 3.0));
    else
        return "Yaw: needs GUIDED or AUTO";
    return std::nullopt;
}

Autopilot::Refusal Autopilot::changeSpeed(SpeedKind kind, double speed)
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
    if (m_modes.current() == FlightMode::Guided)
        set(m_modes.guided());
    else if (m_modes.current() == FlightMode::Auto)
        set(m_modes.mission());
    else
        return "Speed: needs GUIDED or AUTO";
    return std::nullopt;
}

Autopilot::Refusal Autopilot::startMission()
{
    if (!m_armed)
        return "Mission: not armed";
    if (const Refusal reason = enterMode(FlightMode::Auto))
        return reason;
    m_modes.mission().start();
    return std::nullopt;
}

bool Autopilot::setHome(const Vector3 &place)
{
    if (!place.finite() || !estimate().positionOk || place.horizontal() > 5e4)
        return false;
    m_home = place;
    m_homeLocked = true;
    return true;
}

} // namespace skyseal::sim
