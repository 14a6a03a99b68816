// The topics, relative to the prefix of the broker's URL.
#pragma once

#include <cstdint>
#include <string>

namespace skyseal::mqtt {

/// "online" or "offline"; the broker publishes the latter when the gateway has gone without a word.
inline constexpr const char *kGatewayState = "gateway/state";
/// Events that concern no vehicle, or none that is known.
inline constexpr const char *kGatewayEvent = "gateway/event";

inline std::string vehicleTopic(std::uint8_t systemId, const char *kind)
{
    return "vehicle/" + std::to_string(systemId) + '/' + kind;
}
inline std::string vehicleState(std::uint8_t systemId)
{
    return vehicleTopic(systemId, "state");
}
inline std::string vehicleEvent(std::uint8_t systemId)
{
    return vehicleTopic(systemId, "event");
}
inline std::string vehicleMavlink(std::uint8_t systemId)
{
    return vehicleTopic(systemId, "mavlink");
}

} // namespace skyseal::mqtt
