#include "core/sim/ground_vehicle.h"

#include "core/sim/wire_units.h"

namespace skyseal::sim {

namespace {

constexpr double kAcceleration = 2;  // m/s²
constexpr double kSlowInTurns = 0.2; // share of the speed when the place lies beside or behind

} // namespace

GroundVehicle::GroundVehicle(const BodyState &start) : m_state(start), m_heading(start.attitude.euler().yaw)
{
    m_state.onGround = true;
}

GroundVehicle::Motion GroundVehicle::towards(double north, double east, double speed, const FlightSettings &settings) const
{
    const double error = wrapPi(std::atan2(east, north) - m_heading);
    return {speed * std::max(std::cos(error), kSlowInTurns),
            std::clamp(2.5 * error, -settings.pilotYawRate, settings.pilotYawRate)};
}

GroundVehicle::Motion GroundVehicle::wanted(const FlightDemand &demand, const Estimate &estimate,
                                            const FlightSettings &settings) const
{
    if (const auto *place = std::get_if<HoldPosition>(&demand.horizontal)) {
        const double north = place->north - estimate.position.x, east = place->east - estimate.position.y;
        const double way = std::hypot(north, east);
        if (way < settings.waypointRadius / 2)
            return {};
        return towards(north, east, std::min(place->speed, std::sqrt(kAcceleration * way)), settings);
    }
    if (const auto *velocity = std::get_if<Velocity>(&demand.horizontal)) {
        const double speed = std::hypot(velocity->north, velocity->east);
        return speed < 0.05 ? Motion{} : towards(velocity->north, velocity->east, std::min(speed, settings.speed), settings);
    }
    // The pilot's sticks: the middle of the throttle stands still, below it backs up.
    const double share = std::holds_alternative<Thrust>(demand.vertical) ? std::get<Thrust>(demand.vertical).share : 0.5;
    const double steering = std::get<Lean>(demand.horizontal).roll / std::max(settings.leanLimit, 0.01);
    return {2 * (share - 0.5) * settings.speed, steering * settings.pilotYawRate};
}

void GroundVehicle::step(double dt, bool armed, const FlightDemand &demand, const Estimate &estimate,
                         const FlightSettings &settings, const Surroundings &)
{
    m_idle = !armed || demand.idle;
    const Motion motion = m_idle ? Motion{} : wanted(demand, estimate, settings);
    const double before = m_speed;
    m_speed += std::clamp(motion.speed - m_speed, -kAcceleration * dt, kAcceleration * dt);
    // Wheels steer only while they roll.
    m_turnRate = motion.turnRate * std::min(std::abs(m_speed) / 0.3, 1.0) * (m_speed < 0 ? -1 : 1);
    m_throttle = std::clamp(std::abs(m_speed) / std::max(settings.speed * 2, 0.1), 0.0, 1.0);
    m_heading = wrapPi(m_heading + m_turnRate * dt);
    m_state.velocity = {m_speed * std::cos(m_heading), m_speed * std::sin(m_heading), 0};
    m_state.position += m_state.velocity * dt;
    m_state.position.z = 0;
    m_state.attitude = Attitude::fromEuler({0, 0, m_heading});
    m_state.rates = {0, 0, m_turnRate};
    m_state.specificForce = {(m_speed - before) / dt, m_speed * m_turnRate, -kGravity};
}

Craft::Signals GroundVehicle::signals(bool armed, const Parameters &) const
{
    const double forward = m_speed < 0 ? -m_throttle : m_throttle;
    return {scaled<std::uint16_t>(1500 + 250 * m_turnRate), 0, scaled<std::uint16_t>(armed ? 1500 + 500 * forward : 1500), 0};
}

} // namespace skyseal::sim
