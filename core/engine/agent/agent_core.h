// The agent's engine: stands beside an autopilot that knows nothing of sealing, exchanges plain MAVLink with it and sealed
// records with the ground, and forwards whole frames both ways unchanged. It adds nothing of its own: when the sealed link
// fails the autopilot receives no station any more, and its own failsafe acts.
//
// Lives on one thread with an event loop.
#pragma once

#include "core/channel/freshness.h"
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
#include "core/engine/common/deadline_timer.h"
#include "core/engine/common/ingress.h"
#include "core/engine/common/link_pool.h"
#include "core/engine/common/pairing_driver.h"
#include "core/engine/common/secret_files.h"
#include "core/metrics/process_usage.h"
#include "core/metrics/sequence_table.h"

#include <functional>
#include <memory>

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

/// Why the window for pairing was not opened.
enum class PairingRefusal : std::uint8_t { Armed, OpenAlready };

class AgentCore : private link::LinkListener, private IngressSink
{
public:
    using Notify = std::function<void(const AgentEvent &)>;

    AgentCore(AgentConfig config, std::unique_ptr<SecretFiles> secrets, Notify notify);
    ~AgentCore() override;

    /// Opens the links.
    void start();
    /// Replaces the list of stations that may connect; sessions of keys that are not in it end at once.
    void setPeers(std::vector<channel::Peer> peers);
    /// Opens the window in which a new station can be paired, until the pairing is over or a vehicle is armed. Its progress
    /// comes as events. `name` is the agent's own. With `passphrase` only a station with the same one is shown; null without
    /// one. A vehicle that was never heard does not count as armed, one that fell silent counts as what it was last.
    Result<void, PairingRefusal> openPairing(std::string name, std::shared_ptr<const crypto::Passphrase> passphrase = {});
    void confirmPairing(const channel::PublicKey &key);
    void refusePairing();
    void cancelPairing();
    const channel::PublicKey &publicKey() const;
    /// Whether a vehicle with this system id is heard.
    bool isVehicle(std::uint8_t systemId) const { return m_routes.isVehicle(systemId); }
    /// Says goodbye to every station and closes the links.
    void stop();
    /// Call about once a second: rates and load cover the time since the last call, and refused frames are published.
    AgentSnapshot snapshot();

private:
    /// Receives the frames of the vehicle's link.
    struct VehicleSink final : IngressSink
    {
        explicit VehicleSink(AgentCore &agent) : m_agent(agent) {}
        void takeClear(const link::Link &, const link::ReceivedBlock &block, const mavlink::ScanItem &item) override
        {
            m_agent.takeFromVehicle(block.time, block.path, item);
        }
        AgentCore &m_agent;
    };

    struct Measurements
    {
        metrics::SequenceTable fromVehicle;
        metrics::CpuSampler cpu;
        AgentCounters counters; ///< without the frames that m_gate refused
    };

    void linkReceived(link::Link &link, std::span<const link::ReceivedBlock> blocks) override;
    void linkPeerJoined(link::Link &link, const Path &path) override;
    void linkPeerLeft(link::Link &link, const Path &path) override;
    void linkChanged(link::Link &link);
    IngressRules groundRules() const;

    void takeFromVehicle(TimePoint now, const Path &from, const mavlink::ScanItem &item);
    bool takeVehicleHeartbeat(TimePoint now, const Path &from, const mavlink::Frame &heartbeat);
    bool takePairing(const link::Link &link, const link::ReceivedBlock &message) override;
    bool namesSession(ByteView message) const override;
    void takeRecord(const link::Link &link, const link::ReceivedBlock &message) override;
    void takeSealedInPlace(const link::Link &link, const link::ReceivedBlock &frame) override;
    void takeClear(const link::Link &link, const link::ReceivedBlock &block, const mavlink::ScanItem &item) override;
    void takeUnusable(const link::Link &link, Unusable what) override;
    void takeDelivery(const link::ReceivedBlock &block, const channel::Delivery &delivery);
    void sendToVehicle(const mavlink::ScanItem &item);
    bool isPlain() const { return m_config.allowPlain && m_sessions.none(); }

    void handleEvents(std::optional<channel::SessionId> speaking = {});
    void handleDeadline();
    void finishWake();

    AgentConfig m_config;
    std::unique_ptr<SecretFiles> m_secrets;
    EventPublisher<AgentEvent, AgentCauses> m_events;
    Path m_ground; ///< where stations are looked for; the address is known once a name was resolved
    LinkPool m_links;
    Ingress m_ingress;
    VehicleSink m_vehicleSink;
    ChannelDriver m_channel;
    PairingDriver m_pairing;
    CommandGate m_gate;
    GroundSessions m_sessions;
    ClearFrameCoalescer m_clear; ///< to the ground
    VehicleRoutes m_routes;
    GroundIdClaims m_groundIdClaims;
    StorageWatch m_storage;
    ArmedVehicles m_armed;
    NodeHeartbeat m_node;
    Measurements m_measured;
    bool m_stopped = false;
    DeadlineTimer m_timer;
};

} // namespace skyseal::engine
