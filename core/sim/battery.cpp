#include "core/sim/battery.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace skyseal::sim {

namespace {

constexpr double kAvionics = 0.45;    // A: flight controller, receiver, radio
constexpr double kIdleRotors = 0.8;   // A: four rotors turning without lift
constexpr double kFullThrust = 62;    // A at full thrust; power grows with thrust to the 1.5, by momentum theory
constexpr double kResistance = 0.024; // ohm, cells and leads
constexpr double kSettling = 0.4;     // s, polarisation of the cells: voltage follows the load with this lag

// Rest voltage of three lithium-polymer cells by state of charge: the flat middle and the knee at the end.
struct Point
{
    double charge, voltage;
};
constexpr std::array<Point, 9> kRest{{{0.0, 9.6},
                                      {0.05, 10.6},
                                      {0.1, 10.98},
                                      {0.2, 11.22},
                                      {0.4, 11.4},
                                      {0.6, 11.61},
                                      {0.8, 11.98},
                                      {0.95, 12.42},
                                      {1.0, 12.6}}};

} // namespace

void Battery::replace(double capacity, double charge)
{
    m_capacity = std::max(capacity, 1.0);
    m_consumed = m_capacity * (1 - std::clamp(charge, 0.0, 1.0));
    m_energy = 0;
    m_voltage = restVoltage();
}

void Battery::setRestVoltage(double voltage)
{
    const auto above = std::find_if(kRest.begin() + 1, kRest.end() - 1, [&](const Point &p) { return p.voltage >= voltage; });
    const Point &low = *(above - 1);
    const double share = std::clamp((voltage - low.voltage) / (above->voltage - low.voltage), 0.0, 1.0);
    m_consumed = m_capacity * (1 - (low.charge + (above->charge - low.charge) * share));
}

void Battery::step(double dt, double thrust, bool armed)
{
    m_current = kAvionics + (armed ? kIdleRotors : 0) + kFullThrust * std::pow(std::clamp(thrust, 0.0, 1.0), 1.5);
    m_consumed += m_current * dt / 3.6;
    m_energy += m_voltage * m_current * dt;
    const double loaded = std::max(restVoltage() - m_current * kResistance, 6.0);
    m_voltage += (loaded - m_voltage) * std::min(dt / kSettling, 1.0);
}

double Battery::percent() const
{
    return std::clamp(100 * (1 - m_consumed / m_capacity), 0.0, 100.0);
}

double Battery::restVoltage() const
{
    const double charge = std::clamp(1 - m_consumed / m_capacity, 0.0, 1.0);
    const auto above = std::find_if(kRest.begin() + 1, kRest.end() - 1, [&](const Point &p) { return p.charge >= charge; });
    const Point &low = *(above - 1);
    return low.voltage + (above->voltage - low.voltage) * (charge - low.charge) / (above->charge - low.charge);
}

} // namespace skyseal::sim
