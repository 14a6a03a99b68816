#include "core/sim/flight_physics.h"

namespace skyseal::sim {

namespace {

BodyState standing(double heading)
{
    BodyState state;
    state.attitude = Attitude::fromEuler({0, 0, wrapPi(radians(heading))});
    return state;
}

} // namespace

FlightPhysics::FlightPhysics(std::uint64_t seed, double heading, double firstFix)
    : m_wind(seed), m_airframe(AirframeModel{}, standing(heading)), m_gps(seed, firstFix), m_estimator(seed)
{}

void FlightPhysics::step(double dt, std::uint64_t time, const FlightSettings &settings, const Rotors &commands, bool armed)
{
    m_wind.step(dt, settings.windSpeed, settings.windFrom);
    const Faults &faults = settings.faults;
    if (faults.restVoltage != m_restVoltage)
        m_battery.setRestVoltage(m_restVoltage = faults.restVoltage);
    Rotors turning = commands;
    for (std::size_t i = 0; i < turning.size(); ++i) {
        if (faults.weakRotors >> i & 1)
            turning[i] *= faults.rotorShare;
    }
    m_airframe.step(dt, turning, m_battery.supply(), m_wind.velocity(), m_wind.torque());
    const Rotors &rotors = truth().rotors;
    m_battery.step(dt, (rotors[0] + rotors[1] + rotors[2] + rotors[3]) / 4, armed);
    m_gps.step(dt, time, truth(), faults);
    m_estimator.step(dt, truth(), gps(), faults.compassFailed);
}

} // namespace skyseal::sim
