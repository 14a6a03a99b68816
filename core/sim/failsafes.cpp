#include "core/sim/failsafes.h"

#include <cstdio>

namespace skyseal::sim {

namespace {

constexpr std::uint64_t kWatch = 100'000;     // µs
constexpr std::uint64_t kFenceWatch = 40'000; // µs
constexpr double kCrash = 3;                  // m/s: a landing is softer
// FENCE_ACTION; the others return. This vehicle has no SMART_RTL.
constexpr int kReportOnly = 0, kAlwaysLand = 2, kBrakeOrLand = 4, kSmartReturnOrLand = 5;
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

void Failsafes::step()
{
    watchGround();
    watchPosition();
    if (m_flight.time % kWatch == 0) {
        watchBattery();
        watchRadio();
        watchEstimator();
    }
    if (m_flight.time % kFenceWatch == 0)
        watchFence();
}

void Failsafes::trigger(std::string_view cause, FlightMode action)
{
    if (!m_arming.armed())
        return;
    m_activeIn = m_arming.count();
    if (m_flight.landed()) {
        m_flight.texts.say(Severity::Critical, std::string(cause) + " Failsafe - Disarming");
        m_arming.disarmNow();
        return;
    }
    const Situation now = m_flight.situation();
    if (needsPosition(action) && !now.estimate.positionOk)
        action = FlightMode::Land;
    if (m_flight.modes.current() == FlightMode::Land) // already on its way down
        action = FlightMode::Land;
    m_flight.texts.say(Severity::Critical, std::string(cause) + " Failsafe - " + std::string(name(action)));
    m_flight.modes.enter(action, now);
    m_flight.fence.beginRecovery(m_flight.time);
}

void Failsafes::clear(std::string_view cause)
{
    if (active())
        m_flight.texts.say(Severity::Notice, std::string(cause) + " Failsafe Cleared");
    m_activeIn = 0;
}

void Failsafes::watchGround()
{
    const double impact = m_flight.physics.takeImpact();
    if (impact > 1)
        m_flight.texts.say(Severity::Critical, format("SIM Hit ground at %.1f m/s", impact));
    if (impact > kCrash && m_arming.armed() && m_flight.parameters.flag("FS_CRASH_CHECK")) {
        m_flight.texts.say(Severity::Emergency, "Crash: Disarming");
        m_arming.disarmNow();
    }
}

void Failsafes::watchPosition()
{
    const bool has = m_flight.estimate().positionOk;
    if (has == std::exchange(m_hadPosition, has))
        return;
    if (has) {
        m_flight.texts.say(Severity::Info, "EKF3 IMU0 origin set");
        m_flight.texts.say(Severity::Info, "EKF3 IMU0 is using GPS");
        if (!m_flight.home.position())
            m_flight.home.follow({m_flight.estimate().position.x, m_flight.estimate().position.y, 0});
        return;
    }
    m_flight.texts.say(Severity::Warning, "EKF3 IMU0 stopped aiding");
    if (m_arming.armed() && needsPosition(m_flight.modes.current()))
        trigger("EKF", FlightMode::Land);
}

void Failsafes::watchBattery()
{
    const Battery &battery = m_flight.physics.battery();
    const BatteryLevel reached = m_flight.batteryWatch.step(kWatch * 1e-6, battery, m_flight.parameters);
    if (reached == BatteryLevel::Good)
        return;
    const bool critical = reached == BatteryLevel::Critical;
    m_flight.texts.say(Severity::Warning,
                       format(critical ? "Battery 1 is critical %.2fV used %.0f mAh" : "Battery 1 is low %.2fV used %.0f mAh",
                              battery.voltage(), battery.consumed()));
    const int action = m_flight.parameters.integer(critical ? "BATT_FS_CRT_ACT" : "BATT_FS_LOW_ACT");
    if (action != 0 && m_arming.armed())
        trigger("Battery", action == 1 ? FlightMode::Land : FlightMode::Rtl);
}

void Failsafes::watchRadio()
{
    const int action = m_flight.parameters.integer("FS_THR_ENABLE");
    const bool low = action != kRadioIgnored && m_flight.pilot.channels()[2] < m_flight.parameters.integer("FS_THR_VALUE");
    switch (m_flight.radioWatch.step(kWatch * 1e-6, m_flight.pilot.hasSignal(), low)) {
    case RadioWatch::Event::None: return;
    case RadioWatch::Event::Back: return clear("Radio");
    case RadioWatch::Event::Lost: break;
    }
    const int options = m_flight.parameters.integer("FS_OPTIONS");
    const FlightMode mode = m_flight.modes.current();
    const bool goesOn = (mode == FlightMode::Auto && (options & kContinueInAuto))
        || (mode == FlightMode::Guided && (options & kContinueInGuided));
    if (!m_arming.armed() || action == kRadioIgnored)
        return;
    if (goesOn)
        return m_flight.texts.say(Severity::Critical, "Radio Failsafe - Continuing");
    trigger("Radio",
            action == kRadioLand || action == kRadioSmartReturnOrLand ? FlightMode::Land
                : action == kRadioBrakeOrLand                         ? FlightMode::Brake
                                                                      : FlightMode::Rtl);
}

void Failsafes::watchEstimator()
{
    const Estimator &estimator = m_flight.physics.estimator();
    if (const bool glitching = estimator.glitching(); glitching != std::exchange(m_glitching, glitching))
        m_flight.texts.say(Severity::Critical, glitching ? "GPS Glitch or Compass error" : "Glitch cleared");
    switch (
        m_estimatorWatch.step(kWatch * 1e-6, m_arming.armed(), estimator.variances(), m_flight.parameter("FS_EKF_THRESH"))) {
    case EstimatorWatch::Event::None: return;
    case EstimatorWatch::Event::Good: return clear("EKF");
    case EstimatorWatch::Event::Failed: break;
    }
    m_flight.texts.say(Severity::Critical, "EKF variance");
    const int action = m_flight.parameters.integer("FS_EKF_ACTION");
    if (needsPosition(m_flight.modes.current()) || action == kLandAlways)
        trigger("EKF", action == kHoldAltitude ? FlightMode::AltHold : FlightMode::Land);
}

void Failsafes::watchFence()
{
    const Situation now = m_flight.situation();
    Fence &fence = m_flight.fence;
    const std::uint8_t fresh = fence.check(m_flight.time, now);
    if (fresh == 0 || !m_arming.armed())
        return;
    m_flight.texts.say(Severity::Notice, "Fence Breached");
    const int action = m_flight.parameters.integer("FENCE_ACTION");
    if (action == kReportOnly)
        return;
    const bool tooHigh = (fence.breaches() & mavlink::FENCE_TYPE_ALT_MAX) != 0;
    const bool stickDown = m_flight.modes.current() == FlightMode::Stabilize && now.sticks.throttle <= 0;
    if (now.landed || (stickDown && !tooHigh)) // too high, a pilot closes the throttle to come down
        return m_arming.disarmNow();
    FlightMode mode = FlightMode::Rtl;
    if (action == kAlwaysLand || action == kSmartReturnOrLand || fence.breachDistance(fresh) > Fence::kGiveUp)
        mode = FlightMode::Land;
    else if (action == kBrakeOrLand)
        mode = FlightMode::Brake;
    if (m_flight.modes.enter(mode, now))
        m_flight.modes.enter(FlightMode::Land, now);
    fence.beginRecovery(m_flight.time);
}

} // namespace skyseal::sim
