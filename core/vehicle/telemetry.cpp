#include "core/vehicle/telemetry.h"

#include "core/vehicle/known_value.h"
#include "core/vehicle/message_io.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace skyseal::vehicle {

/// Input and output of the readers.
struct TelemetryContext
{
    VehicleState &state;
    Telemetry &memory;
    TelemetryUpdate &update;
};

namespace {

constexpr std::uint16_t kNo16 = 65535; // "not known" of many 16-bit fields

/// Autopilots send 0°, 0° until they have a position.
bool isPlace(std::int32_t latitude, std::int32_t longitude)
{
    return (latitude != 0 || longitude != 0) && std::abs(std::int64_t{latitude}) <= 900000000
        && std::abs(std::int64_t{longitude}) <= 1800000000;
}

/// Limits of what a vehicle can mean. Greater values, infinities and NaN are errors or attacks, and count as not known: nothing
/// that draws or converts the state needs to expect them.
constexpr double kGreatestAngle = 1e3;     // radians
constexpr double kGreatestSpeed = 1e5;     // metres or radians a second
constexpr double kGreatestVibration = 1e5; // m/s²

/// The flags of EKF_STATUS_REPORT and ESTIMATOR_STATUS, which agree in these bits.
bool isEstimateGood(std::uint16_t flags)
{
    using namespace mavlink;
    constexpr std::uint16_t kNeeded = EKF_ATTITUDE | EKF_VELOCITY_HORIZ | EKF_POS_HORIZ_ABS | EKF_POS_VERT_ABS;
    constexpr std::uint16_t kForbidden = EKF_CONST_POS_MODE | EKF_UNINITIALIZED | EKF_GPS_GLITCHING;
    return (flags & kNeeded) == kNeeded && (flags & kForbidden) == 0;
}

} // namespace

struct TelemetryReaders
{
    using Context = TelemetryContext;

    static void read(const mavlink::Attitude &m, Context &c)
    {
        c.state.roll = within(m.roll, kGreatestAngle);
        c.state.pitch = within(m.pitch, kGreatestAngle);
        c.state.yaw = within(m.yaw, kGreatestAngle);
        c.state.rollSpeed = within(m.rollspeed, kGreatestSpeed);
        c.state.pitchSpeed = within(m.pitchspeed, kGreatestSpeed);
        c.state.yawSpeed = within(m.yawspeed, kGreatestSpeed);
    }

    static void read(const mavlink::GlobalPositionInt &m, Context &c)
    {
        if (isPlace(m.lat, m.lon)) {
            c.state.position = {m.lat * 1e-7, m.lon * 1e-7, m.alt * 1e-3};
            c.memory.m_hasGlobalPosition = true;
        }
        constexpr std::uint32_t kLate = 3000; // milliseconds that a frame may be delayed
        c.update.restarted = m.time_boot_ms < c.memory.m_sinceBoot && c.memory.m_sinceBoot - m.time_boot_ms > kLate;
        if (c.update.restarted || m.time_boot_ms > c.memory.m_sinceBoot)
            c.memory.m_sinceBoot = m.time_boot_ms;
        c.state.altitudeRelative = m.relative_alt * 1e-3;
        c.state.groundSpeed = std::hypot(m.vx * 0.01, m.vy * 0.01);
        c.state.climb = m.vz * -0.01;
        if (m.hdg != kNo16)
            c.state.heading = m.hdg % 36000 * 0.01;
        c.update.positionChanged = true;
    }

    static void read(const mavlink::GpsRawInt &m, Context &c)
    {
        c.state.gpsFix = m.fix_type;
        c.state.satellites = m.satellites_visible == 255 ? -1 : m.satellites_visible;
        c.state.hdop = m.eph == kNo16 ? kUnknown : m.eph * 0.01;
        if (c.memory.m_hasGlobalPosition || m.fix_type < mavlink::GPS_FIX_TYPE_2D_FIX || !isPlace(m.lat, m.lon))
            return;
        c.state.position = {m.lat * 1e-7, m.lon * 1e-7, m.alt * 1e-3};
        if (m.vel != kNo16)
            c.state.groundSpeed = m.vel * 0.01;
        c.update.positionChanged = true;
    }

