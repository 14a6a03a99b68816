#include "tests/engine/simulated_fleet.h"

#include "core/mavlink/enums.h"
#include "core/mavlink/frame_intake.h"
#include "core/mavlink/messages.h"
#include "tests/fuzz/simulated_host.h"

#include <QtCore/QCoreApplication>

#include <algorithm>

namespace skyseal::test {

using namespace std::chrono_literals;

namespace {

/// Counters of handshakes that outlive an engine, as in a file.
class KeptCounters final : public channel::CounterStore
{
public:
    explicit KeptCounters(channel::CounterStore &kept) : m_kept(kept) {}
    std::optional<std::uint64_t> next() override { return m_kept.next(); }
    bool skipTo(std::uint64_t counter) override { return m_kept.skipTo(counter); }
    std::uint64_t lastSeen(const channel::PublicKey &peer) override { return m_kept.lastSeen(peer); }
    bool remember(const channel::PublicKey &peer, std::uint64_t counter) override { return m_kept.remember(peer, counter); }

private:
    channel::CounterStore &m_kept;
};

channel::Policy policy()
{
    return {channel::defaultSuites(), true, false};
}

std::string ending(std::size_t number)
{
    return std::to_string(number);
}

SimulatedNetwork &network()
{
    return SimulatedNetwork::instance();
}

void add(SimulatedFleet::Totals &sum, const engine::ChannelTotals &more)
{
    sum.sent += more.tx.records;
    sum.good += more.rx.good;
    sum.lost += more.rx.lost;
    sum.refused += more.rx.forged + more.rx.replayed + more.rx.malformed;
}

} // namespace

void Numbered::note(std::uint32_t number)
{
    if (number < m_first) {
        ++m_strange;
        return;
    }
    if (m_times.size() <= number - m_first)
        m_times.resize(number - m_first + 1);
    ++m_times[number - m_first];
}

SimulatedFleet::SimulatedFleet()
{
    SimulatedHost::instance().reset();
    for (std::size_t i = 0; i < kAgents; ++i) {
        agents[i].ip = "10.0.0.1" + ending(i);
        agents[i].identity = newIdentity(10 + i);
        Vehicle &vehicle = vehicles[i];
        vehicle.systemId = static_cast<std::uint8_t>(1 + i);
        vehicle.writer = mavlink::FrameWriter(vehicle.systemId, 1);
        vehicle.address = SimulatedNetwork::address("127.0.0.1:2000" + ending(i));
        vehicle.agent = SimulatedNetwork::address("127.0.0.1:2100" + ending(i));
        network().bind(vehicle.address, [this, &vehicle](const Address &, ByteView frame) { takeAtVehicle(vehicle, frame); });
    }
    for (std::size_t i = 0; i < kStations; ++i) {
        Station &station = stations[i];
        station.ip = "10.0.0.2" + ending(i);
        station.identity = newIdentity(20 + i);
        station.writer = mavlink::FrameWriter(static_cast<std::uint8_t>(200 + i), 190);
        station.client = SimulatedNetwork::address("127.0.0.1:2200" + ending(i));
        network().bind(station.client, [this, &station](const Address &from, ByteView frame) {
            station.gateway = from;
            takeAtClient(station, frame);
        });
    }
    for (std::size_t i = 0; i < kAgents; ++i)
        startAgent(i);
    for (std::size_t i = 0; i < kStations; ++i)
        startStation(i);
}

SimulatedFleet::~SimulatedFleet() = default;

TimePoint SimulatedFleet::now()
{
    return SimulatedHost::instance().now();
}

std::vector<channel::Peer> SimulatedFleet::peersOfAgents() const
{
    std::vector<channel::Peer> out;
    for (std::size_t i = 0; i < kStations; ++i) {
        const auto role = i == kObserver ? channel::PeerRole::Observer : channel::PeerRole::Pilot;
        out.push_back({publicKeyOf(*stations[i].identity), "station " + ending(i), role, {}});
    }
    return out;
}

void SimulatedFleet::startAgent(std::size_t number)
{
    Agent &agent = agents[number];
    auto secrets = std::make_unique<engine::SecretFiles>();
    secrets->identity = agent.identity;
    secrets->counters = std::make_unique<KeptCounters>(agent.counters);
    secrets->peers = peersOfAgents();
    engine::AgentConfig config{
        .vehicle = SimulatedNetwork::url("udpin:127.0.0.1:2100" + ending(number)), .grounds = {}, .policy = policy()};
    for (const char *url : {"udpout:10.0.0.20:14550", "udpout:10.0.0.21:14550"})
        config.grounds.push_back({SimulatedNetwork::url(url)});
    config.grounds.push_back({SimulatedNetwork::url("udpin:" + agent.ip + ":14556")});
    agent.up = agent.down = 0;
    network().setHost(agent.ip);
    agent.core = std::make_unique<engine::AgentCore>(
        std::move(config), std::move(secrets), [&agent](const engine::AgentEvent &event) {
            if (const auto *channelEvent = std::get_if<channel::Event>(&event)) {
                agent.up += std::holds_alternative<channel::SessionUp>(*channelEvent);
                agent.down += std::holds_alternative<channel::SessionDown>(*channelEvent);
            }
        });
    agent.core->start();
}

void SimulatedFleet::startStation(std::size_t number)
{
    Station &station = stations[number];
    auto secrets = std::make_unique<engine::SecretFiles>();
    secrets->paths.peers = m_folder.filePath(QStringLiteral("peers")).toStdString() + ending(number);
    secrets->identity = station.identity;
    secrets->counters = std::make_unique<KeptCounters>(station.counters);
    for (std::size_t i = 0; i < kAgents; ++i)
        secrets->peers.push_back(
            {publicKeyOf(*agents[i].identity), "air " + ending(i), channel::PeerRole::Pilot, {vehicles[i].systemId}});
    engine::StationConfig config;
    config.systemId = static_cast<std::uint8_t>(255 - number);
    config.secure = engine::SecureMode::Required;
    config.policy = policy();
    config.record = false;
    engine::StationSinks sinks;
    sinks.snapshot = [&station](const std::shared_ptr<const engine::Snapshot> &snapshot) { station.snapshot = snapshot; };
    sinks.event = [](const engine::Event &) {};
    sinks.probed = sinks.snapshot;
    network().setHost(station.ip);
    station.core = std::make_unique<engine::StationCore>(std::move(config), std::move(secrets), std::move(sinks));
    if (number == kObserver) {
        for (std::size_t i = 0; i < kAgents; ++i)
            station.core->addLink(LinkId{static_cast<std::uint32_t>(1 + i)},
                                  SimulatedNetwork::url("udpout:" + agents[i].ip + ":14556"));
    } else {
        station.core->addLink(LinkId{1}, SimulatedNetwork::url("udpin:" + station.ip + ":14550"));
    }
    station.core->serve(
        {{.url = SimulatedNetwork::url("udpout:127.0.0.1:2200" + ending(number)), .write = engine::WriteRights::all()}});
}

void SimulatedFleet::endAgent(std::size_t number, bool orderly)
{
    if (orderly)
        agents[number].core->stop();
    agents[number].core.reset();
}

void SimulatedFleet::endStation(std::size_t number, bool orderly)
{
    Station &station = stations[number];
    if (orderly)
        station.core->stop();
    station.core.reset();
    station.snapshot.reset();
    station.gateway = {};
}

void SimulatedFleet::pass(Duration span)
{
    for (const TimePoint end = now() + span; now() < end;) {
        network().deliver();
        if (traffic) {
            for (Vehicle &vehicle : vehicles)
                fly(vehicle);
            for (std::size_t i = 0; i < kStations; ++i)
                act(i, stations[i]);
            network().deliver();
        }
        const auto second = std::chrono::floor<std::chrono::seconds>(now());
        SimulatedHost::instance().advance(kStep);
        if (std::chrono::floor<std::chrono::seconds>(now()) == second)
            continue;
        QCoreApplication::sendPostedEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // closed links
        for (Agent &agent : agents) {
            if (agent.core)
                agent.core->snapshot(); // as its program does for the report
        }
    }
}

void SimulatedFleet::quiet()
{
    for (int i = 0; i < 1000 && !network().isQuiet(); ++i) {
        SimulatedHost::instance().advance(1ms);
        network().deliver();
    }
}

bool SimulatedFleet::isUp()
{
    return std::ranges::all_of(agents, [](Agent &agent) { return agent.core->snapshot().channel.sessions == kStations; })
        && std::ranges::all_of(
               stations, [](Station &station) { return station.snapshot && station.snapshot->sessions.size() == kAgents; });
}

bool SimulatedFleet::flows(Duration within)
{
    std::array<std::array<std::uint64_t, kAgents>, kStations> before;
    for (std::size_t i = 0; i < kStations; ++i)
        before[i] = stations[i].arrived;
    return passUntil(within, [&] {
        for (std::size_t i = 0; i < kStations; ++i) {
            for (std::size_t j = 0; j < kAgents; ++j) {
                if (stations[i].arrived[j] < before[i][j] + 5)
                    return false;
            }
        }
        return isUp();
    });
}

void SimulatedFleet::beginAccount()
{
    for (std::size_t i = 0; i < kStations; ++i) {
        for (std::size_t j = 0; j < kAgents; ++j) {
            stations[i].positions[j].begin(vehicles[j].positions);
            vehicles[j].commands[i].begin(stations[i].commands[j]);
        }
    }
}

SimulatedFleet::Totals SimulatedFleet::agentTotals()
{
    Totals out;
    for (Agent &agent : agents)
        add(out, agent.core->snapshot().channel);
    return out;
}

SimulatedFleet::Totals SimulatedFleet::stationTotals()
{
    Totals out;
    for (Station &station : stations) {
        station.core->requestProbe(); // a snapshot of this moment
        add(out, station.snapshot->channel);
    }
    return out;
}

void SimulatedFleet::fly(Vehicle &vehicle)
{
    if (now() >= vehicle.nextHeartbeat) {
        vehicle.nextHeartbeat = now() + 1s;
        send(vehicle,
             mavlink::Heartbeat{.type = mavlink::MAV_TYPE_QUADROTOR, .autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA});
    }
    if (now() >= vehicle.nextPosition) {
        vehicle.nextPosition = now() + kPositionEvery;
        send(vehicle, mavlink::GlobalPositionInt{.time_boot_ms = vehicle.positions++, .lat = 1, .lon = 1});
    }
}

/// The client of a station.
void SimulatedFleet::act(std::size_t number, Station &station)
{
    if (station.gateway == Address{})
        return;
    if (now() >= station.nextHeartbeat) {
        station.nextHeartbeat = now() + 1s;
        send(station, mavlink::Heartbeat{.type = mavlink::MAV_TYPE_GCS, .autopilot = mavlink::MAV_AUTOPILOT_INVALID});
    }
    if (now() >= station.nextCommand) {
        station.nextCommand = now() + kCommandEvery;
        const std::size_t target = (station.commands[0] + station.commands[1]) % kAgents;
        mavlink::CommandInt command;
        command.target_system = vehicles[target].systemId;
        command.target_component = 1;
        command.command = mavlink::MAV_CMD_DO_CHANGE_SPEED;
        command.x = static_cast<std::int32_t>(station.commands[target]++);
        command.y = static_cast<std::int32_t>(number);
        send(station, command);
    }
}

void SimulatedFleet::takeAtVehicle(Vehicle &vehicle, ByteView frame)
{
    const auto read = mavlink::readFrame(frame, mavlink::Dialect::builtin());
    if (!read || read->messageId() != mavlink::CommandInt::kId)
        return;
    const auto command = mavlink::CommandInt::decode(read->payload());
    if (command.command == mavlink::MAV_CMD_DO_CHANGE_SPEED)
        vehicle.commands.at(static_cast<std::size_t>(command.y)).note(static_cast<std::uint32_t>(command.x));
}

void SimulatedFleet::takeAtClient(Station &station, ByteView frame)
{
    const auto read = mavlink::readFrame(frame, mavlink::Dialect::builtin());
    if (!read || read->messageId() != mavlink::GlobalPositionInt::kId)
        return;
    const std::size_t vehicle = read->systemId() - 1u;
    ++station.arrived.at(vehicle);
    station.positions.at(vehicle).note(mavlink::GlobalPositionInt::decode(read->payload()).time_boot_ms);
}

template<typename Message> void SimulatedFleet::send(Vehicle &vehicle, const Message &message)
{
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    ++vehicle.frames;
    network().send(vehicle.address, vehicle.agent, vehicle.writer.write(message, buffer));
}

template<typename Message> void SimulatedFleet::send(Station &station, const Message &message)
{
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    network().send(station.client, station.gateway, station.writer.write(message, buffer));
}

} // namespace skyseal::test
