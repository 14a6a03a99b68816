#include "core/sim/failsafes.h"

#include "core/base/number_text.h"

namespace skyseal::sim {

namespace {

constexpr std::uint64_t kWatch = 100'000;     // µs
constexpr std::uint64_t kFenceWatch = 40'000; // µs
constexpr double kCrash = 3;                  // m/s: a landing is softer
// FENCE_ACTION; the others return. This vehicle has no SMART_RTL.
constexpr int kReportOnly = 0, kAlwaysLand = 2, kBrakeOrLand = 4, kSmartReturnOrLand = 5;

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
    const ModeTable &table = m_flight.modes.table();
    action = table.available(action);
    if (table.row(action).needsPosition && !now.estimate.positionOk)
        action = table.available(FlightMode::Land);
    if (m_flight.modes.current() == FlightMode::Land) // already on its way down
        action = FlightMode::Land;
    m_flight.texts.say(Severity::Critical, std::string(cause) + " Failsafe - " + std::string(table.row(action).name));
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
        m_flight.texts.say(Severity::Critical, "SIM Hit ground at " + fixedText(impact, 1) + " m/s");
    if (impact > kCrash && m_arming.armed() && m_flight.settings.failsafes.crashCheck) {
        m_flight.texts.say(Severity::Emergency, "Crash: Disarming");
        m_arming.disarmNow();
    }
}

void Failsafes::watchPosition()
{
    const bool has = m_flight.estimate().positionOk;
    if (has == std::exchange(m_hadPosition, has))
        return;
    const bool speaksOfFilter = !m_flight.type.isPx4();
    if (has) {
        if (speaksOfFilter) {
            m_flight.texts.say(Severity::Info, "EKF3 IMU0 origin set");
            m_flight.texts.say(Severity::Info, "EKF3 IMU0 is using GPS");
        }
        if (!m_flight.home.position())
            m_flight.home.follow({m_flight.estimate().position.x, m_flight.estimate().position.y, 0});
        return;
    }
    if (speaksOfFilter)
        m_flight.texts.say(Severity::Warning, "EKF3 IMU0 stopped aiding");
    if (m_arming.armed() && m_flight.modes.row().needsPosition)
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
                       (critical ? "Battery 1 is critical " : "Battery 1 is low ") + fixedText(battery.voltage(), 2) + "V used "
                           + fixedText(battery.consumed(), 0) + " mAh");
    const FailsafeSettings &settings = m_flight.settings.failsafes;
    if (const auto &action = critical ? settings.criticalBattery : settings.lowBattery; action && m_arming.armed())
        trigger("Battery", *action);
}

void Failsafes::watchRadio()
{
    const FailsafeSettings &settings = m_flight.settings.failsafes;
    const bool low = settings.radioWatched && m_flight.pilot.channels()[2] < settings.radioThrottle;
    switch (m_flight.radioWatch.step(kWatch * 1e-6, m_flight.pilot.hasSignal(), low)) {
    case RadioWatch::Event::None: return;
    case RadioWatch::Event::Back: return clear("Radio");
    case RadioWatch::Event::Lost: break;
    }
    if (!m_arming.armed() || !settings.radio)
        return;
    const bool goesOn = (m_flight.modes.current() == FlightMode::Auto && settings.goesOnInAuto)
        || (m_flight.modes.isGuided() && settings.goesOnInGuided);
    if (goesOn)
        return m_flight.texts.say(Severity::Critical, "Radio Failsafe - Continuing");
    trigger("Radio", *settings.radio);
}

void Failsafes::watchEstimator()
{
    const FailsafeSettings &settings = m_flight.settings.failsafes;
    const Estimator &estimator = m_flight.physics.estimator();
    if (const bool glitching = estimator.glitching(); glitching != std::exchange(m_glitching, glitching))
        m_flight.texts.say(Severity::Critical, glitching ? "GPS Glitch or Compass error" : "Glitch cleared");
    if (!(settings.estimatorLimit > 0) || !settings.estimator)
        return; // only ArduCopter acts on its filter's variances
    switch (m_estimatorWatch.step(kWatch * 1e-6, m_arming.armed(), estimator.variances(), settings.estimatorLimit)) {
    case EstimatorWatch::Event::None: return;
    case EstimatorWatch::Event::Good: return clear("EKF");
    case EstimatorWatch::Event::Failed: break;
    }
    m_flight.texts.say(Severity::Critical, "EKF variance");
    if (m_flight.modes.row().needsPosition || settings.estimatorAlways)
        trigger("EKF", *settings.estimator);
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
    const ModeTable &table = m_flight.modes.table();
    if (m_flight.modes.enter(table.available(mode), now))
        m_flight.modes.enter(table.available(FlightMode::Land), now);
    fence.beginRecovery(m_flight.time);
}

} // namespace skyseal::sim
