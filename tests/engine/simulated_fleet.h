// A fleet on a simulated machine: two agents with their vehicles and three stations with a client each, whole engines over
// SimulatedNetwork. The stations of two pilots listen; that of an observer calls the agents. Vehicles and clients number their
// messages, so that each of them can be accounted for.
#pragma once

#include "core/engine/agent/agent_core.h"
#include "core/engine/station/snapshot.h"
#include "core/engine/station/station_core.h"
#include "core/mavlink/frame_writer.h"
#include "tests/channel/pair.h"
#include "tests/engine/simulated_network.h"

#include <QtCore/QTemporaryDir>

#include <algorithm>
#include <array>

namespace skyseal::test {

/// Messages of one sender by their numbers, since the last call of begin().
class Numbered
{
public:
    void begin(std::uint32_t next) { m_first = next, m_times.clear(), m_strange = 0; }
    void note(std::uint32_t number);
    /// Messages that arrived; arrived again; and are none of those that were sent.
    std::size_t arrived() const { return m_times.size() - std::size_t(std::ranges::count(m_times, 0)); }
    std::size_t repeated() const
    {
        return std::size_t(std::ranges::count_if(m_times, [](int times) { return times > 1; }));
    }
    std::size_t strange(std::uint32_t next) const { return m_strange + (m_first + m_times.size() > next ? 1 : 0); }

private:
    std::uint32_t m_first = 0;
    std::vector<std::uint8_t> m_times;
    std::size_t m_strange = 0; ///< before the first
};

class SimulatedFleet
{
public:
    static constexpr std::size_t kAgents = 2, kStations = 3, kObserver = 2;
    static constexpr Duration kStep = std::chrono::milliseconds(20);
    /// Of positions of a vehicle; a heartbeat a second is sent besides.
    static constexpr Duration kPositionEvery = std::chrono::milliseconds(200);
    static constexpr Duration kCommandEvery = std::chrono::seconds(2); ///< of each client, to the vehicles in turn

    struct Vehicle
    {
        std::uint8_t systemId = 0;
        Address address, agent;
        mavlink::FrameWriter writer{1, 1};
        std::uint64_t frames = 0;
        std::uint32_t positions = 0;
        TimePoint nextPosition{}, nextHeartbeat{};
        std::array<Numbered, kStations> commands; ///< by the station through which they came
    };
    struct Agent
    {
        std::string ip;
        std::shared_ptr<const crypto::X25519KeyPair> identity;
        MemoryCounterStore counters;
        std::unique_ptr<engine::AgentCore> core;
        std::size_t up = 0, down = 0; ///< sessions of this run
    };
    struct Station
    {
        std::string ip;
        std::shared_ptr<const crypto::X25519KeyPair> identity;
        MemoryCounterStore counters;
        std::unique_ptr<engine::StationCore> core;
        std::shared_ptr<const engine::Snapshot> snapshot;
        // the client of its gateway
        Address client, gateway;
        mavlink::FrameWriter writer{200, 190};
        TimePoint nextHeartbeat{}, nextCommand{};
        std::array<std::uint32_t, kAgents> commands{}; ///< sent, by vehicle
        std::array<Numbered, kAgents> positions;
        std::array<std::uint64_t, kAgents> arrived{}; ///< positions that arrived, by vehicle
    };
    /// Sums over all engines of one kind.
    struct Totals
    {
        std::uint64_t sent = 0, good = 0, lost = 0, refused = 0; ///< records; refused: forged, replayed or malformed
        bool operator==(const Totals &) const = default;
    };

    SimulatedFleet();
    ~SimulatedFleet();

    static TimePoint now();
    /// The list of an agent.
    std::vector<channel::Peer> peersOfAgents() const;
    void startAgent(std::size_t number);
    void startStation(std::size_t number);
    /// Ends it: orderly, or as by kill -9.
    void endAgent(std::size_t number, bool orderly);
    void endStation(std::size_t number, bool orderly);

    void pass(Duration span);
    /// Until the condition is true. Returns false if it is not within the span.
    template<typename Condition> bool passUntil(Duration span, Condition condition)
    {
        for (const TimePoint end = now() + span; now() < end; pass(kStep)) {
            if (condition())
                return true;
        }
        return condition();
    }
    /// Passes a little time until nothing is in the air.
    void quiet();
    /// Whether every station has one session with every agent.
    bool isUp();
    /// Positions of every vehicle reach every client.
    bool flows(Duration within);
    /// Begins a new account of numbered messages.
    void beginAccount();

    Totals agentTotals();
    Totals stationTotals();

    bool traffic = true;
    std::array<Vehicle, kAgents> vehicles;
    std::array<Agent, kAgents> agents;
    std::array<Station, kStations> stations;

private:
    void fly(Vehicle &vehicle);
    void act(std::size_t number, Station &station);
    void takeAtVehicle(Vehicle &vehicle, ByteView frame);
    void takeAtClient(Station &station, ByteView frame);
    template<typename Message> void send(Vehicle &vehicle, const Message &message);
    template<typename Message> void send(Station &station, const Message &message);

    QTemporaryDir m_folder;
};

} // namespace skyseal::test
