// A whole agent between a vehicle and three stations. The input is a program of steps: time passes, stations send commands,
// records are held back, replayed, changed or cut off, clear frames and any bytes arrive, roles change, the store fails. Whatever
// happens, the vehicle receives no command that a pilot did not seal a moment ago, each once, and nothing grows.
#include "tests/fuzz/simulated_host.h"

#include "core/base/byte_reader.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/x25519.h"
#include "core/engine/agent/agent_core.h"
#include "core/engine/common/carrier_reader.h"
#include "core/engine/common/carrier_writer.h"
#include "core/mavlink/dialect.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"
#include "tests/channel/pair.h"

#include <QtCore/QCoreApplication>

#include <cstdio>
#include <cstdlib>
#include <deque>

using namespace skyseal;
using namespace skyseal::channel;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

constexpr LinkId kVehicleLink{1}, kGroundLink{2};
constexpr std::size_t kStations = 3;
constexpr Duration kOvertaken = 1s, kAge = 5s;
constexpr Duration kStep = 50ms;
constexpr std::uint16_t kCommand = mavlink::MAV_CMD_COMPONENT_ARM_DISARM;
constexpr std::uint16_t kQuestions[] = {mavlink::MAV_CMD_GET_HOME_POSITION, mavlink::MAV_CMD_REQUEST_MESSAGE,
                                        mavlink::MAV_CMD_REQUEST_PROTOCOL_VERSION,
                                        mavlink::MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES};

[[noreturn]] void violated(const char *oracle)
{
    std::fprintf(stderr, "violated: %s\n", oracle);
#ifdef SKYSEAL_WEAKEN
    std::_Exit(1);
#else
    std::abort();
#endif
}

Address addressOf(std::size_t number)
{
    Address out;
    out.ip = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff, 10, 0, 0, static_cast<std::uint8_t>(number + 1)};
    out.port = static_cast<std::uint16_t>(14550 + number);
    return out;
}

const Address kVehicleAddress = addressOf(100);

std::shared_ptr<const crypto::X25519KeyPair> keyPair(std::uint64_t seed)
{
    SeededRandom random(seed);
    return std::make_shared<const crypto::X25519KeyPair>(crypto::X25519KeyPair::generate(random));
}

/// Ids and rights of a command on its way.
struct Command
{
    std::size_t station = 0; ///< kStations: sent in clear
    TimePoint sent;
};

struct Station
{
    std::unique_ptr<Endpoint> endpoint;
    MemoryCounterStore counters;
    std::unique_ptr<SeededRandom> random;
    engine::CarrierReader reader;
    engine::CarrierWriter writer;
    Peer listed; ///< by the agent
    bool isListed = true;
    bool held = false;
    std::deque<Bytes> queue;                                 ///< blocks that were held back
    std::deque<Bytes> history;                               ///< the newest blocks that arrived, or were withheld
    std::vector<std::pair<std::uint32_t, TimePoint>> obeyed; ///< commands in the order of arrival
};

class AgentFlight
{
public:
    explicit AgentFlight(Carrier carrier) : m_carrier(carrier)
    {
        static const auto agent = keyPair(100);
        auto secrets = std::make_unique<engine::SecretFiles>();
        secrets->identity = agent;
        auto counters = std::make_unique<MemoryCounterStore>();
        m_counters = counters.get();
        secrets->counters = std::move(counters);
        for (std::size_t i = 0; i < kStations; ++i) {
            static const std::shared_ptr<const crypto::X25519KeyPair> keys[] = {keyPair(1), keyPair(2), keyPair(3)};
            Station &station = m_stations[i];
            station.random = std::make_unique<SeededRandom>(10 + i);
            station.listed.key = keys[i]->publicKey;
            station.listed.name = "station";
            station.listed.role = i == 1 ? PeerRole::Observer : PeerRole::Pilot;
            station.writer.setNode({static_cast<std::uint8_t>(250 + i), 190});
            Config config;
            config.identity = keys[i];
            config.policy = {defaultSuites(), true, false, i == 0};
            Peer air;
            air.key = agent->publicKey;
            air.name = "air";
            config.peers = {air};
            station.endpoint = std::make_unique<Endpoint>(std::move(config), *station.random, station.counters, host().now());
            secrets->peers.push_back(station.listed);
        }
        const bool stream = carrier == Carrier::Serial;
        engine::AgentConfig config{.vehicle = SimulatedHost::url("udpin:14560"),
                                   .ground = SimulatedHost::url(stream ? "tcpin:14550" : "udpin:14550"),
                                   .policy = {defaultSuites(), true, false, true},
                                   .carrier = carrier};
        m_agent = std::make_unique<engine::AgentCore>(std::move(config), std::move(secrets), [](const engine::AgentEvent &) {});
        m_agent->start();
        pass(2s);
    }

