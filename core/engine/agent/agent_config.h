// The configuration of an agent.
#pragma once

#include "core/base/path.h"
#include "core/channel/freshness.h"
#include "core/channel/policy.h"
#include "core/link/link_url.h"

namespace skyseal::engine {

struct AgentConfig
{
    link::LinkUrl vehicle;
    link::LinkUrl ground;
    channel::Policy policy;
    /// Clear MAVLink is forwarded while no session is up: the baseline of a measurement.
    bool allowPlain = false;
    /// Carrier of sealed messages on the ground link: datagrams need a link of datagrams, COBS a stream; TUNNEL works on
    /// both.
    Carrier carrier = Carrier::Datagram;
    channel::FreshnessLimits freshness = {}; ///< how late a command may arrive
};

/// The two links of an agent.
inline constexpr LinkId kVehicleLink{1};
inline constexpr LinkId kGroundLink{2};
/// The remote of a ground link that has only one, for clear frames.
inline constexpr Path kGround{kGroundLink, {}};

} // namespace skyseal::engine
