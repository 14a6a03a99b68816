// Seeded randomness of the simulated world. Own generator, because std::normal_distribution gives other numbers with
// another standard library, and two runs with one seed must be equal everywhere.
#pragma once

#include <cmath>
#include <cstdint>

namespace skyseal::sim {

/// Independent random numbers (SplitMix64), one object per cause of noise, so that reading one sensor more often does not
/// change the wind.
class Noise
{
public:
    Noise(std::uint64_t seed, std::uint64_t cause) : m_state(seed * 0x9e3779b97f4a7c15u ^ (cause + 1) * 0xd1342543de82ef95u)
    {
        next();
    }

    std::uint64_t next()
    {
        std::uint64_t z = (m_state += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    /// Uniform in [0, 1).
    double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }

    /// Nearly normal with the given deviation, never beyond 3.5 of them: four 16-bit uniforms out of one draw.
    double normal(double deviation)
    {
        const std::uint64_t bits = next();
        const auto sum = static_cast<double>((bits & 0xffff) + (bits >> 16 & 0xffff) + (bits >> 32 & 0xffff) + (bits >> 48));
        return deviation * (sum / 65535 - 2) * 1.7320508075688772;
    }

private:
    std::uint64_t m_state;
};

/// A value that wanders about zero (Ornstein-Uhlenbeck): gusts, GPS and barometer drift.
class Drift
{
public:
    /// `deviation` in the long run; `timeConstant` in seconds.
    Drift(double deviation, double timeConstant) : m_deviation(deviation), m_timeConstant(timeConstant) {}

    double value() const { return m_value; }
    double step(Noise &noise, double dt)
    {
        m_value += -m_value * dt / m_timeConstant + noise.normal(m_deviation * std::sqrt(2 * dt / m_timeConstant));
        return m_value;
    }

private:
    double m_deviation;
    double m_timeConstant;
    double m_value = 0;
};

} // namespace skyseal::sim
