// Demand of a flight mode, which the position controller turns into an attitude and a thrust.
#pragma once

#include "core/sim/vector3.h"

#include <variant>

namespace skyseal::sim {

/// Fly to, and stay over, a place.
struct HoldPosition
{
    double north = 0; ///< m from the origin
    double east = 0;
    double speed = 5; ///< m/s at most
};
/// Move over ground at a velocity, m/s.
struct Velocity
{
    double north = 0;
    double east = 0;
};
/// The pilot's own angles, rad.
struct Lean
{
    double roll = 0;
    double pitch = 0;
};
using Horizontal = std::variant<Lean, Velocity, HoldPosition>;

/// Reach and hold a height over the origin, m, with the limits in m/s.
struct HoldAltitude
{
    double altitude = 0;
    double climb = 2.5;
    double descent = 1.5;
};
/// Climb (m/s, positive up).
struct Climb
{
    double rate = 0;
};
/// The pilot's own thrust, [0, 1].
struct Thrust
{
    double share = 0;
};
using Vertical = std::variant<Thrust, Climb, HoldAltitude>;

/// Turn to a heading (rad) at no more than `rate` rad/s; 0 means as the parameter says.
struct Heading
{
    double yaw = 0;
    double rate = 0;
};
/// Turn at a rate (rad/s).
struct Turn
{
    double rate = 0;
};
using Yaw = std::variant<Turn, Heading>;

struct FlightDemand
{
    Horizontal horizontal = Lean{};
    Vertical vertical = Thrust{};
    Yaw yaw = Turn{};
    bool touchdown = false; ///< it means to land here
    bool idle = false;      ///< rotors turn without lift: on the ground, before take-off and after landing
};

} // namespace skyseal::sim
