// A whole ground station between two agents, whose keys are bound to the systems 1 and 2, and a third device in clear. The input
// is a program of steps: time passes, agents send telemetry, in their own name or in the other's, records are held back, replayed,
// changed or cut off, clear frames and any bytes arrive, the list of peers changes, the store fails. Whatever happens, a position
// that is shown was sealed by the agent of that system and replaces no newer one, and nothing grows.
#include "tests/fuzz/simulated_host.h"

#include "core/base/byte_reader.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/x25519.h"
#include "core/engine/common/carrier_reader.h"
#include "core/engine/common/carrier_writer.h"
#include "core/engine/station/snapshot.h"
#include "core/engine/station/station_core.h"
#include "core/mavlink/dialect.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"
#include "tests/channel/pair.h"

#include <QtCore/QCoreApplication>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>

using namespace skyseal;
using namespace skyseal::channel;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

constexpr LinkId kLink{1};
constexpr std::size_t kAgents = 2;
constexpr Duration kOvertaken = 1s;
constexpr Duration kStep = 50ms;
constexpr std::int32_t kFirstLatitude = 100'000'000; ///< in 1e-7 degrees; the number of a position is added

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
    out.port = static_cast<std::uint16_t>(40000 + number);
    return out;
}

std::shared_ptr<const crypto::X25519KeyPair> keyPair(std::uint64_t seed)
{
    SeededRandom random(seed);
    return std::make_shared<const crypto::X25519KeyPair>(crypto::X25519KeyPair::generate(random));
}

struct Position
{
    std::size_t agent = 0; ///< kAgents: sent in clear
    std::uint8_t systemId = 0;
    bool isBound = false; ///< the list had the agent of this system then; without it, the system may be clear
};

struct Agent
{
    std::unique_ptr<Endpoint> endpoint;
    MemoryCounterStore counters;
    std::unique_ptr<SeededRandom> random;
    engine::CarrierReader reader;
    engine::CarrierWriter writer;
    Carrier carrier{};
    Peer listed; ///< by the station
    bool held = false;
    std::deque<Bytes> queue;   ///< blocks that were held back
    std::deque<Bytes> history; ///< the newest blocks that arrived, or were withheld
    std::uint32_t shown = 0;   ///< the greatest number of a position that was shown
    TimePoint shownSince{};
};

