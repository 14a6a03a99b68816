#include "core/sim/flight_physics.h"

#include "core/sim/fixed_wing.h"
#include "core/sim/ground_vehicle.h"
#include "core/sim/multirotor.h"

namespace skyseal::sim {

namespace {

BodyState standing(double heading)
{
    BodyState state;
    state.attitude = Attitude::fromEuler({0, 0, wrapPi(radians(heading))});
    return state;
}

std::unique_ptr<Craft> makeCraft(const VehicleType &type, double heading)
{
    switch (type.kind) {
    case CraftKind::Copter: break;
    case CraftKind::Plane: return std::make_unique<FixedWing>(standing(heading));
    case CraftKind::Rover: return std::make_unique<GroundVehicle>(standing(heading));
    }
    return std::make_unique<Multirotor>(standing(heading));
}

} // namespace

FlightPhysics::FlightPhysics(const VehicleType &type, std::uint64_t seed, double heading, double firstFix)
    : m_wind(seed), m_craft(makeCraft(type, heading)), m_gps(seed, firstFix), m_estimator(seed)
{}

void FlightPhysics::step(double dt, std::uint64_t time, const FlightSettings &settings, const FlightDemand &demand, bool armed)
{
    m_wind.step(dt, settings.windSpeed, settings.windFrom);
    const Faults &faults = settings.faults;
    if (faults.restVoltage != m_restVoltage)
        m_battery.setRestVoltage(m_restVoltage = faults.restVoltage);
    m_craft->step(dt, armed, demand, estimate(), settings, {m_battery.supply(), m_wind.velocity(), m_wind.torque()});
    m_battery.step(dt, m_craft->load(), armed);
    m_gps.step(dt, time, truth(), faults);
    m_estimator.step(dt, truth(), gps(), faults.compassFailed);
}

} // namespace skyseal::sim
