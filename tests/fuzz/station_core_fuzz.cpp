// A whole ground station between two agents, whose keys are bound to the systems 1 and 2, and a third device in clear. The
// input is the settings of all ends and a program of steps: time passes, agents send telemetry, in records or sealed in place,
// in their own name or in the other's, records are held back, replayed, changed or cut off, clear frames and any bytes arrive,
// the list of peers and the policy change, agents pair and close, the store fails. Whatever happens, a position that is shown
// was sealed by the agent of that system and replaces no newer one; nobody is paired without both people; and nothing grows.
#include "tests/fuzz/remote_end.h"
#include "tests/fuzz/simulated_host.h"

#include "core/crypto/init_crypto.h"
#include "core/crypto/x25519.h"
#include "core/engine/station/snapshot.h"
#include "core/engine/station/station_core.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace skyseal;
using namespace skyseal::channel;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

constexpr LinkId kDatagrams{1}, kStreams{2};
constexpr std::size_t kAgents = 2;
constexpr Duration kOvertaken = 1s;
constexpr Duration kStep = 50ms;
constexpr std::int32_t kFirstLatitude = 100'000'000; ///< in 1e-7 degrees; the number of a position is added

/// Two bits for each agent: datagrams, TUNNEL in datagrams, COBS, or TUNNEL in a stream.
Path pathOf(std::uint8_t carriers, std::size_t agent)
{
    const unsigned choice = carriers >> 2 * agent & 3u;
    const Carrier carriersOf[] = {Carrier::Datagram, Carrier::Tunnel, Carrier::Serial, Carrier::Tunnel};
    return {choice < 2 ? kDatagrams : kStreams, addressOf(99), carriersOf[choice]};
}

struct Position
{
    std::size_t agent = 0; ///< kAgents: sent in clear
    std::uint8_t systemId = 0;
    bool isBound = false; ///< the list had the agent of this system then; without it, the system may be clear
};

struct Agent
{
    std::unique_ptr<RemoteEnd> end;
    Peer listed; ///< by the station
    bool isListed = true;
    bool saidYes = false;    ///< to a pairing, since the station's window opened
    std::uint32_t shown = 0; ///< the greatest number of a position that was shown
    TimePoint shownSince{};
};

