#include "core/sim/fixed_wing.h"

#include "core/sim/wire_units.h"

#include <utility>

namespace skyseal::sim {

namespace {

// A model aeroplane of two metres.
constexpr double kLiftOff = 12;           // m/s
constexpr double kLeavingGround = 1;      // m/s, the climb with which it lifts off
constexpr double kSlowest = 10;           // m/s
constexpr double kGroundAcceleration = 4; // m/s²
constexpr double kBraking = 3;            // m/s², rolling out
constexpr double kSpeedChange = 2;        // m/s², in the air
constexpr double kLevelBelow = 12;        // m: near the ground the wings stay level
constexpr double kRollLag = 0.4;          // s
constexpr double kClimbLag = 1;           // s
constexpr double kAttack = radians(2);    // of the wing in level flight

} // namespace

FixedWing::FixedWing(const BodyState &start) : m_state(start), m_heading(start.attitude.euler().yaw) {}

double FixedWing::takeImpact()
{
    return std::exchange(m_impact, 0);
}

void FixedWing::step(double dt, bool armed, const FlightDemand &demand, const Estimate &estimate,
                     const FlightSettings &settings, const Surroundings &around)
{
    m_idle = !armed || demand.idle || (m_state.onGround && demand.touchdown);
    if (m_state.onGround)
        rollAlongGround(dt, settings);
    else
        fly(dt, demand, estimate, settings, around.wind);
}

void FixedWing::rollAlongGround(double dt, const FlightSettings &settings)
{
    m_throttle = m_idle ? 0 : 1;
    m_airspeed = m_idle ? std::max(m_airspeed - kBraking * dt, 0.0)
                        : std::min(m_airspeed + kGroundAcceleration * dt, settings.speed);
    m_roll = m_climb = 0;
    m_wanted = {0, 0, m_heading};
    m_state.velocity = {m_airspeed * std::cos(m_heading), m_airspeed * std::sin(m_heading), 0};
    m_state.position += m_state.velocity * dt;
    m_state.position.z = 0;
    m_state.onGround = m_idle || m_airspeed < kLiftOff;
    if (!m_state.onGround)
        m_climb = kLeavingGround;
    setAttitude(dt, 0);
}

double FixedWing::courseAround(const HoldPosition &place, const Vector3 &position, double radius)
{
    const double north = position.x - place.north, east = position.y - place.east;
    const double outside = (std::hypot(north, east) - radius) / std::max(radius, 1.0);
    return std::atan2(east, north) + kPi / 2 + std::atan(2 * outside);
}

double FixedWing::wantedRoll(const FlightDemand &demand, const Estimate &estimate, const FlightSettings &settings) const
{
    if (const auto *lean = std::get_if<Lean>(&demand.horizontal))
        return lean->roll;
    const bool low = -m_state.position.z < kLevelBelow;
    if (low && (demand.touchdown || m_climb > 0))
        return 0; // straight ahead after lift-off and before touch-down
    double course;
    if (const auto *place = std::get_if<HoldPosition>(&demand.horizontal))
        course = courseAround(*place, estimate.position, settings.loiterRadius);
    else
        course = std::atan2(std::get<Velocity>(demand.horizontal).east, std::get<Velocity>(demand.horizontal).north);
    const double way = std::atan2(m_state.velocity.y, m_state.velocity.x);
    const double turnRate = wrapPi(course - way);
    return std::clamp(std::atan(m_airspeed * turnRate / kGravity), -settings.leanLimit, settings.leanLimit);
}

double FixedWing::wantedClimb(const FlightDemand &demand, const Estimate &estimate, const FlightSettings &settings) const
{
    if (const auto *height = std::get_if<HoldAltitude>(&demand.vertical))
        return std::clamp((height->altitude - estimate.altitude()) * 0.4, -height->descent, height->climb);
    if (const auto *climb = std::get_if<Climb>(&demand.vertical))
        return std::clamp(climb->rate, -settings.descent, settings.climb);
    const double pitch = std::holds_alternative<Lean>(demand.horizontal) ? std::get<Lean>(demand.horizontal).pitch : 0;
    return m_airspeed * std::sin(pitch);
}

void FixedWing::fly(double dt, const FlightDemand &demand, const Estimate &estimate, const FlightSettings &settings,
                    const Vector3 &wind)
{
    double speed = settings.speed;
    if (const auto *place = std::get_if<HoldPosition>(&demand.horizontal))
        speed = place->speed;
    if (const auto *thrust = std::get_if<Thrust>(&demand.vertical))
        speed = settings.speed * (0.6 + 0.8 * (thrust->share - settings.hoverThrottle));
    if (m_idle || (demand.touchdown && -m_state.position.z < kLevelBelow))
        speed = kSlowest; // engine off: gliding descent
    m_airspeed += std::clamp(std::max(speed, kSlowest) - m_airspeed, -kSpeedChange * dt, kSpeedChange * dt);

    const double roll = m_idle ? 0 : wantedRoll(demand, estimate, settings);
    const double climb = m_idle ? -2.5 : wantedClimb(demand, estimate, settings);
    m_roll += (roll - m_roll) * std::min(dt / kRollLag, 1.0);
    m_climb += (climb - m_climb) * std::min(dt / kClimbLag, 1.0);
    m_throttle = m_idle ? 0 : std::clamp(settings.hoverThrottle + 0.12 * m_climb, 0.0, 1.0);
    m_wanted = {roll, std::asin(std::clamp(climb / m_airspeed, -0.5, 0.5)), m_heading};

    const double turnRate = kGravity * std::tan(m_roll) / m_airspeed;
    m_heading = wrapPi(m_heading + turnRate * dt);
    m_state.velocity = Vector3{m_airspeed * std::cos(m_heading), m_airspeed * std::sin(m_heading), -m_climb}
        + Vector3{wind.x, wind.y, 0};
    m_state.position += m_state.velocity * dt;
    setAttitude(dt, turnRate);
    if (m_state.position.z > 0) {
        m_impact = std::max(m_impact, m_state.velocity.z);
        m_state.position.z = 0;
        m_state.onGround = true;
    }
}

void FixedWing::setAttitude(double dt, double turnRate)
{
    const Euler before = m_state.attitude.euler();
    const double pitch = m_state.onGround ? 0 : std::asin(std::clamp(m_climb / m_airspeed, -0.5, 0.5)) + kAttack;
    m_state.attitude = Attitude::fromEuler({m_roll, pitch, m_heading});
    m_state.rates = {(m_roll - before.roll) / dt, turnRate * std::sin(m_roll) + (pitch - before.pitch) / dt,
                     turnRate * std::cos(m_roll)};
    m_state.specificForce = {0, 0, -kGravity / std::cos(m_roll)};
}

Craft::Signals FixedWing::signals(bool armed, const Parameters &) const
{
    return {scaled<std::uint16_t>(1500 + 500 * m_wanted.roll), scaled<std::uint16_t>(1500 + 500 * m_wanted.pitch),
            scaled<std::uint16_t>(armed ? 1000 + 1000 * m_throttle : 1000), 1500};
}

} // namespace skyseal::sim
