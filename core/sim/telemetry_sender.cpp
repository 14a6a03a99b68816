#include "core/sim/telemetry_sender.h"

#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"
#include "core/sim/wire_units.h"

#include <cstring>

namespace skyseal::sim {

namespace {

constexpr std::size_t kTextChunk = 50;

} // namespace

TelemetrySender::TelemetrySender(const Autopilot &autopilot, FrameQueue &outbox, std::uint64_t seed)
    : m_autopilot(autopilot), m_outbox(outbox), m_noise(seed, 4), m_serial(Noise(seed, 5).next()),
      m_motion(autopilot, outbox, m_noise), m_traffic(autopilot)
{}

bool TelemetrySender::send(std::uint32_t message)
{
    return m_motion.send(message) || sendSystem(message);
}

bool TelemetrySender::sendSystem(std::uint32_t message)
{
    const bool px4 = m_autopilot.flight().type.isPx4();
    switch (message) {
    case mavlink::Heartbeat::kId: heartbeat(); return true;
    case mavlink::SysStatus::kId: systemStatus(); return true;
    case mavlink::BatteryStatus::kId: batteryStatus(); return true;
    case mavlink::GpsRawInt::kId: gpsRaw(); return true;
    case mavlink::ServoOutputRaw::kId: servos(); return true;
    case mavlink::RcChannels::kId: radioChannels(); return true;
    case mavlink::HomePosition::kId: return homePosition();
    case mavlink::ExtendedSysState::kId: extendedState(); return true;
    case mavlink::FenceStatus::kId: return fenceStatus();
    case mavlink::AutopilotVersion::kId: version(); return true;
    case mavlink::AdsbVehicle::kId: return aircraft();
    case mavlink::EstimatorStatus::kId: return px4 && (estimatorStatus(), true);
    case mavlink::PowerStatus::kId: {
        mavlink::PowerStatus out;
        out.Vcc = scaled<std::uint16_t>(5.02 + m_noise.normal(0.01), 1000);
        m_outbox.send(out);
        return true;
    }
    case mavlink::Meminfo::kId: {
        mavlink::Meminfo out;
        out.freemem = 65535;
        out.freemem32 = 131072;
        m_outbox.send(out);
        return true;
    }
    case mavlink::MissionCurrent::kId: {
        const MissionRunner &mission = m_autopilot.modes().mission();
        mavlink::MissionCurrent out;
        out.seq = mission.current();
        out.total = mission.mission().empty() ? 0 : static_cast<std::uint16_t>(mission.mission().size() - 1);
        const bool active = m_autopilot.modes().current() == FlightMode::Auto;
        out.mission_state = mission.mission().empty() ? 1 : mission.finished() ? 5 : !active ? 2 : mission.started() ? 3 : 4;
        out.mission_mode = active ? 1 : 2;
        m_outbox.send(out);
        return true;
    }
    case mavlink::SystemTime::kId: {
        mavlink::SystemTime out;
        out.time_unix_usec = static_cast<std::uint64_t>(m_wallTime.time_since_epoch().count());
        out.time_boot_ms = bootMilliseconds(m_autopilot);
        m_outbox.send(out);
        return true;
    }
    case mavlink::Ahrs::kId: {
        mavlink::Ahrs out;
        out.omegaIx = static_cast<float>(m_noise.normal(0.0004));
        out.omegaIy = static_cast<float>(m_noise.normal(0.0004));
        out.omegaIz = static_cast<float>(m_noise.normal(0.0004));
        out.error_rp = static_cast<float>(0.002 + std::abs(m_noise.normal(0.001)));
        out.error_yaw = static_cast<float>(0.004 + std::abs(m_noise.normal(0.002)));
        m_outbox.send(out);
        return true;
    }
    case mavlink::Wind::kId: {
        const Vector3 &wind = m_autopilot.flight().physics.wind().velocity();
        mavlink::Wind out;
        out.direction = static_cast<float>(degrees(std::atan2(-wind.y, -wind.x)));
        out.speed = static_cast<float>(wind.horizontal());
        out.speed_z = static_cast<float>(wind.z);
        m_outbox.send(out);
        return true;
    }
    case mavlink::EkfStatusReport::kId: {
        const FilterVariances &variances = m_autopilot.flight().physics.estimator().variances();
        mavlink::EkfStatusReport out;
        out.flags = m_autopilot.flight().physics.estimator().flags();
        out.velocity_variance = static_cast<float>(variances.velocity);
        out.pos_horiz_variance = static_cast<float>(variances.horizontal);
        out.pos_vert_variance = static_cast<float>(variances.vertical);
        out.compass_variance = static_cast<float>(variances.compass);
        m_outbox.send(out);
        return true;
    }
    case mavlink::GpsGlobalOrigin::kId: {
        if (!m_autopilot.flight().home.position())
            return false;
        const GeoPoint &origin = m_autopilot.flight().world.origin();
        mavlink::GpsGlobalOrigin out;
        out.latitude = scaled<std::int32_t>(origin.latitude, 1e7);
        out.longitude = scaled<std::int32_t>(origin.longitude, 1e7);
        out.altitude = scaled<std::int32_t>(origin.altitude, 1000);
        out.time_usec = m_autopilot.time();
        m_outbox.send(out);
        return true;
    }
    default: return false;
    }
}

bool TelemetrySender::aircraft()
{
    const auto report = m_traffic.nextReport();
    if (report)
        m_outbox.send(*report);
    return report.has_value();
}

std::uint8_t TelemetrySender::baseMode() const
{
    using namespace mavlink;
    const ModeRow &mode = m_autopilot.modes().row();
    std::uint8_t out = MAV_MODE_FLAG_CUSTOM_MODE_ENABLED;
    if (!m_autopilot.flight().type.isPx4()) {
        out |= MAV_MODE_FLAG_STABILIZE_ENABLED | MAV_MODE_FLAG_MANUAL_INPUT_ENABLED;
        if (mode.needsPosition)
            out |= MAV_MODE_FLAG_GUIDED_ENABLED;
        return out;
    }
    // As streams/HEARTBEAT.hpp of PX4: what the pilot flies, and what flies by itself.
    out |= MAV_MODE_FLAG_STABILIZE_ENABLED;
    if (mode.mode == FlightMode::Land || !(mode.manualThrottle))
        out |= MAV_MODE_FLAG_AUTO_ENABLED | MAV_MODE_FLAG_GUIDED_ENABLED;
    else
        out |= MAV_MODE_FLAG_MANUAL_INPUT_ENABLED;
    return out;
}

void TelemetrySender::heartbeat()
{
    const VehicleType &type = m_autopilot.flight().type;
    mavlink::Heartbeat out;
    out.type = type.mavType();
    out.autopilot = type.isPx4() ? mavlink::MAV_AUTOPILOT_PX4 : mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA;
    out.base_mode = baseMode();
    if (m_autopilot.armed())
        out.base_mode |= mavlink::MAV_MODE_FLAG_SAFETY_ARMED;
    out.custom_mode = m_autopilot.modes().row().number;
    out.system_status = !m_autopilot.estimate().attitudeOk ? mavlink::MAV_STATE_CALIBRATING
        : m_autopilot.failsafes().active()                 ? mavlink::MAV_STATE_CRITICAL
        : m_autopilot.armed()                              ? mavlink::MAV_STATE_ACTIVE
                                                           : mavlink::MAV_STATE_STANDBY;
    out.mavlink_version = 3;
    m_outbox.send(out);
}

void TelemetrySender::systemStatus()
{
    using namespace mavlink;
    constexpr std::uint32_t always = MAV_SYS_STATUS_SENSOR_3D_GYRO | MAV_SYS_STATUS_SENSOR_3D_ACCEL
        | MAV_SYS_STATUS_SENSOR_3D_MAG | MAV_SYS_STATUS_SENSOR_ABSOLUTE_PRESSURE | MAV_SYS_STATUS_SENSOR_ANGULAR_RATE_CONTROL
        | MAV_SYS_STATUS_SENSOR_ATTITUDE_STABILIZATION | MAV_SYS_STATUS_SENSOR_YAW_POSITION | MAV_SYS_STATUS_SENSOR_RC_RECEIVER
        | MAV_SYS_STATUS_LOGGING;
    constexpr std::uint32_t position = MAV_SYS_STATUS_SENSOR_GPS | MAV_SYS_STATUS_SENSOR_XY_POSITION_CONTROL;
    constexpr std::uint32_t height = MAV_SYS_STATUS_SENSOR_Z_ALTITUDE_CONTROL;
    constexpr std::uint32_t others = MAV_SYS_STATUS_AHRS | MAV_SYS_STATUS_SENSOR_BATTERY | MAV_SYS_STATUS_PREARM_CHECK
        | MAV_SYS_STATUS_SENSOR_MOTOR_OUTPUTS;
    const FlightMode mode = m_autopilot.modes().current();
    const Estimate &estimate = m_autopilot.estimate();

    SysStatus out;
    out.onboard_control_sensors_present = always | position | height | others;
    out.onboard_control_sensors_enabled = always | others | MAV_SYS_STATUS_SENSOR_GPS;
    if (mode != FlightMode::Stabilize)
        out.onboard_control_sensors_enabled |= height;
    if (m_autopilot.modes().row().needsPosition)
        out.onboard_control_sensors_enabled |= MAV_SYS_STATUS_SENSOR_XY_POSITION_CONTROL;
    if (!m_autopilot.armed())
        out.onboard_control_sensors_enabled &= ~static_cast<std::uint32_t>(MAV_SYS_STATUS_SENSOR_MOTOR_OUTPUTS);
    out.onboard_control_sensors_health = always | height | MAV_SYS_STATUS_SENSOR_MOTOR_OUTPUTS;
    const auto failed = [&](bool fault, std::uint32_t sensor) {
        if (fault)
            out.onboard_control_sensors_health &= ~sensor;
    };
    failed(m_autopilot.flight().settings.faults.compassFailed, MAV_SYS_STATUS_SENSOR_3D_MAG);
    failed(m_autopilot.flight().settings.faults.pressureFailed, MAV_SYS_STATUS_SENSOR_ABSOLUTE_PRESSURE);
    failed(m_autopilot.flight().radioWatch.lost(), MAV_SYS_STATUS_SENSOR_RC_RECEIVER);
    if (m_autopilot.flight().physics.gps().fixed)
        out.onboard_control_sensors_health |= MAV_SYS_STATUS_SENSOR_GPS;
    if (estimate.positionOk)
        out.onboard_control_sensors_health |= MAV_SYS_STATUS_SENSOR_XY_POSITION_CONTROL;
    if (estimate.attitudeOk)
        out.onboard_control_sensors_health |= MAV_SYS_STATUS_AHRS;
    if (m_autopilot.flight().batteryWatch.level() == BatteryLevel::Good)
        out.onboard_control_sensors_health |= MAV_SYS_STATUS_SENSOR_BATTERY;
    if (m_autopilot.armed() || !m_autopilot.arming().preArm())
        out.onboard_control_sensors_health |= MAV_SYS_STATUS_PREARM_CHECK;

    const Fence &fence = m_autopilot.flight().fence;
    if (fence.present()) {
        out.onboard_control_sensors_present |= MAV_SYS_STATUS_GEOFENCE;
        if (fence.enabled() && m_autopilot.parameters().flag("FENCE_ACTION"))
            out.onboard_control_sensors_enabled |= MAV_SYS_STATUS_GEOFENCE;
    }
    if (fence.breaches() == 0) // also without a fence: ground stations read a cleared bit as a breach
        out.onboard_control_sensors_health |= MAV_SYS_STATUS_GEOFENCE;

    const Battery &battery = m_autopilot.flight().physics.battery();
    out.load = scaled<std::uint16_t>(280 + m_noise.normal(12));
    out.voltage_battery = scaled<std::uint16_t>(battery.voltage() + m_noise.normal(0.006), 1000);
    out.current_battery = scaled<std::int16_t>(battery.current() + m_noise.normal(0.08), 100);
    out.battery_remaining = scaled<std::int8_t>(std::floor(battery.percent()));
    m_outbox.send(out);
}

void TelemetrySender::batteryStatus()
{
    const Battery &battery = m_autopilot.flight().physics.battery();
    mavlink::BatteryStatus out;
    out.type = mavlink::MAV_BATTERY_TYPE_LIPO;
    out.temperature = std::numeric_limits<std::int16_t>::max(); // not known
    out.voltages.fill(65535);
    out.voltages[0] = scaled<std::uint16_t>(battery.voltage() + m_noise.normal(0.006),
                                            1000); // the pack: its cells have no sensor
    out.current_battery = scaled<std::int16_t>(battery.current() + m_noise.normal(0.08), 100);
    out.current_consumed = scaled<std::int32_t>(battery.consumed());
    out.energy_consumed = scaled<std::int32_t>(battery.energy(), 0.01);
    out.battery_remaining = scaled<std::int8_t>(std::floor(battery.percent()));
    out.charge_state = m_autopilot.flight().batteryWatch.level() == BatteryLevel::Good ? mavlink::MAV_BATTERY_CHARGE_STATE_OK
        : m_autopilot.flight().batteryWatch.level() == BatteryLevel::Low               ? mavlink::MAV_BATTERY_CHARGE_STATE_LOW
                                                                         : mavlink::MAV_BATTERY_CHARGE_STATE_CRITICAL;
    m_outbox.send(out);
}

void TelemetrySender::gpsRaw()
{
    const GpsReport &gps = m_autopilot.flight().physics.gps();
    mavlink::GpsRawInt out;
    out.time_usec = gps.takenAt;
    out.fix_type = gps.fixed ? mavlink::GPS_FIX_TYPE_3D_FIX : mavlink::GPS_FIX_TYPE_NO_FIX;
    out.eph = scaled<std::uint16_t>(gps.hdop, 100);
    out.epv = scaled<std::uint16_t>(gps.vdop, 100);
    out.satellites_visible = static_cast<std::uint8_t>(gps.satellites);
    if (gps.fixed) {
        const GeoPoint here = place(gps.position);
        const double course = degrees(std::atan2(gps.velocity.y, gps.velocity.x));
        out.lat = scaled<std::int32_t>(here.latitude, 1e7);
        out.lon = scaled<std::int32_t>(here.longitude, 1e7);
        out.alt = scaled<std::int32_t>(here.altitude, 1000);
        out.vel = scaled<std::uint16_t>(gps.velocity.horizontal(), 100);
        out.cog = scaled<std::uint16_t>(course < 0 ? course + 360 : course, 100);
        out.h_acc = scaled<std::uint32_t>(gps.hdop * 0.6, 1000);
        out.v_acc = scaled<std::uint32_t>(gps.vdop * 0.6, 1000);
        out.vel_acc = 200;
    }
    m_outbox.send(out);
}

void TelemetrySender::servos()
{
    mavlink::ServoOutputRaw out;
    out.time_usec = static_cast<std::uint32_t>(m_autopilot.time());
    const Craft::Signals signal = m_autopilot.craft().signals(m_autopilot.armed(), m_autopilot.parameters());
    out.servo1_raw = signal[0];
    out.servo2_raw = signal[1];
    out.servo3_raw = signal[2];
    out.servo4_raw = signal[3];
    m_outbox.send(out);
}

void TelemetrySender::radioChannels()
{
    const PilotInput::Channels channels = m_autopilot.flight().pilot.channels();
    mavlink::RcChannels out;
    out.time_boot_ms = bootMilliseconds(m_autopilot);
    out.chancount = 8;
    out.chan1_raw = channels[0];
    out.chan2_raw = channels[1];
    out.chan3_raw = channels[2];
    out.chan4_raw = channels[3];
    out.chan5_raw = channels[4];
    out.chan6_raw = channels[5];
    out.chan7_raw = channels[6];
    out.chan8_raw = channels[7];
    out.rssi = 255; // not known
    m_outbox.send(out);
}

bool TelemetrySender::homePosition()
{
    if (!m_autopilot.flight().home.position())
        return false;
    const GeoPoint home = place(*m_autopilot.flight().home.position());
    mavlink::HomePosition out;
    out.latitude = scaled<std::int32_t>(home.latitude, 1e7);
    out.longitude = scaled<std::int32_t>(home.longitude, 1e7);
    out.altitude = scaled<std::int32_t>(home.altitude, 1000);
    out.x = static_cast<float>(m_autopilot.flight().home.position()->x);
    out.y = static_cast<float>(m_autopilot.flight().home.position()->y);
    out.z = static_cast<float>(m_autopilot.flight().home.position()->z);
    out.q = {1, 0, 0, 0};
    out.time_usec = m_autopilot.time();
    m_outbox.send(out);
    return true;
}

void TelemetrySender::extendedState()
{
    const FlightMode mode = m_autopilot.modes().current();
    mavlink::ExtendedSysState out;
    if (!m_autopilot.flight().settings.flies)
        out.landed_state = mavlink::MAV_LANDED_STATE_UNDEFINED;
    else if (m_autopilot.landed())
        out.landed_state = mavlink::MAV_LANDED_STATE_ON_GROUND;
    else if (mode == FlightMode::Land)
        out.landed_state = mavlink::MAV_LANDED_STATE_LANDING;
    else if (m_autopilot.modes().takingOff())
        out.landed_state = mavlink::MAV_LANDED_STATE_TAKEOFF;
    else
        out.landed_state = mavlink::MAV_LANDED_STATE_IN_AIR;
    m_outbox.send(out);
}

bool TelemetrySender::fenceStatus()
{
    const Fence &fence = m_autopilot.flight().fence;
    if (!fence.enabled())
        return false;
    mavlink::FenceStatus out;
    out.breach_status = fence.breaches() != 0;
    out.breach_count = fence.breachCount();
    out.breach_time = fence.breachTime();
    out.breach_mitigation = mavlink::FENCE_MITIGATE_NONE;
    if (fence.breaches() & mavlink::FENCE_TYPE_ALT_MIN)
        out.breach_type = mavlink::FENCE_BREACH_MINALT;
    if (fence.breaches() & mavlink::FENCE_TYPE_ALT_MAX)
        out.breach_type = mavlink::FENCE_BREACH_MAXALT;
    if (fence.breaches() & (mavlink::FENCE_TYPE_CIRCLE | mavlink::FENCE_TYPE_POLYGON))
        out.breach_type = mavlink::FENCE_BREACH_BOUNDARY;
    m_outbox.send(out);
    return true;
}

void TelemetrySender::version()
{
    using namespace mavlink;
    constexpr std::uint64_t kBoth = MAV_PROTOCOL_CAPABILITY_MISSION_INT | MAV_PROTOCOL_CAPABILITY_COMMAND_INT
        | MAV_PROTOCOL_CAPABILITY_SET_POSITION_TARGET_LOCAL_NED | MAV_PROTOCOL_CAPABILITY_SET_POSITION_TARGET_GLOBAL_INT
        | MAV_PROTOCOL_CAPABILITY_MAVLINK2 | MAV_PROTOCOL_CAPABILITY_MISSION_FENCE | MAV_PROTOCOL_CAPABILITY_MISSION_RALLY
        | MAV_PROTOCOL_CAPABILITY_FTP;
    const bool px4 = m_autopilot.flight().type.isPx4();
    AutopilotVersion out;
    out.capabilities = kBoth
        | (px4 ? MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_BYTEWISE
               : MAV_PROTOCOL_CAPABILITY_MISSION_FLOAT | MAV_PROTOCOL_CAPABILITY_PARAM_FLOAT);
    const std::uint32_t number = px4 ? 1u << 24 | 14u << 16 | 3u << 8
                                     : 4u << 24 | 5u << 16 | 7u << 8; // PX4 1.14.3, ArduPilot 4.5.7
    out.flight_sw_version = number | FIRMWARE_VERSION_TYPE_OFFICIAL;
    constexpr char kMark[] = "skyseal";
    std::copy_n(kMark, out.flight_custom_version.size(), out.flight_custom_version.begin());
    out.uid = m_serial;
    for (std::size_t i = 0; i < out.uid2.size(); ++i)
        out.uid2[i] = static_cast<std::uint8_t>(m_serial >> (i % 8 * 8) ^ i / 8);
    m_outbox.send(out);
}

void TelemetrySender::estimatorStatus()
{
    const FilterVariances &variances = m_autopilot.flight().physics.estimator().variances();
    mavlink::EstimatorStatus out;
    out.time_usec = m_autopilot.time();
    // ESTIMATOR_STATUS_FLAGS has the same bits as EKF_STATUS_FLAGS up to the tenth.
    out.flags = m_autopilot.flight().physics.estimator().flags() & 0x3ff;
    out.vel_ratio = static_cast<float>(variances.velocity);
    out.pos_horiz_ratio = static_cast<float>(variances.horizontal);
    out.pos_vert_ratio = static_cast<float>(variances.vertical);
    out.mag_ratio = static_cast<float>(variances.compass);
    out.pos_horiz_accuracy = 0.3f;
    out.pos_vert_accuracy = 0.4f;
    m_outbox.send(out);
}

void TelemetrySender::sendText(const PendingText &text)
{
    mavlink::Statustext out;
    out.severity = static_cast<std::uint8_t>(text.severity);
    const bool chunked = text.text.size() > kTextChunk;
    if (chunked)
        out.id = ++m_textId == 0 ? ++m_textId : m_textId; // 0 means a text that is whole
    // A chunk that is not full ends the text: one that ends exactly at a border is followed by an empty one.
    const std::size_t last = chunked ? text.text.size() / kTextChunk : 0;
    for (std::size_t chunk = 0; chunk <= last && chunk < 256; ++chunk) {
        const std::string_view part = std::string_view(text.text).substr(std::min(chunk * kTextChunk, text.text.size()),
                                                                         kTextChunk);
        out.text = {};
        std::copy(part.begin(), part.end(), out.text.begin());
        out.chunk_seq = static_cast<std::uint8_t>(chunk);
        m_outbox.send(out);
    }
}

} // namespace skyseal::sim
