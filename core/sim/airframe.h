// A quadcopter in X shape as a rigid body: four rotors with lag, thrust, drag against moving air, gravity, and a flat
// ground that it can stand on, land on and hit.
#pragma once

#include "core/sim/attitude.h"

#include <array>

namespace skyseal::sim {

inline constexpr double kGravity = 9.80665;

/// Rotors in ArduPilot's order for a quad X: front right, back left (both turn counter-clockwise), front left, back right.
using Rotors = std::array<double, 4>;

/// A 1.5 kg quadcopter of half a metre, which hovers at about a third of its thrust.
struct AirframeModel
{
    double hoverThrust = 0.34;           ///< share of the full thrust that carries the weight
    double rotorLag = 0.035;             ///< s
    Vector3 turnAuthority{120, 120, 14}; ///< rad/s² at full differential thrust, body axes
    Vector3 rateDamping{1.2, 1.2, 0.4};  ///< 1/s
    double linearDrag = 0.05;            ///< 1/s, against air-relative speed
    double quadraticDrag = 0.012;        ///< 1/m
};

/// The true physical state, which sensors measure with errors.
struct BodyState
{
    Vector3 position; ///< m, NED; the ground is z = 0
    Vector3 velocity; ///< m/s, NED
    Attitude attitude;
    Vector3 rates;                          ///< rad/s, body axes
    Vector3 specificForce{0, 0, -kGravity}; ///< m/s², body axes: what an accelerometer feels
    Rotors rotors{};                        ///< thrust of each, share of its maximum
    bool onGround = true;
};

class Airframe
{
public:
    explicit Airframe(const AirframeModel &model, const BodyState &start) : m_model(model), m_state(start) {}

    const AirframeModel &model() const { return m_model; }
    const BodyState &state() const { return m_state; }

    /// Advances by `dt` seconds (designed for 2.5 ms). `commands` in [0, 1] per rotor; `supply` scales the thrust as the
    /// battery's voltage does; `wind` in m/s NED; `turbulence` in rad/s², body axes.
    void step(double dt, const Rotors &commands, double supply, const Vector3 &wind, const Vector3 &turbulence);

    /// Speed (m/s) of the last touch-down since the last call; 0 if there was none.
    double takeImpact();

private:
    void meetGround();

    AirframeModel m_model;
    BodyState m_state;
    double m_impact = 0;
};

} // namespace skyseal::sim
