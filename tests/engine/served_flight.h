// A sealed flight whose station is a gateway: other ground stations are its clients.
#pragma once

#include "core/engine/gateway/gateway.h"
#include "core/engine/station/snapshot.h"
#include "core/mavlink/enums.h"
#include "tests/engine/ground.h"

#include <memory>
#include <string>

namespace skyseal::test {

/// As of skyseal-cli gateway.
inline engine::StationConfig gatewayConfig(const FlightRig &rig)
{
    engine::StationConfig config = rig.stationConfig();
    config.ownHeartbeat = false;
    config.componentId = mavlink::MAV_COMP_ID_UDP_BRIDGE;
    return config;
}

/// A vehicle behind an agent, and a gateway with one link for clients.
struct ServedFlight
{
    explicit ServedFlight(const std::string &options, channel::PeerRole role = channel::PeerRole::Pilot,
                          const std::string &url = "udpin:127.0.0.1:0")
        : rig(role), ground(gatewayConfig(rig))
    {
        ground.station->serve({*engine::ServeConfig::parse(url + options)});
        rig.startAgent(ground.ears->listening());
        if (!eventually([this] { return ground.up() && isOpen(); }))
            qFatal("no session");
    }
    bool isOpen() const
    {
        const auto changes = ground.ears->all<engine::ServedLinkChanged>();
        return !changes.empty()
            && (changes.back().link.phase == engine::LinkPhase::Listening
                || changes.back().link.phase == engine::LinkPhase::Connected);
    }
    /// Of the link for clients.
    quint16 port() const { return portOf(ground.ears->all<engine::ServedLinkChanged>().back().link.localAddress); }
    /// Starts the vehicle and waits until the station has it.
    VehicleOnUdp &fly()
    {
        vehicle = std::make_unique<VehicleOnUdp>(rig.vehicleAddress());
        if (!eventually([this] { return !ground.ears->snapshot->vehicles.empty(); }))
            qFatal("no vehicle");
        return *vehicle;
    }
    engine::ClientSnapshot client() const
    {
        return ground.ears->snapshot->clients.empty() ? engine::ClientSnapshot() : ground.ears->snapshot->clients[0];
    }

    FlightRig rig;
    Ground ground;
    std::unique_ptr<VehicleOnUdp> vehicle;
};

} // namespace skyseal::test