class StationFlight
{
public:
    explicit StationFlight(std::uint8_t carriers)
    {
        static const auto station = keyPair(100);
        auto secrets = std::make_unique<engine::SecretFiles>();
        secrets->identity = station;
        auto counters = std::make_unique<MemoryCounterStore>();
        m_counters = counters.get();
        secrets->counters = std::move(counters);
        for (std::size_t i = 0; i < kAgents; ++i) {
            static const std::shared_ptr<const crypto::X25519KeyPair> keys[] = {keyPair(1), keyPair(2)};
            Agent &agent = m_agents[i];
            agent.carrier = carriers >> i & 1 ? Carrier::Tunnel : Carrier::Datagram;
            agent.random = std::make_unique<SeededRandom>(10 + i);
            agent.listed.key = keys[i]->publicKey;
            agent.listed.name = "air";
            agent.listed.systemIds = {systemOf(i)};
            agent.writer.setNode({systemOf(i), 191});
            Config config;
            config.role = Role::Agent;
            config.identity = keys[i];
            config.policy = {defaultSuites(), true, false, i == 0};
            Peer ground;
            ground.key = station->publicKey;
            ground.name = "ground";
            config.peers = {ground};
            config.announceTo = {Path{kLink, addressOf(99), agent.carrier, {}}};
            agent.endpoint = std::make_unique<Endpoint>(std::move(config), *agent.random, agent.counters, host().now());
            secrets->peers.push_back(agent.listed);
        }
        engine::StationConfig config;
        config.secure = engine::SecureMode::Preferred;
        config.policy = {defaultSuites(), true, false, true};
        config.record = false;
        engine::StationSinks sinks;
        sinks.snapshot = [this](const std::shared_ptr<const engine::Snapshot> &snapshot) { judge(*snapshot); };
        sinks.event = [](const engine::Event &) {};
        m_station = std::make_unique<engine::StationCore>(std::move(config), std::move(secrets), std::move(sinks));
        m_station->addLink(kLink, SimulatedHost::url("udpin:14550"));
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
    static std::uint8_t systemOf(std::size_t agent) { return static_cast<std::uint8_t>(agent + 1); }
    std::size_t numberOf(const Agent &agent) const { return static_cast<std::size_t>(&agent - m_agents.data()); }

    void step(ByteReader &in)
    {
        const std::uint8_t operation = in.u8(), argument = in.u8();
        Agent &agent = m_agents[operation / 16 % kAgents];
        switch (operation % 16) {
        case 0: return pass(argument * 10ms);
        case 1: return pass(argument * 100ms);
        case 2: return send(agent, position(numberOf(agent), systemOf(argument & 1 ? 1 - numberOf(agent) : numberOf(agent))));
        case 3:
            agent.held = argument & 1;
            if (argument & 2)
                std::reverse(agent.queue.begin(), agent.queue.end());
            if (argument & 4)
                agent.queue.clear();
            return pump();
        case 4: // The newest block is taken off the path, to be delivered by step 5.
            if (!agent.queue.empty()) {
                agent.history.push_back(std::move(agent.queue.back()));
                agent.queue.pop_back();
            }
            return;
        case 5:
            if (!agent.history.empty())
                arrive(numberOf(agent), Bytes(agent.history[agent.history.size() - 1 - argument % agent.history.size()]));
            return;
        case 6:
            if (!agent.history.empty()) {
                Bytes copy = agent.history.back();
                copy[argument % copy.size()] ^= static_cast<std::uint8_t>(1 + in.u8() % 255);
                arrive(numberOf(agent), copy);
            }
            return;
        case 7:
            if (!agent.history.empty()) {
                Bytes copy = agent.history.back();
                copy.resize(argument % copy.size());
                arrive(numberOf(agent), copy);
            }
            return;
        case 8: return arrive(operation / 16, in.bytes(std::min<std::size_t>(argument, in.remaining())));
        case 9:
            return send(agent,
                        Bytes(frameOf(mavlink::Heartbeat{.type = mavlink::MAV_TYPE_QUADROTOR,
                                                         .autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA},
                                      systemOf(numberOf(agent)))));
        case 10: return arrive(argument & 0x80 ? 7u : operation / 16 % kAgents, position(kAgents, argument & 0x7f));
        case 11: // The list of peers; the keys stay bound to their systems.
            m_listed[numberOf(agent)] = argument & 1;
            return relist();
        case 12: return m_station->allowPlaintext(argument);
        case 13: m_counters->fails = argument & 1; return;
        case 14:
            for (const SessionId session : agent.endpoint->sessions())
                agent.endpoint->switchSuite(host().now(), session, crypto::suites()[argument % crypto::suites().size()].id);
            return pump();
        default:
            for (const SessionId session : agent.endpoint->sessions())
                agent.endpoint->close(host().now(), session);
            return pump();
        }
    }

    template<typename Message> Bytes frameOf(const Message &message, std::uint8_t systemId)
    {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        mavlink::FrameWriter writer(systemId, 1);
        const ByteView frame = writer.write(message, buffer);
        return Bytes(frame.begin(), frame.end());
    }

    /// A position in the name of a system; its latitude is its number.
    Bytes position(std::size_t sender, std::uint8_t systemId)
    {
        const bool isBound = systemId >= 1 && systemId <= kAgents && m_listed[systemId - 1u];
        m_positions.push_back({sender, systemId, isBound});
        mavlink::GlobalPositionInt message;
        message.lat = kFirstLatitude + static_cast<std::int32_t>(m_positions.size());
        message.lon = 1;
        return frameOf(message, systemId);
    }

    void relist()
    {
        std::vector<Peer> peers;
        for (std::size_t i = 0; i < kAgents; ++i) {
            if (m_listed[i])
                peers.push_back(m_agents[i].listed);
        }
        m_station->setPeers(std::move(peers));
        pump();
    }

    void send(Agent &agent, const Bytes &frames)
    {
        for (const SessionId session : agent.endpoint->sessions()) {
            Bytes record(frames.size() + kMaxRecordOverhead);
            if (const auto size = agent.endpoint->seal(host().now(), session, frames, record))
                transmit(agent, agent.endpoint->recordPath(session), ByteView(record).first(*size));
        }
        pump();
    }
    void transmit(Agent &agent, const Path &to, ByteView message)
    {
        agent.writer.write(to, message, [&](ByteView block) { agent.queue.emplace_back(block.begin(), block.end()); });
    }

    void arrive(std::size_t sender, ByteView bytes)
    {
        host().receive(kLink, addressOf(sender), bytes);
        pump();
    }

    void pass(Duration span)
    {
        for (Duration passed{}; passed < span; passed += kStep) {
            for (Agent &agent : m_agents)
                agent.endpoint->handleDeadline(host().now());
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
                toAgents(sent);
            }
            for (Agent &agent : m_agents) {
                while (const auto out = agent.endpoint->pollTransmit())
                    transmit(agent, out->to, out->bytes);
                while (agent.endpoint->pollEvent())
                    continue;
                while (!agent.held && !agent.queue.empty()) {
                    moved = true;
                    agent.history.push_back(std::move(agent.queue.front()));
                    agent.queue.pop_front();
                    if (agent.history.size() > 32)
                        agent.history.pop_front();
                    const Bytes block = agent.history.back();
                    host().receive(kLink, addressOf(numberOf(agent)), block);
                }
            }
            if (!moved)
                return;
        }
    }

