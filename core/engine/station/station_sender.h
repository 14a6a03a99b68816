// Sends the station's MAVLink: the outgoing frames of the vehicle objects, heartbeats, and a datagram by which routers learn
// the station's address. Frames are sent over the session of their route, or in clear. I/O thread.
#pragma once

#include "core/engine/common/ingress.h"
#include "core/engine/common/link_pool.h"
#include "core/engine/common/sender_policy.h"
#include "core/engine/station/recorder.h"
#include "core/engine/station/route_table.h"
#include "core/engine/station/station_channel.h"
#include "core/vehicle/gcs_heartbeat.h"
#include "core/vehicle/vehicle.h"

#include <memory>

namespace skyseal::engine {

class StationSender
{
public:
    /// `links` and `ingress` must outlive this object. `self`: the system and component that frames carry.
    StationSender(Node self, LinkPool &links, const Ingress &ingress) : m_self(self), m_links(links), m_ingress(ingress) {}

    /// The channel, null without keys; it must outlive this object. `sealing`: sessions are in use.
    void setChannel(StationChannel *channel, bool sealing);
    void setSealing(bool sealing) { m_sealing = sealing; }
    /// Null when nothing is recorded.
    void setRecorder(Recorder *recorder) { m_recorder = recorder; }
    /// While false no heartbeat is sent: vehicles act on its absence, so it must not be sent on behalf of an operator
    /// whose window hangs.
    void setReaderAlive(bool alive) { m_readerAlive = alive; }

    RouteTable &routes() { return m_routes; }
    /// Makes a remote that the operator named in the URL of a link a target, or removes the targets of a link that is down.
    void followLink(const link::Link &link, bool mayBeClear);

    /// Sends the outgoing frames of a vehicle object; without a route they are dropped. Returns true if a session took them.
    bool sendOutgoing(TimePoint now, std::uint8_t systemId, vehicle::Vehicle &vehicle);
    /// Sends a frame of the gateway's clients, unchanged: to a system, or for 0 to every route where a heartbeat is allowed.
    void forward(TimePoint now, std::uint8_t systemId, ByteView frame, const SenderPolicy &policy);
    /// Sends the heartbeat to every route where it is allowed, if it is due: in MAVLink 1 where a vehicle speaks that, since
    /// readers of version 2 understand it as well, and otherwise in MAVLink 2, also where no vehicle was heard yet. An
    /// autopilot that knows version 1 alone sends its heartbeats without being asked, and is answered in version 1 from then
    /// on, while many that know both speak version 1 until they hear version 2 (FirmwareInfo).
    void sendHeartbeats(TimePoint now, const SenderPolicy &policy);
    TimePoint nextHeartbeat() const { return m_heartbeat.nextDeadline(); }
    /// Sends an empty TUNNEL message on every datagram client link without a session.
    void greetRouters();

private:
    bool mayHeartbeat(const Route &route, const SenderPolicy &policy) const;
    void send(TimePoint now, Route &route, const vehicle::OutMessage &message, int version);
    void transmit(TimePoint now, const Route &route, ByteView frame);

    const Node m_self;
    LinkPool &m_links;
    const Ingress &m_ingress;
    StationChannel *m_channel = nullptr;
    bool m_sealing = false;
    Recorder *m_recorder = nullptr;
    bool m_readerAlive = true;
    RouteTable m_routes;
    vehicle::GcsHeartbeat m_heartbeat;
};

} // namespace skyseal::engine
