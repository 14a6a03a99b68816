// How a station wants to treat its vehicles, and who talks to whom.
#pragma once

#include "core/base/clock.h"

#include <cstdint>

namespace skyseal::vehicle {

/// How much telemetry to ask for.
enum class StreamProfile : std::uint8_t {
    Standard,     ///< what desktop stations are used to
    LowBandwidth, ///< for satellite links and slow radios
    Quiet         ///< ask for nothing, take what comes
};

struct VehicleConfig
{
    std::uint8_t ownSystemId = 255;
    std::uint8_t ownComponentId = 190;
    StreamProfile streams = StreamProfile::Standard;
    double streamRate = 0; ///< Hz for every stream group, instead of the profile's rates; 0 = the profile's
    Duration timeSyncEvery = std::chrono::seconds(1);
};

/// Both ends of the conversation with one vehicle.
struct Addressing
{
    std::uint8_t ownSystem = 255;
    std::uint8_t ownComponent = 190;
    std::uint8_t system = 1;
    std::uint8_t component = 1;

    /// Whether a message with these targets is meant for us; 0 is a broadcast.
    bool isForUs(std::uint8_t targetSystem, std::uint8_t targetComponent) const
    {
        return (targetSystem == 0 || targetSystem == ownSystem) && (targetComponent == 0 || targetComponent == ownComponent);
    }
};

} // namespace skyseal::vehicle