    static void read(const mavlink::VfrHud &m, Context &c)
    {
        c.state.airSpeed = within(m.airspeed, kGreatestSpeed);
        c.state.groundSpeed = within(m.groundspeed, kGreatestSpeed);
        c.state.climb = within(m.climb, kGreatestSpeed);
        c.state.throttle = m.throttle;
        if (m.heading >= 0)
            c.state.heading = m.heading % 360;
    }

    static void read(const mavlink::SysStatus &m, Context &c)
    {
        // ArduPilot always has the bit among those present, and enabled and healthy only if any check is enabled.
        c.state.preArmOk.reset();
        if (m.onboard_control_sensors_present & m.onboard_control_sensors_enabled & mavlink::MAV_SYS_STATUS_PREARM_CHECK)
            c.state.preArmOk = (m.onboard_control_sensors_health & mavlink::MAV_SYS_STATUS_PREARM_CHECK) != 0;
        c.state.cpuLoad = m.load * 0.1;
        if (m.voltage_battery != kNo16)
            c.state.batteryVoltage = m.voltage_battery * 1e-3;
        if (m.current_battery >= 0)
            c.state.batteryCurrent = m.current_battery * 0.01;
        if (m.battery_remaining >= 0)
            c.state.batteryPercent = m.battery_remaining;
    }

    static void read(const mavlink::BatteryStatus &m, Context &c)
    {
        if (m.id != 0)
            return; // the first one is the main one
        double millivolts = 0;
        for (const std::uint16_t cell : m.voltages) {
            if (cell != kNo16)
                millivolts += cell;
        }
        if (millivolts > 0)
            c.state.batteryVoltage = millivolts * 1e-3;
        if (m.current_battery >= 0)
            c.state.batteryCurrent = m.current_battery * 0.01;
        if (m.battery_remaining >= 0)
            c.state.batteryPercent = m.battery_remaining;
    }

    static void read(const mavlink::EkfStatusReport &m, Context &c)
    {
        c.state.ekfFlags = m.flags;
        const bool consistent = std::max({m.velocity_variance, m.pos_horiz_variance, m.pos_vert_variance, m.compass_variance})
            < 1;
        c.state.ekfOk = isEstimateGood(m.flags) && consistent;
    }

    static void read(const mavlink::EstimatorStatus &m, Context &c)
    {
        c.state.ekfFlags = m.flags;
        c.state.ekfOk = isEstimateGood(static_cast<std::uint16_t>(m.flags & ~kEstimatorOnly));
    }

    static void read(const mavlink::Vibration &m, Context &c)
    {
        c.state.vibration = within(std::max({m.vibration_x, m.vibration_y, m.vibration_z}), kGreatestVibration);
    }

    static void read(const mavlink::MissionCurrent &m, Context &c) { c.state.missionCurrent = m.seq == kNo16 ? -1 : m.seq; }

    static void read(const mavlink::HomePosition &m, Context &c)
    {
        if (isPlace(m.latitude, m.longitude))
            c.update.home = Position{m.latitude * 1e-7, m.longitude * 1e-7, m.altitude * 1e-3};
    }

    static void read(const mavlink::ExtendedSysState &m, Context &c)
    {
        c.update.landed = m.landed_state <= mavlink::MAV_LANDED_STATE_LANDING ? static_cast<LandedState>(m.landed_state)
                                                                              : LandedState::Undefined;
    }

