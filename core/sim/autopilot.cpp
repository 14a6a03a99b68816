#include "core/sim/autopilot.h"

#include <cstdio>

namespace skyseal::sim {

namespace {

constexpr double kIdleCommand = 0.05;
constexpr std::uint64_t kBatteryWatch = 100'000; // µs

BodyState standing(double heading)
{
    BodyState state;
    state.attitude = Attitude::fromEuler({0, 0, wrapPi(radians(heading))});
    return state;
}

std::string format(const char *pattern, double a, double b = 0)
{
    char text[96];
    std::snprintf(text, sizeof text, pattern, a, b);
    return text;
}

} // namespace

Autopilot::Autopilot(const AutopilotConfig &config)
    : m_world(config.start), m_wind(config.seed), m_airframe(AirframeModel{}, standing(config.heading)),
      m_gps(config.seed, config.firstFix), m_estimator(config.seed), m_modes(m_world)
{
    m_battery.replace(static_cast<double>(m_parameters.value("SIM_BATT_CAP_AH")) * 1000, 1);
}

Situation Autopilot::situation() const
{
    return {estimate(), m_settings, m_pilot.sticks(), m_home.value_or(Vector3{}), landed()};
}

void Autopilot::step()
{
    constexpr double dt = kStep * 1e-6;
    m_time += kStep;
    if (m_settingsRevision != m_parameters.revision()) {
        m_settings = flightSettings(m_parameters);
        m_settingsRevision = m_parameters.revision();
    }
    control(dt);
    m_wind.step(dt, m_settings.windSpeed, m_settings.windFrom);
    m_airframe.step(dt, m_commands, m_battery.supply(), m_wind.velocity(), m_wind.torque());
    const Rotors &rotors = truth().rotors;
    m_battery.step(dt, (rotors[0] + rotors[1] + rotors[2] + rotors[3]) / 4, m_armed);
    m_gps.step(dt, m_time, truth(), m_settings.gpsDisabled);
    m_estimator.step(dt, truth(), gps());
    m_landDetector.step(dt, truth().onGround, m_idle, m_armed);
    m_pilot.setFlying(!landed());
    watch();
}

void Autopilot::control(double dt)
{
    FlightDemand demand;
    if (m_armed)
        demand = m_modes.update(dt, situation());
    m_idle = !m_armed || demand.idle;
    if (m_idle) {
        m_commands.fill(m_armed ? kIdleCommand : 0);
        m_thrust = 0;
        m_position.reset(estimate());
        m_attitude.reset({0, 0, estimate().attitude.euler().yaw});
        return;
    }
    const AttitudeDemand attitude = m_position.update(dt, demand, estimate(), m_settings);
    m_thrust = std::clamp(attitude.thrust, 0.0, 1.0);
    m_commands = m_attitude.update(dt, attitude, estimate().attitude, estimate().rates, m_settings);
}

void Autopilot::watch()
{
    if (!m_aligned && estimate().attitudeOk) {
        m_aligned = true;
        m_texts.say(Severity::Info, "EKF3 IMU0 tilt alignment complete");
    }
    if (const double impact = m_airframe.takeImpact(); impact > 1)
        m_texts.say(Severity::Critical, format("SIM Hit ground at %.1f m/s", impact));
    m_flown = m_armed && (m_flown || !landed());
    watchPosition();

    if (m_time % kBatteryWatch == 0)
        watchBattery();
    const double patience = m_settings.disarmDelay;
    if (m_armed && landed() && ((m_flown && landsHere()) || (patience > 0 && m_landDetector.idleFor() >= patience)))
        disarmNow();
}

void Autopilot::watchBattery()
{
    switch (m_batteryWatch.step(kBatteryWatch * 1e-6, m_battery, m_parameters)) {
    case BatteryLevel::Good: break;
    case BatteryLevel::Low:
    case BatteryLevel::Critical: {
        const bool critical = m_batteryWatch.level() == BatteryLevel::Critical;
        m_texts.say(Severity::Warning,
                    format(critical ? "Battery 1 is critical %.2fV used %.0f mAh" : "Battery 1 is low %.2fV used %.0f mAh",
                           m_battery.voltage(), m_battery.consumed()));
        const int action = m_parameters.integer(critical ? "BATT_FS_CRT_ACT" : "BATT_FS_LOW_ACT");
        if (action != 0 && m_armed)
            failsafe("Battery", action == 1 ? FlightMode::Land : FlightMode::Rtl);
        break;
    }
    }
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
}

} // namespace skyseal::sim