class StationFlight
{
public:
    StationFlight(std::uint8_t carriers, std::uint8_t settings)
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
            agent.listed.key = keys[i]->publicKey;
            agent.listed.name = "air";
            agent.listed.systemIds = {systemOf(i)};
            secrets->peers.push_back(agent.listed);
            Config config;
            config.role = Role::Agent;
            config.identity = keys[i];
            config.policy = policyOf(settings & 1);
            config.peers = {{station->publicKey, "ground", PeerRole::Pilot, {}}};
            agent.end = std::make_unique<RemoteEnd>(std::move(config), pathOf(carriers, i), Node{systemOf(i), 191}, 10 + i,
                                                    now());
        }
        engine::StationConfig config;
        config.secure = settings & 8 ? engine::SecureMode::Required : engine::SecureMode::Preferred;
        config.policy = policyOf(settings & 7);
        config.record = false;
        engine::StationSinks sinks;
        sinks.snapshot = [this](const std::shared_ptr<const engine::Snapshot> &snapshot) { judge(*snapshot); };
        sinks.event = [](const engine::Event &) {};
        sinks.pairing = [this](const PairingEvent &event) { judge(event); };
        m_station = std::make_unique<engine::StationCore>(std::move(config), std::move(secrets), std::move(sinks));
        m_station->addLink(kDatagrams, SimulatedHost::url("udpin:14550"));
        m_station->addLink(kStreams, SimulatedHost::url("tcpin:14551"));
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
    static TimePoint now() { return host().now(); }
    static std::uint8_t systemOf(std::size_t agent) { return static_cast<std::uint8_t>(agent + 1); }

    void step(ByteReader &in)
    {
        const std::uint8_t operation = in.u8(), argument = in.u8();
        const std::size_t number = operation / 32 % kAgents;
        Agent &agent = m_agents[number];
        switch (operation % 32) {
        case 0: return pass(argument * 10ms);
        case 1: return pass(argument * 100ms);
        case 2: // a position, in its own name or in the other's
            agent.end->send(now(), position(number, systemOf(argument & 1 ? 1 - number : number)), argument & 0x80);
            return pump();
        case 3: agent.end->hold(argument); return pump();
        case 4: return agent.end->withholdNewest(); // step 5 delivers it
        case 5: return arrive(number, agent.end->repeat(argument));
        case 6: return arrive(number, agent.end->changed(argument, in.u8()));
        case 7: return arrive(number, agent.end->cut(argument));
        case 8: return arrive(number, RemoteEnd::Block{anyBytes(in, argument), {}});
        case 9:
            agent.end->send(now(),
                            frameOf(mavlink::Heartbeat{.type = mavlink::MAV_TYPE_QUADROTOR,
                                                       .autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA},
                                    systemOf(number)),
                            argument & 0x80);
            return pump();
        case 10: {
            const std::size_t sender = argument & 0x80 ? 7 : number;
            host().receive(m_agents[number].end->engine().link, addressOf(sender), position(kAgents, argument & 0x7f));
            return pump();
        }
        case 11: // The list of peers; the keys stay bound to their systems.
            agent.isListed = argument & 1;
            return relist();
        case 12: return m_station->allowPlaintext(argument);
        case 13: m_counters->fails = argument & 1; return;
        case 14: agent.end->switchSuite(now(), argument); return pump();
        case 15: agent.end->close(now(), 0); return pump();
        case 16: agent.end->send(now(), anyBytes(in, argument), false); return pump();
        case 17: return openPairing(number, argument);
        case 18: return decidePairing(agent, argument);
        case 19: return setPolicy(argument);
        case 20:
            host().reconnect(agent.end->engine().link, addressOf(number));
            agent.end->reconnect(now());
            return pump();
        default: return;
        }
    }

    static Bytes anyBytes(ByteReader &in, std::uint8_t most)
    {
        const ByteView bytes = in.bytes(std::min<std::size_t>(most, in.remaining()));
        return Bytes(bytes.begin(), bytes.end());
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
        const bool isBound = systemId >= 1 && systemId <= kAgents && m_agents[systemId - 1u].isListed;
        m_positions.push_back({sender, systemId, isBound});
        mavlink::GlobalPositionInt message;
        message.lat = kFirstLatitude + static_cast<std::int32_t>(m_positions.size());
        message.lon = 1;
        return frameOf(message, systemId);
    }

    void relist()
    {
        std::vector<Peer> peers;
        for (const Agent &agent : m_agents) {
            if (agent.isListed)
                peers.push_back(agent.listed);
        }
        m_station->setPeers(std::move(peers));
        pump();
    }

    /// Never to plain MAVLink, under which clear frames are shown.
    void setPolicy(std::uint8_t choice)
    {
        const std::optional<engine::Protection> protections[] = {std::nullopt, engine::Protection::Sealed,
                                                                 engine::Protection::Inline, std::nullopt};
        if (choice & 1)
            m_station->setAllowResearch(choice & 2);
        if (choice & 4)
            m_station->setProtection(protections[choice >> 3 & 3]);
        if (choice & 32)
            m_station->setWeakestSuite(defaultSuites()[(choice >> 6) % defaultSuites().size()]);
        pump();
    }

    void openPairing(std::size_t number, std::uint8_t choice)
    {
        if (choice & 16) {
            m_station->openPairing("ground", passphraseOf(choice));
            m_shown.reset();
            m_saidYes = false;
            for (Agent &each : m_agents)
                each.saidYes = false;
        }
        if (choice & 32)
            m_agents[number].end->openPairing(now(), "air", systemOf(number), choice >> 2);
        pump();
    }
    void decidePairing(Agent &agent, std::uint8_t choice)
    {
        if (choice & 1)
            agent.saidYes = agent.end->confirmPairing(now()) || agent.saidYes;
        if (choice & 2 && m_shown) {
            m_saidYes = true;
            m_station->confirmPairing(*m_shown);
        }
        if (choice & 4)
            agent.end->cancelPairing(now());
        if (choice & 8)
            m_station->refusePairing();
        pump();
    }
    void takePaired()
    {
        for (const Peer &peer : std::exchange(m_paired, {})) {
            for (Agent &agent : m_agents) {
                if (agent.listed.key == peer.key) {
                    agent.listed.presharedKey = peer.presharedKey;
                    agent.isListed = true;
                }
            }
            relist();
        }
    }

    void arrive(std::size_t sender, const std::optional<RemoteEnd::Block> &block)
    {
        if (block)
            host().receive(m_agents[sender].end->engine().link, addressOf(sender), block->bytes);
        pump();
    }

    void pass(Duration span)
    {
        for (Duration passed{}; passed < span; passed += kStep) {
            for (Agent &agent : m_agents)
                agent.end->handleDeadline(now());
            pump();
            host().advance(kStep);
        }
        pump();
    }

    /// Moves blocks both ways until all is quiet.
    void pump()
    {
        for (int round = 0; round < 20; ++round) {
            takePaired();
            const std::vector<SentBlock> sent = host().takeSent();
            bool moved = !sent.empty();
            for (std::size_t i = 0; i < kAgents; ++i) {
                RemoteEnd &end = *m_agents[i].end;
                for (const SentBlock &block : sent) {
                    if (block.link == end.engine().link && block.to == addressOf(i))
                        end.receive(now(), block.bytes);
                }
                end.poll(now());
                while (const auto block = end.next()) {
                    moved = true;
                    host().receive(end.engine().link, addressOf(i), block->bytes);
                }
            }
            if (!moved)
                return;
        }
    }

    // ---- the oracles

    /// The state that the operator sees.
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
            if (number < agent.shown && now() - agent.shownSince > kOvertaken + 200ms)
                violated("nothing overtaken is shown");
            if (number > agent.shown) {
                agent.shown = static_cast<std::uint32_t>(number);
                agent.shownSince = now();
            }
        }
    }

    void judge(const PairingEvent &event)
    {
        if (const auto *seen = std::get_if<PairingPeerSeen>(&event))
            m_shown = seen->peer.key;
        const auto *paired = std::get_if<Paired>(&event);
        if (!paired)
            return;
        const auto saidYes = [&](const Agent &agent) { return agent.saidYes && agent.listed.key == paired->peer.key; };
        if (!m_saidYes || m_shown != paired->peer.key || std::none_of(m_agents.begin(), m_agents.end(), saidYes))
            violated("nobody is paired without both people");
        m_paired.push_back(paired->peer);
    }

    MemoryCounterStore *m_counters = nullptr;
    std::array<Agent, kAgents> m_agents;
    std::vector<Position> m_positions;
    std::optional<channel::PublicKey> m_shown; ///< by the station's pairing
    bool m_saidYes = false;                    ///< the station's operator, to that key
    std::vector<Peer> m_paired;                ///< to be listed
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
    const std::uint8_t carriers = in.u8();
    StationFlight flight(carriers, in.u8());
    flight.run(in);
    return 0;
}