    /// The whole state of a vehicle behind a satellite modem.
    static void read(const mavlink::HighLatency2 &m, Context &c)
    {
        if (isPlace(m.latitude, m.longitude)) {
            c.state.position = {m.latitude * 1e-7, m.longitude * 1e-7, static_cast<double>(m.altitude)};
            if (!std::isnan(c.state.home.altitude))
                c.state.altitudeRelative = m.altitude - c.state.home.altitude;
            c.update.positionChanged = true;
        }
        c.state.heading = m.heading * 2 % 360; // degrees / 2
        c.state.yaw = std::remainder(m.heading * 2 * std::numbers::pi / 180, 2 * std::numbers::pi);
        c.state.throttle = m.throttle;
        c.state.airSpeed = m.airspeed * 0.2; // m/s × 5
        c.state.groundSpeed = m.groundspeed * 0.2;
        c.state.climb = m.climb_rate * 0.1;
        if (m.battery >= 0)
            c.state.batteryPercent = m.battery;
        c.state.missionCurrent = m.wp_num;
    }

    /// The older message of the same purpose.
    static void read(const mavlink::HighLatency &m, Context &c)
    {
        if (isPlace(m.latitude, m.longitude)) {
            c.state.position = {m.latitude * 1e-7, m.longitude * 1e-7, static_cast<double>(m.altitude_amsl)};
            if (!std::isnan(c.state.home.altitude))
                c.state.altitudeRelative = m.altitude_amsl - c.state.home.altitude;
            c.update.positionChanged = true;
        }
        c.state.roll = m.roll * 0.01 * std::numbers::pi / 180; // centidegrees
        c.state.pitch = m.pitch * 0.01 * std::numbers::pi / 180;
        c.state.yaw = std::remainder(m.heading * 0.01 * std::numbers::pi / 180, 2 * std::numbers::pi);
        c.state.heading = m.heading % 36000 * 0.01;
        c.state.throttle = m.throttle;
        c.state.airSpeed = m.airspeed;
        c.state.groundSpeed = m.groundspeed;
        c.state.climb = m.climb_rate;
        c.state.gpsFix = m.gps_fix_type;
        c.state.satellites = m.gps_nsat == 255 ? -1 : m.gps_nsat;
        c.state.batteryPercent = m.battery_remaining <= 100 ? double(m.battery_remaining) : kUnknown;
        c.state.missionCurrent = m.wp_num;
        c.update.landed = m.landed_state <= mavlink::MAV_LANDED_STATE_LANDING ? static_cast<LandedState>(m.landed_state)
                                                                              : LandedState::Undefined;
    }

private:
    /// ESTIMATOR_STATUS calls 1024 "GPS glitch" and 2048 "accelerometer error"; both speak against it, 32768 means nothing.
    static constexpr int kEstimatorOnly = 32768;
};

namespace {

using Reader = void (*)(const mavlink::Frame &, TelemetryContext &);

template<typename Message> void readAs(const mavlink::Frame &frame, TelemetryContext &context)
{
    TelemetryReaders::read(unpack<Message>(frame), context);
}

struct Entry
{
    std::uint32_t id;
    Reader read;
};

template<typename... Messages> constexpr auto makeTable()
{
    std::array<Entry, sizeof...(Messages)> table{Entry{Messages::kId, readAs<Messages>}...};
    std::sort(table.begin(), table.end(), [](const Entry &a, const Entry &b) { return a.id < b.id; });
    return table;
}

constexpr auto kReaders = makeTable<
    mavlink::Attitude, mavlink::GlobalPositionInt, mavlink::GpsRawInt, mavlink::VfrHud, mavlink::SysStatus,
    mavlink::BatteryStatus, mavlink::EkfStatusReport, mavlink::EstimatorStatus, mavlink::Vibration, mavlink::MissionCurrent,
    mavlink::HomePosition, mavlink::ExtendedSysState, mavlink::HighLatency, mavlink::HighLatency2>();

} // namespace

TelemetryUpdate Telemetry::handle(const mavlink::Frame &frame, VehicleState &state)
{
    TelemetryUpdate update;
    const auto entry = std::lower_bound(kReaders.begin(), kReaders.end(), frame.messageId(),
                                        [](const Entry &e, std::uint32_t id) { return e.id < id; });
    if (entry != kReaders.end() && entry->id == frame.messageId()) {
        TelemetryContext context{state, *this, update};
        entry->read(frame, context);
    }
    return update;
}

} // namespace skyseal::vehicle
