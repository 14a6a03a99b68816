#include "core/sim/autopilot.h"

#include <cstdio>

namespace skyseal::sim {

namespace {

constexpr std::uint64_t kWatch = 100'000;     // µs
constexpr std::uint64_t kFenceWatch = 40'000; // µs
constexpr double kCrash = 3;                  // m/s: a landing is softer
// FENCE_ACTION; the others return. This vehicle has no SMART_RTL.
constexpr int kReportOnly = 0, kAlwaysLand = 2, kBrakeOrLand = 4, kSmartReturnOrLand = 5;
// ARMING_CHECK
constexpr int kAllChecks = 1, kBarometerCheck = 2, kCompassCheck = 4, kRcCheck = 64, kBatteryCheck = 256;
// FS_THR_ENABLE; the others return.
constexpr int kRadioIgnored = 0, kRadioLand = 3, kRadioSmartReturnOrLand = 5, kRadioBrakeOrLand = 7;
// FS_OPTIONS
constexpr int kContinueInAuto = 1, kContinueInGuided = 4;
// FS_EKF_ACTION
constexpr int kHoldAltitude = 2, kLandAlways = 3;

std::string format(const char *pattern, double a, double b = 0)
{
    char text[96];
    std::snprintf(text, sizeof text, pattern, a, b);
    return text;
}

} // namespace

Autopilot::Autopilot(const AutopilotConfig &config)
    : m_world(config.start), m_physics(config.seed, config.heading, config.firstFix), m_modes(m_world)
{
    m_physics.battery().replace(static_cast<double>(m_parameters.value("SIM_BATT_CAP_AH")) * 1000, 1);
}

Situation Autopilot::situation() const
{
    return {estimate(), m_settings, m_pilot.sticks(), m_home.value_or(Vector3{}), returnPoint(), landed()};
}

Vector3 Autopilot::returnPoint() const
{
    const Vector3 home = m_home.value_or(Vector3{});
    if (m_rallyPoints.items().empty())
        return home;
    return m_rallyPoints.bestFor(estimate().position, home, m_world,
                                 static_cast<double>(m_parameters.value("RALLY_LIMIT_KM")) * 1000,
                                 m_parameters.flag("RALLY_INCL_HOME"));
}

void Autopilot::step()
{
    constexpr double dt = kStep * 1e-6;
    m_time += kStep;
    if (m_settingsRevision != m_parameters.revision()) {
        m_settings = flightSettings(m_parameters, m_world);
        m_pilot.setFault(m_settings.faults.radio);
        m_settingsRevision = m_parameters.revision();
    }
    m_rotors.update(dt, m_armed, m_armed ? m_modes.update(dt, situation()) : FlightDemand{}, estimate(), m_settings);
    m_physics.step(dt, m_time, m_settings, m_rotors.commands(), m_armed);
    m_landDetector.step(dt, truth().onGround, m_rotors.idle(), m_armed);
    m_pilot.setFlying(!landed());
    watch();
}

void Autopilot::watch()
{
    if (!m_aligned && estimate().attitudeOk) {
        m_aligned = true;
        m_texts.say(Severity::Info, "EKF3 IMU0 tilt alignment complete");
    }
    watchGround();
    m_flown = m_armed && (m_flown || !landed());
    watchPosition();

    if (m_time % kWatch == 0) {
        watchBattery();
        watchRadio();
        watchEstimator();
    }
    if (m_time % kFenceWatch == 0)
        watchFence();
    const double patience = m_settings.disarmDelay;
    if (m_armed && landed() && ((m_flown && landsHere()) || (patience > 0 && m_landDetector.idleFor() >= patience)))
        disarmNow();
}

void Autopilot::watchBattery()
{
    switch (m_batteryWatch.step(kWatch * 1e-6, battery(), m_parameters)) {
    case BatteryLevel::Good: break;
    case BatteryLevel::Low:
    case BatteryLevel::Critical: {
        const bool critical = m_batteryWatch.level() == BatteryLevel::Critical;
        m_texts.say(Severity::Warning,
                    format(critical ? "Battery 1 is critical %.2fV used %.0f mAh" : "Battery 1 is low %.2fV used %.0f mAh",
                           battery().voltage(), battery().consumed()));
        const int action = m_parameters.integer(critical ? "BATT_FS_CRT_ACT" : "BATT_FS_LOW_ACT");
        if (action != 0 && m_armed)
            failsafe("Battery", action == 1 ? FlightMode::Land : FlightMode::Rtl);
        break;
    }
    }
}

void Autopilot::watchGround()
{
    const double impact = m_physics.takeImpact();
    if (impact > 1)
        m_texts.say(Severity::Critical, format("SIM Hit ground at %.1f m/s", impact));
    if (impact > kCrash && m_armed && m_parameters.flag("FS_CRASH_CHECK")) {
        m_texts.say(Severity::Emergency, "Crash: Disarming");
        disarmNow();
    }
}

void Autopilot::watchRadio()
{
    const int action = m_parameters.integer("FS_THR_ENABLE");
    const bool low = action != kRadioIgnored && m_pilot.channels()[2] < m_parameters.integer("FS_THR_VALUE");
    switch (m_radioWatch.step(kWatch * 1e-6, m_pilot.hasSignal(), low)) {
    case RadioWatch::Event::None: return;
    case RadioWatch::Event::Back: return clearFailsafe("Radio");
    case RadioWatch::Event::Lost: break;
    }
    const int options = m_parameters.integer("FS_OPTIONS");
    const FlightMode mode = m_modes.current();
    const bool goesOn = (mode == FlightMode::Auto && (options & kContinueInAuto))
        || (mode == FlightMode::Guided && (options & kContinueInGuided));
    if (!m_armed || action == kRadioIgnored)
        return;
    if (goesOn)
        return m_texts.say(Severity::Critical, "Radio Failsafe - Continuing");
    failsafe("Radio",
             action == kRadioLand || action == kRadioSmartReturnOrLand ? FlightMode::Land
                 : action == kRadioBrakeOrLand                         ? FlightMode::Brake
                                                                       : FlightMode::Rtl);
}

void Autopilot::watchEstimator()
{
    if (const bool glitching = estimator().glitching(); glitching != std::exchange(m_glitching, glitching))
        m_texts.say(Severity::Critical, glitching ? "GPS Glitch or Compass error" : "Glitch cleared");
    switch (m_estimatorWatch.step(kWatch * 1e-6, m_armed, estimator().variances(),
                                  static_cast<double>(m_parameters.value("FS_EKF_THRESH")))) {
    case EstimatorWatch::Event::None: return;
    case EstimatorWatch::Event::Good: return clearFailsafe("EKF");
    case EstimatorWatch::Event::Failed: break;
    }
    m_texts.say(Severity::Critical, "EKF variance");
    const int action = m_parameters.integer("FS_EKF_ACTION");
    if (needsPosition(m_modes.current()) || action == kLandAlways)
        failsafe("EKF", action == kHoldAltitude ? FlightMode::AltHold : FlightMode::Land);
}

void Autopilot::clearFailsafe(std::string_view cause)
{
    if (m_inFailsafe)
        m_texts.say(Severity::Notice, std::string(cause) + " Failsafe Cleared");
    m_inFailsafe = false;
}

void Autopilot::watchPosition()
{
    const bool has = estimate().positionOk;
    if (has == m_hadPosition)
        return;
    m_hadPosition = has;
    if (has) {
        m_texts.say(Severity::Info, "EKF3 IMU0 origin set");
        m_texts.say(Severity::Info, "EKF3 IMU0 is using GPS");
        if (!m_home)
            m_home = Vector3{estimate().position.x, estimate().position.y, 0};
        return;
    }
    m_texts.say(Severity::Warning, "EKF3 IMU0 stopped aiding");
    if (m_armed && needsPosition(m_modes.current()))
        failsafe("EKF", FlightMode::Land);
}

void Autopilot::watchFence()
{
    const Situation now = situation();
    const std::uint8_t fresh = m_fence.check(m_time, now);
    if (fresh == 0 || !m_armed)
        return;
    m_texts.say(Severity::Notice, "Fence Breached");
    const int action = m_parameters.integer("FENCE_ACTION");
    if (action == kReportOnly)
        return;
    const bool tooHigh = (m_fence.breaches() & mavlink::FENCE_TYPE_ALT_MAX) != 0;
    const bool stickDown = m_modes.current() == FlightMode::Stabilize && now.sticks.throttle <= 0;
    if (landed() || (stickDown && !tooHigh)) // too high, a pilot closes the throttle to come down
        return disarmNow();
    FlightMode mode = FlightMode::Rtl;
    if (action == kAlwaysLand || action == kSmartReturnOrLand || m_fence.breachDistance(fresh) > Fence::kGiveUp)
        mode = FlightMode::Land;
    else if (action == kBrakeOrLand)
        mode = FlightMode::Brake;
    if (m_modes.enter(mode, now))
        m_modes.enter(FlightMode::Land, now);
    m_fence.beginRecovery(m_time);
}

/// Whether the present mode ends with a landing, after which the rotors stop.
bool Autopilot::landsHere() const
{
    switch (m_modes.current()) {
    case FlightMode::Land:
    case FlightMode::Rtl: return true;
    case FlightMode::Auto: return m_modes.mission().finished();
    default: return false;
    }
}

void Autopilot::failsafe(std::string_view cause, FlightMode action)
{
    if (!m_armed)
        return;
    m_inFailsafe = true;
    if (landed()) {
        m_texts.say(Severity::Critical, std::string(cause) + " Failsafe - Disarming");
        disarmNow();
        return;
    }
    const Situation now = situation();
    if (needsPosition(action) && !now.estimate.positionOk)
        action = FlightMode::Land;
    if (m_modes.current() == FlightMode::Land) // already on its way down
        action = FlightMode::Land;
    m_texts.say(Severity::Critical, std::string(cause) + " Failsafe - " + std::string(name(action)));
    m_modes.enter(action, now);
    m_fence.beginRecovery(m_time);
}

// Requests: the conditions of each and the texts of its refusals.

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
    if (const char *reason = m_fence.preArm(estimate().positionOk))
        return reason;
    if (checked(kBarometerCheck) && faults().pressureFailed)
        return "Barometer not healthy";
    if (checked(kCompassCheck) && faults().compassFailed)
        return "Compass not healthy";
    if (checked(kRcCheck) && m_radioWatch.lost())
        return "Radio failsafe on";
    if (checked(kBatteryCheck)) {
        if (m_batteryWatch.level() != BatteryLevel::Good)
            return "Battery 1 low voltage failsafe";
        if (battery().voltage() < static_cast<double>(m_parameters.value("BATT_ARM_VOLT")))
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
    m_fence.beginRecovery(m_time);
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
    if (!m_fence.allows(place, situation().home))
        return "Goto: outside the fence";
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
    if (Refusal reason = enterMode(FlightMode::Auto))
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
