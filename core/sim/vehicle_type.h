// Type of a simulated vehicle: its kind, and the firmware as which it behaves on MAVLink.
#pragma once

#include "core/mavlink/enums.h"

#include <cstdint>

namespace skyseal::sim {

enum class CraftKind { Copter, Plane, Rover };
enum class Firmware { ArduPilot, Px4 };

struct VehicleType
{
    CraftKind kind = CraftKind::Copter;
    Firmware firmware = Firmware::ArduPilot;

    bool isPx4() const { return firmware == Firmware::Px4; }
    bool isRover() const { return kind == CraftKind::Rover; }
    /// Whether it can stand still in the air.
    bool hovers() const { return kind == CraftKind::Copter; }

    std::uint8_t mavType() const
    {
        switch (kind) {
        case CraftKind::Copter: return mavlink::MAV_TYPE_QUADROTOR;
        case CraftKind::Plane: return mavlink::MAV_TYPE_FIXED_WING;
        case CraftKind::Rover: return mavlink::MAV_TYPE_GROUND_ROVER;
        }
        return mavlink::MAV_TYPE_GENERIC;
    }

    /// "skyseal-sim, flies like ArduCopter 4.5": what it says at power-on.
    const char *greeting() const
    {
        if (isPx4())
            return "skyseal-sim, flies like PX4 1.14";
        switch (kind) {
        case CraftKind::Copter: return "skyseal-sim, flies like ArduCopter 4.5";
        case CraftKind::Plane: return "skyseal-sim, flies like ArduPlane 4.5";
        case CraftKind::Rover: return "skyseal-sim, drives like ArduRover 4.5";
        }
        return "";
    }
};

} // namespace skyseal::sim
