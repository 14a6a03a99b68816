// The agent's engine: exchanges plain MAVLink with an unmodified autopilot and sealed records with ground stations, and
// forwards whole frames in both directions unchanged. It adds no messages to the autopilot's link: when the sealed link fails,
// the autopilot receives no station any more, and its failsafe acts.
//
// Lives on one thread with an event loop.
#pragma once

#include "core/engine/agent/agent_receiver.h"
#include "core/engine/agent/agent_snapshot.h"
#include "core/engine/common/channel_driver.h"
#include "core/engine/common/deadline_timer.h"
#include "core/engine/common/ingress.h"
#include "core/engine/common/link_pool.h"
#include "core/engine/common/pairing_driver.h"
#include "core/engine/common/secret_files.h"
#include "core/metrics/process_usage.h"

#include <functional>
#include <memory>

namespace skyseal::engine {

class VehicleSigning;

/// Reason why the pairing window was not opened.
enum class PairingRefusal : std::uint8_t { Armed, OpenAlready };

class AgentCore : private link::LinkListener, private AgentReceiver::EventHandler
{
public:
    using Notify = std::function<void(const AgentEvent &)>;

    AgentCore(AgentConfig config, std::unique_ptr<SecretFiles> secrets, Notify notify);
    /// `signing`: of the vehicle's side; null without a key.
    AgentCore(AgentConfig config, std::unique_ptr<SecretFiles> secrets, Notify notify, std::unique_ptr<VehicleSigning> signing);
    ~AgentCore() override;

    /// Opens the links.
    void start();
    /// Replaces the list of stations that may connect; sessions of keys that are not listed end at once.
    void setPeers(std::vector<channel::Peer> peers);
    /// Replaces the suites and framings that are offered; sessions whose suite is not among them switch to another.
    void setPolicy(channel::Policy policy);
    /// Opens the window in which a new station can be paired, until the pairing is over or a vehicle is armed. Its progress
    /// is reported by events. `name` is the agent's own. With `passphrase` only a station with the same one is shown; null
    /// without one. A vehicle without a heartbeat so far does not count as armed; a silent one keeps its last state.
    Result<void, PairingRefusal> openPairing(std::string name, std::shared_ptr<const crypto::Passphrase> passphrase = {});
    void confirmPairing(const channel::PublicKey &key);
    void refusePairing();
    void cancelPairing();
    const channel::PublicKey &publicKey() const;
    /// Whether a vehicle with this system id sends heartbeats.
    bool isVehicle(std::uint8_t systemId) const { return m_receiver.isVehicle(systemId); }
    /// Sends Close to every station and closes the links.
    void stop();
    /// Call about once a second: rates and load cover the time since the last call, and refused frames are published.
    AgentSnapshot snapshot();

private:
    std::optional<channel::FreshnessReport> latestCommands();
    void linkReceived(link::Link &link, std::span<const link::ReceivedBlock> blocks) override;
    void linkPeerJoined(link::Link &link, const Path &path) override;
    void linkPeerLeft(link::Link &link, const Path &path) override;
    void linkChanged(link::Link &link);

    void handleEvents(std::optional<channel::SessionId> speaking) override;
    void handleDeadline();
    void finishWake();

    AgentConfig m_config;
    std::unique_ptr<SecretFiles> m_secrets;
    std::unique_ptr<VehicleSigning> m_signing; ///< may be null
    AgentEvents m_events;
    std::vector<Path> m_places; ///< targets of the announcements; a named host has an address once it was resolved
    LinkPool m_links;
    Ingress m_ingress;
    ChannelDriver m_channel;
    PairingDriver m_pairing;
    NodeHeartbeat m_node;
    AgentReceiver m_receiver;
    StorageWatch m_storage;
    metrics::CpuSampler m_cpu;
    bool m_stopped = false;
    DeadlineTimer m_timer;
};

} // namespace skyseal::engine
