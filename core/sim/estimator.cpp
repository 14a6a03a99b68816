#include "core/sim/estimator.h"

#include "core/mavlink/enums.h"

namespace skyseal::sim {

namespace {

constexpr double kTiltAlignment = 1; // s on the ground until the attitude is trusted
constexpr double kTrustGps = 1;      // s of good fixes until they are used
constexpr double kDeadReckoning = 3; // s without a fix until the position is given up
constexpr double kGlitch = 25;       // m, EK3_GLITCH_RAD: a jump further than this is refused
constexpr double kPersistent = 10;   // s until it is followed

} // namespace

void Estimator::step(double dt, const BodyState &truth, const GpsReport &gps, bool compassFailed)
{
    m_age += dt;
    followGps(dt, gps.fixed);
    if (gps.fixed)
        followGlitch(dt, gps.glitch);
    m_estimate.attitudeOk = m_age >= kTiltAlignment;

    const Vector3 offset{m_north.step(m_noise, dt), m_east.step(m_noise, dt), m_down.step(m_noise, dt)};
    const Vector3 slip{m_northSpeed.step(m_noise, dt), m_eastSpeed.step(m_noise, dt), m_downSpeed.step(m_noise, dt)};
    const Euler tilt{m_roll.step(m_noise, dt), m_pitch.step(m_noise, dt), m_yaw.step(m_noise, dt)};

    m_estimate.attitude = truth.attitude.turned({tilt.roll, tilt.pitch, tilt.yaw}, 1);
    m_estimate.rates = truth.rates + Vector3{m_noise.normal(0.002), m_noise.normal(0.002), m_noise.normal(0.002)};
    // Standing still is recognised: velocities settle at nothing while the vehicle is on the ground.
    const double moving = truth.onGround ? 0.2 : 1.0;
    const Vector3 position = truth.position + offset + m_glitch;
    const Vector3 velocity = truth.velocity + slip * moving;
    m_estimate.position.z = truth.position.z + offset.z; // by the air pressure
    m_estimate.velocity.z = velocity.z;
    if (m_estimate.positionOk) {
        m_estimate.position.x = position.x;
        m_estimate.position.y = position.y;
        m_estimate.velocity = velocity;
    } else { // constant position mode
        m_estimate.velocity.x = m_estimate.velocity.y = 0;
    }

    const double activity = truth.onGround ? 0.3 : 1.0;
    const double stale = std::min(m_withoutFix, 10.0) * 0.3;
    m_variances = {0.04 * activity + slip.length() * 0.5 + stale,
                   0.03 * activity + std::hypot(offset.x, offset.y) * 0.15 + stale + m_glitchDistance / kGlitch,
                   0.02 * activity + std::abs(offset.z) * 0.15, 0.02 + std::abs(tilt.yaw) * 3 + (compassFailed ? 1 : 0)};
}

void Estimator::followGlitch(double dt, const Vector3 &glitch)
{
    m_glitchDistance = (glitch - m_glitch).horizontal();
    m_glitchingFor = m_glitchDistance > kGlitch ? m_glitchingFor + dt : 0;
    if (m_glitchDistance > kGlitch && m_glitchingFor < kPersistent)
        return;
    m_glitch = {glitch.x, glitch.y, 0};
    m_glitchDistance = m_glitchingFor = 0;
}

void Estimator::followGps(double dt, bool fixed)
{
    m_withFix = fixed ? m_withFix + dt : 0;
    m_withoutFix = fixed ? 0 : m_withoutFix + dt;
    if (m_withFix >= kTrustGps && m_age >= kTiltAlignment)
        m_estimate.positionOk = true;
    else if (m_withoutFix >= kDeadReckoning)
        m_estimate.positionOk = false;
}

std::uint16_t Estimator::flags() const
{
    if (!m_estimate.attitudeOk)
        return mavlink::EKF_UNINITIALIZED;
    using namespace mavlink;
    const int vertical = EKF_ATTITUDE | EKF_VELOCITY_VERT | EKF_POS_VERT_ABS;
    const int horizontal = m_estimate.positionOk
        ? EKF_VELOCITY_HORIZ | EKF_POS_HORIZ_REL | EKF_POS_HORIZ_ABS | EKF_PRED_POS_HORIZ_REL | EKF_PRED_POS_HORIZ_ABS
        : EKF_CONST_POS_MODE;
    return static_cast<std::uint16_t>(vertical | horizontal | (m_glitchingFor > 0 ? int(EKF_GPS_GLITCHING) : 0));
}

} // namespace skyseal::sim
