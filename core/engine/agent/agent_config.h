// The configuration of an agent.
#pragma once

#include "core/base/path.h"
#include "core/channel/freshness.h"
#include "core/channel/policy.h"
#include "core/link/link_url.h"

#include <vector>

namespace skyseal::engine {

/// A link to ground stations.
struct GroundLink
{
    link::LinkUrl url;
    /// Carrier of sealed messages: Datagram requires a datagram link, Serial (COBS) a stream; Tunnel works on both.
    Carrier carrier = Carrier::Datagram;

    bool operator==(const GroundLink &) const = default;
};

struct AgentConfig
{
    link::LinkUrl vehicle;
    std::vector<GroundLink> grounds; ///< one to kMostGrounds: several stations, or several modems to one
    channel::Policy policy;
    /// Clear MAVLink is forwarded while no session is up: the baseline of a measurement.
    bool allowPlain = false;
    channel::FreshnessLimits freshness = {}; ///< limits of the delay of a command
};

inline constexpr std::size_t kMostGrounds = 8;

inline constexpr LinkId kVehicleLink{1};
/// The id of a ground link, by its index in AgentConfig::grounds.
constexpr LinkId groundLink(std::size_t index)
{
    return LinkId{2 + static_cast<std::uint32_t>(index)};
}
/// The index of a ground link; only for links other than the vehicle's.
constexpr std::size_t groundIndex(LinkId link)
{
    return static_cast<std::size_t>(link) - 2;
}

} // namespace skyseal::engine