    void run(ByteReader &in)
    {
        const std::size_t before = allocatedBytes();
        for (int steps = 0; steps < 200 && in.ok() && !in.atEnd(); ++steps)
            step(in);
        if (allocatedBytes() > before + (16u << 20))
            violated("nothing grows");
    }

private:
    static SimulatedHost &host() { return SimulatedHost::instance(); }

    void step(ByteReader &in)
    {
        const std::uint8_t operation = in.u8(), argument = in.u8();
        Station &station = m_stations[operation / 16 % kStations];
        switch (operation % 16) {
        case 0: return pass(argument * 10ms);
        case 1: return pass(argument * 100ms);
        case 2: return sendCommand(station);
        case 3: return hold(station, argument);
        case 4: // The newest block is taken off the path, to be delivered by step 5.
            if (!station.queue.empty()) {
                station.history.push_back(std::move(station.queue.back()));
                station.queue.pop_back();
            }
            return;
        case 5:
            if (!station.history.empty())
                deliver(station, station.history[station.history.size() - 1 - argument % station.history.size()]);
            return;
        case 6:
            if (!station.history.empty()) {
                Bytes copy = station.history.back();
                copy[argument % copy.size()] ^= static_cast<std::uint8_t>(1 + in.u8() % 255);
                deliver(station, copy);
            }
            return;
        case 7:
            if (!station.history.empty()) {
                Bytes copy = station.history.back();
                copy.resize(argument % copy.size());
                deliver(station, copy);
            }
            return;
        case 8:
            return arrive(kGroundLink, addressOf(operation / 16), in.bytes(std::min<std::size_t>(argument, in.remaining())));
        case 9: return arrive(kVehicleLink, kVehicleAddress, in.bytes(std::min<std::size_t>(argument, in.remaining())));
        case 10: return arrive(kGroundLink, addressOf(operation / 16), command(kStations));
        case 11: return setRole(station, argument);
        case 12: return sendAnything(station, in.bytes(std::min<std::size_t>(argument, in.remaining())));
        case 13: m_counters->fails = argument & 1; return;
        case 14:
            for (const SessionId session : station.endpoint->sessions())
                station.endpoint->switchSuite(host().now(), session, crypto::suites()[argument % crypto::suites().size()].id);
            return pump();
        default:
            if (argument & 1) {
                for (const SessionId session : station.endpoint->sessions())
                    station.endpoint->close(host().now(), session);
            } else {
                m_agent->snapshot();
            }
            return pump();
        }
    }

    /// A command of a station, or a clear one. Its fifth parameter is its number.
    Bytes command(std::size_t sender)
    {
        m_commands.push_back({sender, host().now()});
        mavlink::CommandLong message;
        message.command = kCommand;
        message.param1 = 1;
        message.param5 = static_cast<float>(m_commands.size());
        message.target_system = 1;
        message.target_component = 1;
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        const ByteView frame = m_frames.write(message, buffer);
        return Bytes(frame.begin(), frame.end());
    }

    void sendCommand(Station &station)
    {
        if (!station.endpoint->sessions().empty())
            send(station, command(static_cast<std::size_t>(&station - m_stations.data())));
    }
    /// What only an observer may try, so that no command of a pilot is unknown.
    void sendAnything(Station &station, ByteView bytes)
    {
        if (!bytes.empty() && (!station.isListed || station.listed.role == PeerRole::Observer))
            send(station, Bytes(bytes.begin(), bytes.end()));
    }
    void send(Station &station, const Bytes &frames)
    {
        for (const SessionId session : station.endpoint->sessions()) {
            Bytes record(frames.size() + kMaxRecordOverhead);
            if (const auto size = station.endpoint->seal(host().now(), session, frames, record))
                transmit(station, station.endpoint->recordPath(session), ByteView(record).first(*size));
        }
        pump();
    }
    void transmit(Station &station, const Path &to, ByteView message)
    {
        station.writer.write(to, message, [&](ByteView block) { station.queue.emplace_back(block.begin(), block.end()); });
    }

    void hold(Station &station, std::uint8_t how)
    {
        station.held = how & 1;
        if (how & 2)
            std::reverse(station.queue.begin(), station.queue.end());
        if (how & 4)
            station.queue.clear();
        pump();
    }

    void setRole(Station &station, std::uint8_t role)
    {
        station.isListed = role % 3 != 2;
        station.listed.role = role % 3 == 0 ? PeerRole::Pilot : PeerRole::Observer;
        std::vector<Peer> peers;
        for (const Station &each : m_stations) {
            if (each.isListed)
                peers.push_back(each.listed);
        }
        m_agent->setPeers(std::move(peers));
        pump();
    }

    void deliver(Station &station, const Bytes &block)
    {
        arrive(kGroundLink, addressOf(static_cast<std::size_t>(&station - m_stations.data())), block);
    }
    void arrive(LinkId link, const Address &from, ByteView bytes)
    {
        host().receive(link, from, bytes);
        pump();
    }

