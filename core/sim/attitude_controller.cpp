#include "core/sim/attitude_controller.h"

namespace skyseal::sim {

namespace {

constexpr double kIdle = 0.04;     // rotors never stop in flight
constexpr double kRateGain = 18;   // 1/s, roll and pitch
constexpr double kYawRateGain = 5; // 1/s: yaw has little authority
constexpr double kTrimGain = 12;   // 1/s²
constexpr double kRateLimit = 3.5; // rad/s
// Shares of the thrust that turning may use up. Their sum must leave room between idle and full: kIdle + 2 * sum < 1.
constexpr double kTiltShare = 0.18; // roll and pitch, each
constexpr double kYawShare = 0.1;
static_assert(kIdle + 2 * (2 * kTiltShare + kYawShare) < 1);

double limited(double value, double limit)
{
    return std::clamp(value, -limit, limit);
}

} // namespace

Rotors AttitudeController::update(double dt, const AttitudeDemand &demand, const Attitude &attitude, const Vector3 &rates,
                                  const FlightSettings &settings)
{
    const double follow = std::min(dt / settings.inputLag, 1.0);
    m_target.roll += (demand.roll - m_target.roll) * follow;
    m_target.pitch += (demand.pitch - m_target.pitch) * follow;
    m_target.yaw = demand.yaw;

    const Vector3 error = attitude.errorTo(Attitude::fromEuler(m_target));
    const Vector3 wanted{limited(error.x * settings.anglePRoll, kRateLimit),
                         limited(error.y * settings.anglePPitch, kRateLimit),
                         limited(error.z * settings.anglePYaw + demand.yawRate, kRateLimit)};
    const Vector3 missing = wanted - rates;
    m_trim += missing * (kTrimGain * dt);
    m_trim = {limited(m_trim.x, 5), limited(m_trim.y, 5), limited(m_trim.z, 1)};

    const Vector3 authority = AirframeModel{}.turnAuthority;
    const double roll = limited((missing.x * kRateGain + m_trim.x) / authority.x, kTiltShare);
    const double pitch = limited((missing.y * kRateGain + m_trim.y) / authority.y, kTiltShare);
    const double yaw = limited((missing.z * kYawRateGain + m_trim.z) / authority.z, kYawShare);

    // Keep the differences and reduce the thrust instead: attitude has priority over altitude.
    const double spread = std::abs(roll) + std::abs(pitch) + std::abs(yaw);
    const double base = std::clamp(demand.thrust, kIdle + spread, 1 - spread);
    return {base - roll + pitch + yaw, base + roll - pitch + yaw, base + roll + pitch - yaw, base - roll - pitch - yaw};
}

void AttitudeController::reset(const Euler &angles)
{
    m_target = angles;
    m_trim = {};
}

} // namespace skyseal::sim
