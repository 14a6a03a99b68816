#include "core/sim/arming.h"

namespace skyseal::sim {

namespace {

// ARMING_CHECK
constexpr int kAllChecks = 1, kBarometerCheck = 2, kCompassCheck = 4, kRcCheck = 64, kBatteryCheck = 256;

} // namespace

Refusal Arming::preArm() const
{
    const int checks = m_flight.parameters.integer("ARMING_CHECK");
    const auto checked = [&](int bit) { return (checks & (kAllChecks | bit)) != 0; };
    const ModeRow &mode = m_flight.modes.row();

    if (!m_flight.estimate().attitudeOk)
        return "AHRS: waiting for tilt alignment";
    if (mode.needsPosition) { // cannot be switched off: the mode could not be flown
        if (!m_flight.physics.gps().fixed)
            return "GPS 1: Bad fix";
        if (!m_flight.estimate().positionOk)
            return "Need Position Estimate";
    }
    if (const char *reason = m_flight.fence.preArm(m_flight.estimate().positionOk))
        return reason;
    if (checked(kBarometerCheck) && m_flight.settings.faults.pressureFailed)
        return "Barometer not healthy";
    if (checked(kCompassCheck) && m_flight.settings.faults.compassFailed)
        return "Compass not healthy";
    if (checked(kRcCheck) && m_flight.radioWatch.lost())
        return "Radio failsafe on";
    if (checked(kBatteryCheck)) {
        if (m_flight.batteryWatch.level() != BatteryLevel::Good)
            return "Battery 1 low voltage failsafe";
        if (m_flight.physics.battery().voltage() < m_flight.parameter("BATT_ARM_VOLT"))
            return "Battery 1 below minimum arming voltage";
    }
    if (checked(kRcCheck) && mode.manualThrottle && m_flight.pilot.sticks().throttle > 0.1)
        return "Throttle too high";
    return std::nullopt;
}

bool Arming::modeAllowsArming() const
{
    constexpr int kArmInAuto = 1; // AUTO_OPTIONS
    const ModeRow &mode = m_flight.modes.row();
    return mode.allowsArming || (mode.mode == FlightMode::Auto && (m_flight.parameters.integer("AUTO_OPTIONS") & kArmInAuto));
}

Refusal Arming::arm(bool force)
{
    if (m_armed)
        return std::nullopt;
    if (!force) {
        const std::string prefix = m_flight.type.isPx4() ? "Arming denied: " : "PreArm: ";
        if (!modeAllowsArming())
            return m_flight.type.isPx4() ? "Arming denied: switch to another mode first"
                                         : "Arm: " + std::string(m_flight.modes.row().name) + " mode not armable";
        if (const Refusal reason = preArm())
            return prefix + *reason;
        if (m_flight.settings.flies && !m_flight.landed())
            return m_flight.type.isPx4() ? prefix + "not landed" : "Arm: not landed";
    }
    m_armed = true;
    m_flown = false;
    ++m_count;
    m_flight.landDetector.resetIdle();
    if (m_flight.estimate().positionOk && (m_flight.landed() || !m_flight.settings.flies))
        m_flight.home.follow(m_flight.estimate().position);
    m_flight.texts.say(Severity::Info,
                       m_flight.type.isPx4() ? "Armed by external command"
                                             : (m_flight.type.hovers() ? "Arming motors" : "Throttle armed"));
    return std::nullopt;
}

Refusal Arming::disarm(bool force)
{
    if (!m_armed)
        return std::nullopt;
    const bool stickDown = m_flight.modes.current() == FlightMode::Stabilize && m_flight.pilot.sticks().throttle <= 0.0;
    if (!force && m_flight.settings.flies && !m_flight.landed() && !stickDown)
        return m_flight.type.isPx4() ? "Disarming denied: not landed" : "Disarm: not landed";
    disarmNow();
    return std::nullopt;
}

void Arming::disarmNow()
{
    m_armed = false;
    m_flight.texts.say(Severity::Info,
                       m_flight.type.isPx4()        ? "Disarmed"
                           : m_flight.type.hovers() ? "Disarming motors"
                                                    : "Throttle disarmed");
}

void Arming::step()
{
    m_flown = m_armed && (m_flown || !m_flight.landed());
    if (!m_armed || !m_flight.landed())
        return;
    const double patience = m_flight.settings.disarmDelay;
    const double afterFlight = m_flight.settings.disarmAfterFlight;
    if (m_flown && (afterFlight > 0 ? m_flight.landDetector.idleFor() >= afterFlight : landsHere()))
        disarmNow();
    else if (patience > 0 && m_flight.landDetector.idleFor() >= patience)
        disarmNow();
}

/// Whether the present mode ends with a landing, after which the rotors stop.
bool Arming::landsHere() const
{
    switch (m_flight.modes.current()) {
    case FlightMode::Land:
    case FlightMode::Rtl: return true;
    case FlightMode::Auto: return m_flight.modes.mission().finished();
    default: return false;
    }
}

} // namespace skyseal::sim
