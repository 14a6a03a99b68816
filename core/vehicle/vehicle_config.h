// Settings of a station for its vehicles, and the addresses of both ends.
#pragma once

#include "core/base/clock.h"
#include "core/mavlink/enums.h"

#include <cstdint>

namespace skyseal::vehicle {

/// How much telemetry to request.
enum class StreamProfile : std::uint8_t {
    Standard,     ///< the usual rates of desktop stations
    LowBandwidth, ///< for satellite links and slow radios
    Quiet         ///< request nothing
};

struct VehicleConfig
{
    std::uint8_t ownSystemId = 255;
    std::uint8_t ownComponentId = mavlink::MAV_COMP_ID_MISSIONPLANNER;
    StreamProfile streams = StreamProfile::Standard;
    double streamRate = 0; ///< Hz for every stream group, instead of the profile's rates; 0 = the profile's
    Duration timeSyncEvery = std::chrono::seconds(1);
};

/// Addresses of the station and of the vehicle's autopilot.
struct Addressing
{
    std::uint8_t ownSystem = 255;
    std::uint8_t ownComponent = mavlink::MAV_COMP_ID_MISSIONPLANNER;
    std::uint8_t system = 1;
    std::uint8_t component = mavlink::MAV_COMP_ID_AUTOPILOT1;

    /// True if a message with these targets is addressed to the station; 0 is a broadcast.
    bool isForUs(std::uint8_t targetSystem, std::uint8_t targetComponent) const
    {
        return (targetSystem == 0 || targetSystem == ownSystem) && (targetComponent == 0 || targetComponent == ownComponent);
    }
};

} // namespace skyseal::vehicle
