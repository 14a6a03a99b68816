#include "core/vehicle/telemetry.h"

#include "core/vehicle/known_value.h"
#include "core/vehicle/message_io.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace skyseal::vehicle {

/// Input and output of the readers.
struct TelemetryContext
{
    TimePoint now;
    VehicleState &state;
    Telemetry &memory;
    TelemetryUpdate &update;
};

namespace {

/// The position of a message in degrees · 1e7, its altitude in metres; unknown unless it is on Earth. Autopilots send 0°, 0°
/// until they have a position, and again when they lose it: neither field has a value of its own for that.
Position placeOf(std::int32_t latitude, std::int32_t longitude, double altitude)
{
    const bool isPlace = (latitude != 0 || longitude != 0) && std::abs(std::int64_t{latitude}) <= 900000000
        && std::abs(std::int64_t{longitude}) <= 1800000000;
    return isPlace ? Position{latitude * 1e-7, longitude * 1e-7, altitude} : Position{};
}

/// Limits of what a vehicle can mean. Greater values, infinities and NaN are errors or attacks, and count as not known: nothing
/// that draws or converts the state needs to expect them.
constexpr double kGreatestAngle = 1e3;     // radians
constexpr double kGreatestSpeed = 1e5;     // metres or radians a second
constexpr double kGreatestVibration = 1e5; // m/s²

/// What every estimator needs to fly by: EKF_STATUS_REPORT and ESTIMATOR_STATUS agree in these bits.
bool hasEstimate(std::uint16_t flags)
{
    using namespace mavlink;
    constexpr std::uint16_t kNeeded = EKF_ATTITUDE | EKF_VELOCITY_HORIZ | EKF_POS_HORIZ_ABS | EKF_POS_VERT_ABS;
    return (flags & kNeeded) == kNeeded;
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
        c.memory.m_estimate = placeOf(m.lat, m.lon, m.alt * 1e-3);
        showPosition(c);
        constexpr std::uint32_t kLate = 3000; // milliseconds that a frame may be delayed
        c.update.restarted = m.time_boot_ms < c.memory.m_sinceBoot && c.memory.m_sinceBoot - m.time_boot_ms > kLate;
        if (c.update.restarted || m.time_boot_ms > c.memory.m_sinceBoot)
            c.memory.m_sinceBoot = m.time_boot_ms;
        c.state.altitudeRelative = m.relative_alt * 1e-3;
        c.state.groundSpeed = std::hypot(m.vx * 0.01, m.vy * 0.01);
        c.state.climb = m.vz * -0.01;
        c.state.heading = std::fmod(known<&mavlink::GlobalPositionInt::hdg>(m, 0.01), 360);
        c.memory.m_headingKnown = !std::isnan(c.state.heading);
    }

    static void read(const mavlink::GpsRawInt &m, Context &c)
    {
        c.state.gpsFix = m.fix_type;
        c.state.satellites = knownWhole<&mavlink::GpsRawInt::satellites_visible>(m);
        c.state.hdop = known<&mavlink::GpsRawInt::eph>(m, 0.01);
        const bool hasPlace = m.fix_type >= mavlink::GPS_FIX_TYPE_2D_FIX;
        const double altitude = m.fix_type >= mavlink::GPS_FIX_TYPE_3D_FIX ? m.alt * 1e-3 : kUnknown;
        c.memory.m_raw = hasPlace ? placeOf(m.lat, m.lon, altitude) : Position{};
        if (c.memory.m_estimate.known())
            return;
        showPosition(c);
        c.state.groundSpeed = hasPlace ? known<&mavlink::GpsRawInt::vel>(m, 0.01) : kUnknown;
    }

    static void read(const mavlink::VfrHud &m, Context &c)
    {
        c.state.airSpeed = within(m.airspeed, kGreatestSpeed);
        c.state.groundSpeed = within(m.groundspeed, kGreatestSpeed);
        c.state.climb = within(m.climb, kGreatestSpeed);
        c.state.throttle = m.throttle;
        if (c.memory.m_headingKnown)
            c.state.heading = m.heading >= 0 ? m.heading % 360 : kUnknown;
    }

    static void read(const mavlink::SysStatus &m, Context &c)
    {
        // ArduPilot has the bit among those present, and enabled unless all checks are disabled. PX4 1.19 sets it in the health
        // alone, when all checks pass.
        const bool passes = (m.onboard_control_sensors_health & mavlink::MAV_SYS_STATUS_PREARM_CHECK) != 0;
        const bool isPresent = (m.onboard_control_sensors_present & mavlink::MAV_SYS_STATUS_PREARM_CHECK) != 0;
        const bool isEnabled = (m.onboard_control_sensors_enabled & mavlink::MAV_SYS_STATUS_PREARM_CHECK) != 0;
        c.memory.m_checksByHealth = !isPresent && (passes || c.memory.m_checksByHealth);
        c.state.preArmOk.reset();
        if ((isPresent && isEnabled) || c.memory.m_checksByHealth)
            c.state.preArmOk = passes;
        c.state.cpuLoad = m.load * 0.1;
        c.memory.m_batteries.handle(c.now, m);
        c.memory.m_batteries.show(c.state);
    }

    static void read(const mavlink::BatteryStatus &m, Context &c)
    {
        c.memory.m_batteries.handle(c.now, m);
        c.memory.m_batteries.show(c.state);
    }

