// Type of a simulated vehicle: its kind, and the firmware as which it behaves on MAVLink.
#pragma once

#include "core/mavlink/enums.h"

#include <cstdint>

namespace skyseal::sim {

enum class VehicleKind { Copter, Plane, Rover };
enum class Firmware { ArduPilot, Px4 };

struct VehicleType
{
    VehicleKind kind = VehicleKind::Copter;
    Firmware firmware = Firmware::ArduPilot;

    bool isPx4() const { return firmware == Firmware::Px4; }
    bool isRover() const { return kind == VehicleKind::Rover; }
    /// Whether it can stand still in the air.
    bool hovers() const { return kind == VehicleKind::Copter; }

    std::uint8_t mavType() const
    {
        switch (kind) {
        case VehicleKind::Copter: return mavlink::MAV_TYPE_QUADROTOR;
        case VehicleKind::Plane: return mavlink::MAV_TYPE_FIXED_WING;
        case VehicleKind::Rover: return mavlink::MAV_TYPE_GROUND_ROVER;
        }
        return mavlink::MAV_TYPE_GENERIC;
    }

    /// "skyseal-sim, flies like ArduCopter 4.5": what it says at power-on.
    const char *greeting() const
    {
        if (isPx4())
            return "skyseal-sim, flies like PX4 1.14";
        switch (kind) {
        case VehicleKind::Copter: return "skyseal-sim, flies like ArduCopter 4.5";
        case VehicleKind::Plane: return "skyseal-sim, flies like ArduPlane 4.5";
        case VehicleKind::Rover: return "skyseal-sim, drives like ArduRover 4.5";
        }
        return "";
    }
};

} // namespace skyseal::sim
