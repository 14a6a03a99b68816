// The agent's treatment of received messages: frames of the vehicle are sent to the sessions, records of the ground are opened,
// and CommandGate judges their frames before they are sent to the vehicle. Reads no files and no clock; I/O thread.
#pragma once

#include "core/engine/agent/agent_config.h"
#include "core/engine/agent/agent_event.h"
#include "core/engine/agent/agent_snapshot.h"
#include "core/engine/agent/armed_vehicles.h"
#include "core/engine/agent/clear_frame_coalescer.h"
#include "core/engine/agent/command_gate.h"
#include "core/engine/agent/ground_id_claims.h"
#include "core/engine/agent/ground_sessions.h"
#include "core/engine/agent/node_heartbeat.h"
#include "core/engine/agent/vehicle_routes.h"
#include "core/engine/common/channel_driver.h"
#include "core/engine/common/event_publisher.h"
#include "core/engine/common/ingress.h"
#include "core/engine/common/pairing_driver.h"
#include "core/metrics/sequence_table.h"

#include <optional>

namespace skyseal::engine {

class VehicleSigning;

using AgentEvents = EventPublisher<AgentEvent, AgentCauses>;

class AgentReceiver final : private IngressSink
{
public:
    /// Handles the events of the channel, except the end of the session `speaking` and later ones.
    class EventHandler
    {
    public:
        virtual ~EventHandler() = default;
        virtual void handleEvents(std::optional<channel::SessionId> speaking) = 0;
    };
    /// The parts that a receiver works on; all must outlive it.
    struct Parts
    {
        const AgentConfig &config;
        LinkPool &links;
        Ingress &ingress;
        ChannelDriver &channel;
        PairingDriver &pairing;
        NodeHeartbeat &node;
        AgentEvents &events;
        EventHandler &handler;
        VehicleSigning *signing = nullptr; ///< null without a key
    };

    explicit AgentReceiver(const Parts &parts);

    /// Registers the links with the ingress; call before they open.
    void addLinks();
    void setPeers(const std::vector<channel::Peer> &peers) { m_gate.setPeers(peers); }
    /// Call when the policy has changed: the classification of blocks on the ground links depends on it.
    void updateRules();
    /// The vehicle's link has one remote, so frames for any system go there.
    void fixVehicle(const Path &path) { m_routes.setFixed(path); }
    /// A stream begins or ends.
    void streamChanged(const Path &path);
    void sessionUp(const channel::SessionUp &up);
    void sessionDown(channel::SessionId session);
    /// Sends the clear frames of this wake-up.
    void flush() { m_clear.flush(); }
    /// Call about once a second: routes of silent vehicles end.
    void forgetSilent(TimePoint now) { m_routes.forgetSilent(now); }

    bool isVehicle(std::uint8_t systemId) const { return m_routes.isVehicle(systemId); }
    /// The system id of the vehicle if there is exactly one, otherwise 0.
    std::uint8_t onlySystem() const { return m_routes.onlySystem(); }
    bool isAnyArmed() const { return m_armed.any(); }
    /// The refusals since the last call.
    std::vector<FramesRefused> takeRefused() { return m_gate.takeRefused(); }
    AgentCounters counters() const;
    bool mayCommand(channel::SessionId session) const { return m_gate.mayCommand(session); }
    const metrics::SequenceTable &fromVehicle() const { return m_fromVehicle; }

private:
    /// Receives the frames of the vehicle's link.
    class VehicleSink final : public IngressSink
    {
    public:
        explicit VehicleSink(AgentReceiver &receiver) : m_receiver(receiver) {}
        void takeClear(const link::Link &, const link::ReceivedBlock &block, const mavlink::ScanItem &item) override
        {
            m_receiver.takeFromVehicle(block.time, block.path, item);
        }

    private:
        AgentReceiver &m_receiver;
    };

    bool takePairing(const link::Link &link, const link::ReceivedBlock &message) override;
    bool namesSession(ByteView message) const override;
    bool takeRecord(const link::Link &link, const link::ReceivedBlock &message) override;
    void takeSealedInPlace(const link::Link &link, const link::ReceivedBlock &frame) override;
    void takeClear(const link::Link &link, const link::ReceivedBlock &block, const mavlink::ScanItem &item) override;
    void takeUnusable(const link::Link &link, Unusable what) override;

    void takeFromVehicle(TimePoint now, const Path &from, const mavlink::ScanItem &item);
    bool takeSignature(TimePoint now, const Path &from, ByteView frame);
    bool takeVehicleHeartbeat(TimePoint now, const Path &from, const mavlink::Frame &heartbeat);
    void takeDelivery(const link::ReceivedBlock &block, const channel::Delivery &delivery);
    void sendToVehicle(const mavlink::ScanItem &item, ByteView bytes);
    void signToVehicle(const mavlink::ScanItem &item, bool mayCommand);
    bool isPlain() const { return m_parts.config.allowPlain && m_sessions.none(); }
    IngressRules groundRules(const GroundLink &ground) const;

    const Parts m_parts;
    VehicleSink m_vehicleSink{*this};
    CommandGate m_gate;
    GroundSessions m_sessions;
    ClearFrameCoalescer m_clear; ///< to the ground
    VehicleRoutes m_routes;
    GroundIdClaims m_groundIdClaims;
    ArmedVehicles m_armed;
    metrics::SequenceTable m_fromVehicle;
    AgentCounters m_counters; ///< without the frames refused by the gate
};

} // namespace skyseal::engine
