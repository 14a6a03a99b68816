#include "core/sim/position_controller.h"

namespace skyseal::sim {

namespace {

constexpr double kJerk = 5;               // m/s³
constexpr double kVerticalJerk = 5;       // m/s³
constexpr double kFollow = 2.5;           // 1/s: how briskly the shaped velocity closes in
constexpr double kTurnAcceleration = 0.8; // rad/s²
constexpr double kPatience = 0.35;        // the integral compensates wind, not the lag of the lean angle
constexpr double kPushLimit = 4;          // m/s²

/// Speed at which a target `distance` away can be approached so that it is met at rest: proportional near by, and never
/// faster than the deceleration allows (the square-root controller of ArduPilot's AC_AttitudeControl).
double approach(double distance, double gain, double deceleration)
{
    const double linear = deceleration / (gain * gain);
    const double size = std::abs(distance);
    const double speed = size <= linear ? size * gain : std::sqrt(2 * deceleration * (size - linear / 2));
    return std::copysign(speed, distance);
}

/// Steps `value` towards `wanted` by no more than `limit`.
void slew(double &value, double wanted, double limit)
{
    value += std::clamp(wanted - value, -limit, limit);
}

} // namespace

void ShapedVelocity::reset(const Vector3 &velocity)
{
    m_velocity = velocity;
    m_acceleration = {};
}

void ShapedVelocity::step(double dt, const Vector3 &wanted, double acceleration, double verticalAcceleration)
{
    Vector3 pull = (wanted - m_velocity) * kFollow;
    pull = pull.horizontalLimited(acceleration);
    slew(m_acceleration.x, pull.x, kJerk * dt);
    slew(m_acceleration.y, pull.y, kJerk * dt);
    slew(m_acceleration.z, std::clamp(pull.z, -verticalAcceleration, verticalAcceleration), kVerticalJerk * dt);
    m_velocity += m_acceleration * dt;
}

AttitudeDemand PositionController::update(double dt, const FlightDemand &demand, const Estimate &estimate,
                                          const FlightSettings &settings)
{
    steer(dt, demand.yaw, estimate, settings);
    const bool manual = std::holds_alternative<Lean>(demand.horizontal);
    const bool manualThrust = std::holds_alternative<Thrust>(demand.vertical);

    m_shaped.step(dt, wantedVelocity(demand, estimate, settings), settings.acceleration, settings.verticalAcceleration);
    const Vector3 error = m_shaped.velocity() - estimate.velocity;
    m_push += Vector3{error.x * settings.velocityI * kPatience, error.y * settings.velocityI * kPatience,
                      error.z * settings.climbP * 0.4}
        * dt;
    m_push = m_push.horizontalLimited(kPushLimit);
    m_push.z = std::clamp(m_push.z, -kPushLimit, kPushLimit);
    const Vector3 acceleration = m_shaped.acceleration() + m_push
        + Vector3{error.x * settings.velocityP, error.y * settings.velocityP, error.z * settings.climbP};

    AttitudeDemand out;
    out.yaw = m_heading;
    out.yawRate = m_turnRate;
    if (manual) {
        out.roll = std::get<Lean>(demand.horizontal).roll;
        out.pitch = std::get<Lean>(demand.horizontal).pitch;
    } else {
        const double yaw = estimate.attitude.euler().yaw;
        const Vector3 level = Vector3{acceleration.x, acceleration.y, 0}.horizontalLimited(kGravity
                                                                                           * std::tan(settings.leanLimit));
        const double forward = level.x * std::cos(yaw) + level.y * std::sin(yaw);
        const double right = level.y * std::cos(yaw) - level.x * std::sin(yaw);
        out.pitch = -std::atan2(forward, kGravity);
        out.roll = std::atan2(right * std::cos(out.pitch), kGravity);
    }
    if (manualThrust)
        out.thrust = std::get<Thrust>(demand.vertical).share;
    else
        out.thrust = settings.hoverThrottle * std::max(1 - acceleration.z / kGravity, 0.1)
            / std::max(estimate.attitude.cosTilt(), 0.5);
    return out;
}

Vector3 PositionController::wantedVelocity(const FlightDemand &demand, const Estimate &estimate,
                                           const FlightSettings &settings) const
{
    Vector3 wanted = estimate.velocity; // uncontrolled axes follow the estimate, so that control starts without a jump
    if (const auto *place = std::get_if<HoldPosition>(&demand.horizontal)) {
        const Vector3 way{place->north - estimate.position.x, place->east - estimate.position.y, 0};
        const double distance = way.horizontal();
        const double speed = std::min(approach(distance, settings.positionP, settings.acceleration * 0.5), place->speed);
        wanted.x = distance > 1e-6 ? way.x / distance * speed : 0;
        wanted.y = distance > 1e-6 ? way.y / distance * speed : 0;
    } else if (const auto *velocity = std::get_if<Velocity>(&demand.horizontal)) {
        wanted.x = velocity->north;
        wanted.y = velocity->east;
    }
    if (const auto *hold = std::get_if<HoldAltitude>(&demand.vertical)) {
        const double rate = approach(hold->altitude - estimate.altitude(), settings.altitudeP,
                                     settings.verticalAcceleration * 0.5);
        wanted.z = -std::clamp(rate, -hold->descent, hold->climb);
    } else if (const auto *climb = std::get_if<Climb>(&demand.vertical)) {
        wanted.z = -climb->rate;
    }
    return wanted;
}

void PositionController::steer(double dt, const Yaw &yaw, const Estimate &estimate, const FlightSettings &settings)
{
    double wanted = 0;
    if (const auto *turn = std::get_if<Turn>(&yaw)) {
        wanted = turn->rate;
    } else {
        const auto &heading = std::get<Heading>(yaw);
        const double limit = heading.rate > 0 ? heading.rate : settings.yawSlew;
        wanted = std::clamp(approach(wrapPi(heading.yaw - m_heading), 2, kTurnAcceleration * 0.7), -limit, limit);
    }
    slew(m_turnRate, wanted, kTurnAcceleration * dt);
    // The target may not run away from a vehicle that cannot turn as fast.
    const double lead = wrapPi(m_heading + m_turnRate * dt - estimate.attitude.euler().yaw);
    m_heading = wrapPi(estimate.attitude.euler().yaw + std::clamp(lead, -0.5, 0.5));
}

void PositionController::reset(const Estimate &estimate)
{
    m_shaped.reset(estimate.velocity);
    m_push = {};
    m_heading = estimate.attitude.euler().yaw;
    m_turnRate = 0;
}

} // namespace skyseal::sim
