#include "core/sim/motion_messages.h"

#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"
#include "core/sim/wire_units.h"

namespace skyseal::sim {

namespace {

constexpr Vector3 kEarthField{232, 52, -528}; // milligauss NED, near Canberra
constexpr double kMilligravity = 1000 / kGravity;
constexpr double kStandardPressure = 1013.25; // hPa

double heading(const Estimate &estimate) // degrees, [0, 360)
{
    const double yaw = degrees(estimate.attitude.euler().yaw);
    return yaw < 0 ? yaw + 360 : yaw;
}

} // namespace

bool MotionMessages::send(std::uint32_t message)
{
    switch (message) {
    case mavlink::Attitude::kId: attitude(); return true;
    case mavlink::GlobalPositionInt::kId: globalPosition(); return true;
    case mavlink::LocalPositionNed::kId: localPosition(); return true;
    case mavlink::PositionTargetGlobalInt::kId: return positionTarget();
    case mavlink::PositionTargetLocalNed::kId: return isPx4() && localTarget();
    case mavlink::AttitudeTarget::kId: return isPx4() && attitudeTarget();
    case mavlink::RawImu::kId: rawImu(); return true;
    case mavlink::ScaledImu2::kId: scaledImu(); return true;
    case mavlink::ScaledPressure::kId: pressure(); return true;
    case mavlink::VfrHud::kId: hud(); return true;
    case mavlink::NavControllerOutput::kId: navigation(); return true;
    case mavlink::Vibration::kId: vibration(); return true;
    default: return false;
    }
}

void MotionMessages::attitude()
{
    const Estimate &e = m_autopilot.estimate();
    const Euler angles = e.attitude.euler();
    mavlink::Attitude out;
    out.time_boot_ms = bootMilliseconds(m_autopilot);
    out.roll = static_cast<float>(angles.roll);
    out.pitch = static_cast<float>(angles.pitch);
    out.yaw = static_cast<float>(angles.yaw);
    out.rollspeed = static_cast<float>(e.rates.x);
    out.pitchspeed = static_cast<float>(e.rates.y);
    out.yawspeed = static_cast<float>(e.rates.z);
    m_outbox.send(out);
}

void MotionMessages::globalPosition()
{
    const Estimate &e = m_autopilot.estimate();
    const GeoPoint here = place(e.position);
    mavlink::GlobalPositionInt out;
    out.time_boot_ms = bootMilliseconds(m_autopilot);
    if (m_autopilot.flight().home.position()) { // before the first fix the place is not known, and ArduPilot sends zeros
        out.lat = scaled<std::int32_t>(here.latitude, 1e7);
        out.lon = scaled<std::int32_t>(here.longitude, 1e7);
    }
    out.alt = scaled<std::int32_t>(here.altitude, 1000);
    out.relative_alt = scaled<std::int32_t>(m_autopilot.heightAboveHome(), 1000);
    out.vx = scaled<std::int16_t>(e.velocity.x, 100);
    out.vy = scaled<std::int16_t>(e.velocity.y, 100);
    out.vz = scaled<std::int16_t>(e.velocity.z, 100);
    out.hdg = scaled<std::uint16_t>(heading(e), 100);
    m_outbox.send(out);
}

void MotionMessages::localPosition()
{
    const Estimate &e = m_autopilot.estimate();
    mavlink::LocalPositionNed out;
    out.time_boot_ms = bootMilliseconds(m_autopilot);
    out.x = static_cast<float>(e.position.x);
    out.y = static_cast<float>(e.position.y);
    out.z = static_cast<float>(e.position.z);
    out.vx = static_cast<float>(e.velocity.x);
    out.vy = static_cast<float>(e.velocity.y);
    out.vz = static_cast<float>(e.velocity.z);
    m_outbox.send(out);
}

bool MotionMessages::positionTarget()
{
    const auto target = m_autopilot.modes().place(m_autopilot.flight().situation());
    if (!target || !m_autopilot.armed())
        return false;
    const GeoPoint there = place(*target);
    mavlink::PositionTargetGlobalInt out;
    out.time_boot_ms = bootMilliseconds(m_autopilot);
    out.coordinate_frame = 5; // global, integers
    out.type_mask = 0xfff8;   // only the position means something
    out.lat_int = scaled<std::int32_t>(there.latitude, 1e7);
    out.lon_int = scaled<std::int32_t>(there.longitude, 1e7);
    out.alt = static_cast<float>(there.altitude);
    m_outbox.send(out);
    return true;
}

bool MotionMessages::localTarget()
{
    const auto target = m_autopilot.modes().place(m_autopilot.flight().situation());
    if (!target || !m_autopilot.armed())
        return false;
    mavlink::PositionTargetLocalNed out;
    out.time_boot_ms = bootMilliseconds(m_autopilot);
    out.coordinate_frame = mavlink::MAV_FRAME_LOCAL_NED;
    out.type_mask = 0xfff8; // only the position means something
    out.x = static_cast<float>(target->x);
    out.y = static_cast<float>(target->y);
    out.z = static_cast<float>(target->z);
    m_outbox.send(out);
    return true;
}

bool MotionMessages::attitudeTarget()
{
    const Attitude target = Attitude::fromEuler(m_autopilot.craft().target());
    mavlink::AttitudeTarget out;
    out.time_boot_ms = bootMilliseconds(m_autopilot);
    out.q = {static_cast<float>(target.w()), static_cast<float>(target.vector().x), static_cast<float>(target.vector().y),
             static_cast<float>(target.vector().z)};
    out.thrust = static_cast<float>(m_autopilot.craft().throttle());
    m_outbox.send(out);
    return true;
}

MotionMessages::Inertial MotionMessages::inertial()
{
    const BodyState &truth = m_autopilot.truth();
    const double lift = m_autopilot.craft().load();
    const double shake = 0.02 + 0.5 * lift; // m/s²: rotors make the frame vibrate
    const auto noisy = [&](const Vector3 &v, double deviation) {
        return v + Vector3{m_noise.normal(deviation), m_noise.normal(deviation), m_noise.normal(deviation)};
    };
    return {noisy(truth.specificForce, shake), noisy(truth.rates, 0.001 + 0.01 * lift),
            m_autopilot.flight().settings.faults.compassFailed ? Vector3{} : noisy(truth.attitude.toBody(kEarthField), 1.5)};
}

template<typename Message> void MotionMessages::writeInertial(const Inertial &read, Message &out)
{
    out.xacc = scaled<std::int16_t>(read.acceleration.x, kMilligravity);
    out.yacc = scaled<std::int16_t>(read.acceleration.y, kMilligravity);
    out.zacc = scaled<std::int16_t>(read.acceleration.z, kMilligravity);
    out.xgyro = scaled<std::int16_t>(read.rates.x, 1000);
    out.ygyro = scaled<std::int16_t>(read.rates.y, 1000);
    out.zgyro = scaled<std::int16_t>(read.rates.z, 1000);
    out.xmag = scaled<std::int16_t>(read.field.x);
    out.ymag = scaled<std::int16_t>(read.field.y);
    out.zmag = scaled<std::int16_t>(read.field.z);
}

void MotionMessages::rawImu()
{
    mavlink::RawImu out;
    out.time_usec = m_autopilot.time();
    writeInertial(inertial(), out);
    out.temperature = 4500;
    m_outbox.send(out);
}

void MotionMessages::scaledImu()
{
    mavlink::ScaledImu2 out;
    out.time_boot_ms = bootMilliseconds(m_autopilot);
    writeInertial(inertial(), out);
    out.temperature = 4480;
    m_outbox.send(out);
}

void MotionMessages::pressure()
{
    const double altitude = m_autopilot.flight().world.origin().altitude - m_autopilot.truth().position.z;
    mavlink::ScaledPressure out;
    out.time_boot_ms = bootMilliseconds(m_autopilot);
    // The international standard atmosphere, below 11 km.
    out.press_abs = static_cast<float>(kStandardPressure * std::pow(std::max(1 - altitude * 2.25577e-5, 0.2), 5.25588)
                                       + m_noise.normal(0.012));
    out.temperature = scaled<std::int16_t>(35 - altitude * 0.0065, 100);
    m_outbox.send(out);
}

void MotionMessages::hud()
{
    const Estimate &e = m_autopilot.estimate();
    mavlink::VfrHud out;
    out.groundspeed = static_cast<float>(e.velocity.horizontal());
    out.airspeed = static_cast<float>((e.velocity - m_autopilot.flight().physics.wind().velocity()).horizontal());
    if (m_autopilot.landed())
        out.airspeed = 0;
    out.heading = scaled<std::int16_t>(std::fmod(std::round(heading(e)), 360));
    out.throttle = scaled<std::uint16_t>(m_autopilot.craft().throttle(), 100);
    out.alt = static_cast<float>(place(e.position).altitude);
    out.climb = static_cast<float>(e.climb());
    m_outbox.send(out);
}

void MotionMessages::navigation()
{
    const Situation now = m_autopilot.flight().situation();
    const Euler target = m_autopilot.craft().target();
    mavlink::NavControllerOutput out;
    out.nav_roll = static_cast<float>(degrees(target.roll));
    out.nav_pitch = static_cast<float>(degrees(target.pitch));
    out.nav_bearing = scaled<std::int16_t>(degrees(now.estimate.attitude.euler().yaw));
    if (const auto goal = m_autopilot.modes().place(now)) {
        const Vector3 way = *goal - now.estimate.position;
        out.target_bearing = scaled<std::int16_t>(degrees(std::atan2(way.y, way.x)));
        out.wp_dist = scaled<std::uint16_t>(way.horizontal());
        out.alt_error = static_cast<float>(-way.z);
    }
    m_outbox.send(out);
}

void MotionMessages::vibration()
{
    const double lift = m_autopilot.craft().load();
    mavlink::Vibration out;
    out.time_usec = m_autopilot.time();
    out.vibration_x = static_cast<float>(0.02 + lift * (14 + m_noise.normal(1.5)));
    out.vibration_y = static_cast<float>(0.02 + lift * (16 + m_noise.normal(1.5)));
    out.vibration_z = static_cast<float>(0.02 + lift * (24 + m_noise.normal(2)));
    m_outbox.send(out);
}

} // namespace skyseal::sim