    void pass(Duration span)
    {
        for (Duration passed{}; passed < span; passed += kStep) {
            if (host().now() >= m_nextHeartbeat) {
                m_nextHeartbeat = host().now() + 1s;
                std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
                host().receive(kVehicleLink, kVehicleAddress,
                               m_vehicle.write(mavlink::Heartbeat{.type = mavlink::MAV_TYPE_QUADROTOR,
                                                                  .autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA},
                                               buffer));
            }
            for (Station &station : m_stations)
                station.endpoint->handleDeadline(host().now());
            pump();
            host().advance(kStep);
        }
        pump();
    }

    /// Moves blocks both ways until all is quiet.
    void pump()
    {
        for (int round = 0; round < 20; ++round) {
            bool moved = false;
            for (const SentBlock &sent : host().takeSent()) {
                moved = true;
                sent.link == kVehicleLink ? judge(sent.bytes) : toStations(sent);
            }
            for (Station &station : m_stations) {
                while (const auto out = station.endpoint->pollTransmit())
                    transmit(station, out->to, out->bytes);
                while (station.endpoint->pollEvent())
                    continue;
                while (!station.held && !station.queue.empty()) {
                    moved = true;
                    station.history.push_back(std::move(station.queue.front()));
                    station.queue.pop_front();
                    if (station.history.size() > 32)
                        station.history.pop_front();
                    const Bytes block = station.history.back();
                    host().receive(kGroundLink, addressOf(static_cast<std::size_t>(&station - m_stations.data())), block);
                }
            }
            if (!moved)
                return;
        }
    }

    void toStations(const SentBlock &sent)
    {
        for (std::size_t i = 0; i < kStations; ++i) {
            Station &station = m_stations[i];
            if (sent.to != Address{} && sent.to != addressOf(i))
                continue;
            Bytes bytes = sent.bytes;
            const link::ReceivedBlock block{{kGroundLink, addressOf(99)}, bytes, host().now()};
            const auto take = [&](const link::ReceivedBlock &message) {
                if (Endpoint::owns(message.bytes[0]))
                    station.endpoint->handleDatagram(message.time, message.path, message.bytes);
            };
            if (m_carrier == Carrier::Serial) {
                station.reader.takeCobs(block, take);
            } else if (m_carrier == Carrier::Tunnel) {
                mavlink::FrameScanner scanner(bytes, mavlink::Dialect::builtin());
                while (const auto item = scanner.next()) {
                    if (!engine::CarrierReader::isTunnel(*item))
                        continue;
                    if (const auto message = station.reader.takeTunnel(host().now(), block.path, *item->frame,
                                                                       station.writer.node()))
                        take(*message);
                }
            } else {
                take(block);
            }
        }
    }

    /// What the vehicle receives.
    void judge(ByteView bytes)
    {
        mavlink::FrameScanner scanner(bytes, mavlink::Dialect::builtin());
        while (const auto item = scanner.next()) {
            if (!item->frame || item->frame->messageId() != mavlink::CommandLong::kId)
                continue;
            const auto message = mavlink::CommandLong::decode(item->frame->payload());
            if (message.command == kCommand)
                judge(message.param5);
            else if (std::find(std::begin(kQuestions), std::end(kQuestions), message.command) == std::end(kQuestions))
                violated("no observer commands");
        }
    }
    void judge(float number)
    {
        if (!(number >= 1) || number > static_cast<float>(m_commands.size()))
            violated("no observer commands");
        const auto id = static_cast<std::uint32_t>(number);
        const Command &command = m_commands[id - 1];
        if (command.station == kStations)
            violated("nothing clear commands");
        Station &station = m_stations[command.station];
        if (!station.isListed || station.listed.role != PeerRole::Pilot)
            violated("no observer commands");
        const TimePoint now = host().now();
        if (now - command.sent > kAge)
            violated("nothing old commands");
        for (const auto &[earlier, arrived] : station.obeyed) {
            if (earlier == id)
                violated("no command comes twice");
            if (earlier > id && now - arrived > kOvertaken)
                violated("nothing overtaken commands");
        }
        station.obeyed.emplace_back(id, now);
    }

    Carrier m_carrier;
    MemoryCounterStore *m_counters = nullptr;
    std::array<Station, kStations> m_stations;
    std::vector<Command> m_commands;
    mavlink::FrameWriter m_frames{255, 190}, m_vehicle{1, 1};
    TimePoint m_nextHeartbeat{};
    std::unique_ptr<engine::AgentCore> m_agent;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static int argumentCount = 1;
    static char name[] = "agent_core_fuzz";
    static char *arguments[] = {name, nullptr};
    static QCoreApplication application(argumentCount, arguments);
    static const bool ready = crypto::initCrypto();
    if (!ready)
        std::abort();
    SimulatedHost::instance().reset();
    ByteReader in(ByteView(data, size));
    AgentFlight flight(static_cast<Carrier>(1 + in.u8() % 3));
    flight.run(in);
    return 0;
}