    void toAgents(const SentBlock &sent)
    {
        for (std::size_t i = 0; i < kAgents; ++i) {
            Agent &agent = m_agents[i];
            if (sent.to != addressOf(i))
                continue;
            Bytes bytes = sent.bytes;
            const Path from{kLink, addressOf(99)};
            if (agent.carrier == Carrier::Datagram) {
                if (!bytes.empty() && Endpoint::owns(bytes[0]))
                    agent.endpoint->handleDatagram(host().now(), from, bytes);
                continue;
            }
            mavlink::FrameScanner scanner(bytes, mavlink::Dialect::builtin());
            while (const auto item = scanner.next()) {
                if (!engine::CarrierReader::isTunnel(*item))
                    continue;
                const auto message = agent.reader.takeTunnel(host().now(), from, *item->frame, agent.writer.node());
                if (message && Endpoint::owns(message->bytes[0]))
                    agent.endpoint->handleDatagram(message->time, message->path, message->bytes);
            }
        }
    }

    /// What the operator sees.
    void judge(const engine::Snapshot &snapshot)
    {
        for (const engine::VehicleSnapshot &vehicle : snapshot.vehicles) {
            const std::uint8_t system = vehicle.state.systemId;
            if (system < 1 || system > kAgents || std::isnan(vehicle.state.position.latitude))
                continue;
            const auto number = static_cast<std::int64_t>(std::llround(vehicle.state.position.latitude * 1e7)) - kFirstLatitude;
            if (number < 1 || number > static_cast<std::int64_t>(m_positions.size()))
                continue; // A position of any bytes that an agent sealed.
            const Position &shown = m_positions[static_cast<std::size_t>(number - 1)];
            if (shown.agent == kAgents && !shown.isBound)
                continue;
            if (shown.agent == kAgents)
                violated("nothing clear of a sealed system is shown");
            if (systemOf(shown.agent) != system)
                violated("no agent speaks as another");
            Agent &agent = m_agents[shown.agent];
            if (number < agent.shown && host().now() - agent.shownSince > kOvertaken + 200ms)
                violated("nothing overtaken is shown");
            if (number > agent.shown) {
                agent.shown = static_cast<std::uint32_t>(number);
                agent.shownSince = host().now();
            }
        }
    }

    MemoryCounterStore *m_counters = nullptr;
    std::array<Agent, kAgents> m_agents;
    std::array<bool, kAgents> m_listed{true, true};
    std::vector<Position> m_positions;
    std::unique_ptr<engine::StationCore> m_station;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static int argumentCount = 1;
    static char name[] = "station_core_fuzz";
    static char *arguments[] = {name, nullptr};
    static QCoreApplication application(argumentCount, arguments);
    static const bool ready = crypto::initCrypto();
    if (!ready)
        std::abort();
    SimulatedHost::instance().reset();
    ByteReader in(ByteView(data, size));
    StationFlight flight(in.u8());
    flight.run(in);
    return 0;
}
