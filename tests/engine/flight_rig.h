// A whole flight in one process over real sockets of 127.0.0.1: a simulated vehicle on UDP, an agent, and files with keys
// that know each other. All live on the caller's thread and its event loop; ports are chosen by the system.
#pragma once

#include "core/engine/agent/agent_core.h"
#include "core/engine/station/station.h"
#include "core/sim/simulated_vehicle.h"
#include "tests/support/addresses.h"

#include <QtCore/QTemporaryDir>
#include <QtCore/QTimer>

#include <memory>
#include <string>
#include <vector>

namespace skyseal::test {

/// A vehicle that sends to one address, as a simulator started with udpout does.
class VehicleOnUdp : private link::LinkListener
{
public:
    VehicleOnUdp(const std::string &target, std::uint8_t systemId = 1);

    sim::SimulatedVehicle vehicle;
    std::uint64_t sent = 0; ///< frames

private:
    void linkReceived(link::Link &link, std::span<const link::ReceivedBlock> blocks) override;
    void advance();

    std::unique_ptr<link::Link> m_link;
    QTimer m_timer;
};

class FlightRig
{
public:
    /// `stationRole`: rights of the station at the agent; `pinned`: system ids that the station binds to the agent's key;
    /// `stationSystems`: system ids that the agent binds to the station's key.
    explicit FlightRig(channel::PeerRole stationRole = channel::PeerRole::Pilot, std::vector<std::uint8_t> pinned = {},
                       std::vector<std::uint8_t> stationSystems = {});
    ~FlightRig();

    engine::StationConfig stationConfig(engine::SecureMode mode = engine::SecureMode::Required) const;
    /// A fresh agent, as after a restart of its program, that announces itself to `ground` ("127.0.0.1:port").
    void startAgent(const std::string &ground) { startAgentAt({ground}); }
    /// The same with a ground link to each address.
    void startAgentAt(const std::vector<std::string> &grounds);
    /// The same with any links.
    void startAgentOn(const std::vector<link::LinkUrl> &grounds);
    /// Pairs another station with the agents that start from now on. Returns its configuration.
    engine::StationConfig addStation(const std::string &name, channel::PeerRole role);
    /// The agent's list.
    std::vector<channel::Peer> peersOfAgent() const;
    /// Whether agents that start from now on know the station's key.
    void introduceStation(bool known);
    /// Like kill -9: no close message is sent.
    void killAgent() { agent.reset(); }
    std::string vehicleAddress(); ///< where a vehicle sends to

    std::unique_ptr<engine::AgentCore> agent;
    std::vector<engine::AgentEvent> agentEvents;
    std::unique_ptr<engine::VehicleSigning> signing; ///< of the agent that starts next; null: none
    bool allowPlain = false;                         ///< of agents that start from now on
    Carrier carrier = Carrier::Datagram;             ///< of those too

private:
    std::string file(const std::string &name) const { return m_folder.filePath(QString::fromStdString(name)).toStdString(); }
    engine::StationConfig configOf(const std::string &station, engine::SecureMode mode) const;

    QTemporaryDir m_folder;
    crypto::PublicKey m_groundKey{}, m_airKey{};
    channel::PeerRole m_stationRole;
    std::vector<std::uint8_t> m_stationSystems;
    std::string m_vehiclePort = "0"; ///< kept over restarts
};

/// Collects the output of a station.
class StationEars
{
public:
    explicit StationEars(engine::Station &station);

    template<typename E> std::vector<E> all() const
    {
        std::vector<E> out;
        for (const engine::Event &event : events) {
            if (const E *e = std::get_if<E>(&event))
                out.push_back(*e);
        }
        return out;
    }
    /// Address on which the station listens; empty before.
    std::string listening() const;

    std::vector<engine::Event> events;
    std::shared_ptr<const engine::Snapshot> snapshot = std::make_shared<engine::Snapshot>();

private:
    QObject m_context;
};

} // namespace skyseal::test