    static void read(const mavlink::EkfStatusReport &m, Context &c)
    {
        using namespace mavlink;
        c.state.ekfFlags = m.flags;
        c.state.ekfOk.reset();
        const std::array variances{m.velocity_variance, m.pos_horiz_variance, m.pos_vert_variance, m.compass_variance};
        const bool runsNone = m.flags == 0 && std::ranges::all_of(variances, [](float one) { return one == 0; });
        if (runsNone) // ArduPilot that is set to fly without an EKF reports zeros
            return;
        constexpr std::uint16_t kAgainst = EKF_CONST_POS_MODE | EKF_UNINITIALIZED | EKF_GPS_GLITCHING;
        const bool consistent = std::ranges::all_of(variances, [](float one) { return one < 1; });
        c.state.ekfOk = hasEstimate(m.flags) && (m.flags & kAgainst) == 0 && consistent;
    }

    /// PX4. Its constant-position bit is set whenever the vehicle is at rest and says nothing against the estimate; an
    /// estimator that holds its position for want of measurements lacks the absolute position.
    static void read(const mavlink::EstimatorStatus &m, Context &c)
    {
        using namespace mavlink;
        c.state.ekfFlags = m.flags;
        c.state.ekfOk = hasEstimate(m.flags) && (m.flags & (ESTIMATOR_GPS_GLITCH | ESTIMATOR_ACCEL_ERROR)) == 0;
    }

    static void read(const mavlink::Vibration &m, Context &c)
    {
        double worst = 0;
        for (const float axis : {m.vibration_x, m.vibration_y, m.vibration_z}) {
            const double one = within(axis, kGreatestVibration);
            worst = std::isnan(one) ? kUnknown : std::max(worst, one); // max() keeps an unknown first value
        }
        c.state.vibration = worst;
    }

    static void read(const mavlink::MissionCurrent &m, Context &c)
    {
        c.state.missionCurrent = knownWhole<&mavlink::MissionCurrent::seq>(m);
        if (m.mission_state == mavlink::MISSION_STATE_NO_MISSION)
            c.state.missionCurrent = -1;
    }

    static void read(const mavlink::HomePosition &m, Context &c)
    {
        if (const Position home = placeOf(m.latitude, m.longitude, m.altitude * 1e-3); home.known())
            c.update.home = home;
    }

    static void read(const mavlink::ExtendedSysState &m, Context &c)
    {
        if (m.vtol_state != mavlink::MAV_VTOL_STATE_UNDEFINED) // ArduPlane's quadplanes are of the type of planes
            c.update.verticalTakeOff = true;
        c.update.landed = m.landed_state <= mavlink::MAV_LANDED_STATE_LANDING ? static_cast<LandedState>(m.landed_state)
                                                                              : LandedState::Undefined;
    }

    /// The whole state of a vehicle behind a satellite modem.
    static void read(const mavlink::HighLatency2 &m, Context &c)
    {
        c.memory.m_estimate = placeOf(m.latitude, m.longitude, m.altitude);
        showPosition(c);
        c.state.altitudeRelative = c.state.position.altitude - c.state.home.altitude;
        c.state.heading = m.heading * 2 % 360; // degrees / 2
        c.state.yaw = std::remainder(m.heading * 2 * std::numbers::pi / 180, 2 * std::numbers::pi);
        c.state.throttle = m.throttle;
        c.state.airSpeed = m.airspeed * 0.2; // m/s × 5
        c.state.groundSpeed = m.groundspeed * 0.2;
        c.state.climb = m.climb_rate * 0.1;
        c.state.batteryPercent = known<&mavlink::HighLatency2::battery>(m);
        c.state.missionCurrent = m.wp_num;
    }

    /// The older message of the same purpose.
    static void read(const mavlink::HighLatency &m, Context &c)
    {
        c.memory.m_estimate = placeOf(m.latitude, m.longitude, m.altitude_amsl);
        showPosition(c);
        c.state.altitudeRelative = c.state.position.altitude - c.state.home.altitude;
        c.state.roll = m.roll * 0.01 * std::numbers::pi / 180; // centidegrees
        c.state.pitch = m.pitch * 0.01 * std::numbers::pi / 180;
        c.state.yaw = std::remainder(m.heading * 0.01 * std::numbers::pi / 180, 2 * std::numbers::pi);
        c.state.heading = m.heading % 36000 * 0.01;
        c.state.throttle = m.throttle;
        c.state.airSpeed = m.airspeed;
        c.state.groundSpeed = m.groundspeed;
        c.state.climb = m.climb_rate;
        c.state.gpsFix = m.gps_fix_type;
        c.state.satellites = knownWhole<&mavlink::HighLatency::gps_nsat>(m);
        c.state.batteryPercent = m.battery_remaining <= 100 ? double(m.battery_remaining) : kUnknown;
        c.state.missionCurrent = m.wp_num;
        c.update.landed = m.landed_state <= mavlink::MAV_LANDED_STATE_LANDING ? static_cast<LandedState>(m.landed_state)
                                                                              : LandedState::Undefined;
    }

private:
    static void showPosition(Context &c)
    {
        c.state.position = c.memory.m_estimate.known() ? c.memory.m_estimate : c.memory.m_raw;
        c.update.positionChanged = true;
    }
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

TelemetryUpdate Telemetry::handle(TimePoint now, const mavlink::Frame &frame, VehicleState &state)
{
    TelemetryUpdate update;
    const auto entry = std::lower_bound(kReaders.begin(), kReaders.end(), frame.messageId(),
                                        [](const Entry &e, std::uint32_t id) { return e.id < id; });
    if (entry != kReaders.end() && entry->id == frame.messageId()) {
        TelemetryContext context{now, state, *this, update};
        entry->read(frame, context);
    }
    return update;
}

} // namespace skyseal::vehicle
