#include "core/sim/multirotor.h"

#include "core/sim/parameters.h"
#include "core/sim/wire_units.h"

namespace skyseal::sim {

namespace {

std::uint16_t pulse(double thrust, const Parameters &parameters)
{
    // Thrust grows about with the square of the signal; MOT_THST_EXPO is the exact curve.
    const double expo = std::max(static_cast<double>(parameters.value("MOT_THST_EXPO")), 0.01);
    const double linear = (expo - 1 + std::sqrt((1 - expo) * (1 - expo) + 4 * expo * std::clamp(thrust, 0.0, 1.0)))
        / (2 * expo);
    const auto low = static_cast<double>(parameters.value("MOT_SPIN_MIN")),
               high = static_cast<double>(parameters.value("MOT_SPIN_MAX"));
    return scaled<std::uint16_t>(1000 + 1000 * (low + (high - low) * linear));
}

} // namespace

void Multirotor::step(double dt, bool armed, const FlightDemand &demand, const Estimate &estimate,
                      const FlightSettings &settings, const Surroundings &around)
{
    m_control.update(dt, armed, demand, estimate, settings);
    Rotors turning = m_control.commands();
    for (std::size_t i = 0; i < turning.size(); ++i) {
        if (settings.faults.weakRotors >> i & 1)
            turning[i] *= settings.faults.rotorShare;
    }
    m_airframe.step(dt, turning, around.supply, around.wind, around.turbulence);
}

double Multirotor::load() const
{
    const Rotors &rotors = state().rotors;
    return (rotors[0] + rotors[1] + rotors[2] + rotors[3]) / 4;
}

Craft::Signals Multirotor::signals(bool armed, const Parameters &parameters) const
{
    Signals out;
    for (std::size_t i = 0; i < out.size(); ++i) {
        if (!armed)
            out[i] = 1000;
        else if (throttle() <= 0)
            out[i] = scaled<std::uint16_t>(1000 + 1000 * static_cast<double>(parameters.value("MOT_SPIN_ARM")));
        else
            out[i] = pulse(m_control.commands()[i], parameters);
    }
    return out;
}

} // namespace skyseal::sim
