// A whole ground station between two agents, whose keys are bound to the systems 1 and 2, and a third device in clear. The
// input is the settings of all ends, the links of the station (with udpout links it calls agents that listen) and a program of
// steps: time passes, agents send telemetry, in records or sealed in place, in their own name or in the other's, records are
// held back, replayed, changed or cut off, clear frames and any bytes arrive, also from strangers, the list of peers and the
// policy change, agents pair and close, the store fails. Whatever happens, a position that is shown was sealed by the agent of
// that system and replaces no newer one; nobody is paired without both people; addresses that proved nothing get no more than
// they sent; a few agents are called at a time, and hardly any where MAVLink comes from; and nothing grows.
#include "tests/fuzz/call_watch.h"
#include "tests/fuzz/exchanges.h"
#include "tests/fuzz/remote_end.h"
#include "tests/fuzz/simulated_host.h"

#include "core/crypto/init_crypto.h"
#include "core/engine/common/sealed_in_place.h"
#include "core/engine/station/snapshot.h"
#include "core/engine/station/station_core.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/frame_intake.h"
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

constexpr LinkId kDatagrams{1}, kStreams{2}, kFirstCall{3};
constexpr std::size_t kAgents = 2;
constexpr std::size_t kAbsentAgents = 20;  ///< listed, and nowhere
constexpr std::size_t kFirstStranger = 50; ///< the number of its address
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

/// The number of udpout links, two bits for it.
std::size_t callLinksOf(std::uint8_t choice)
{
    constexpr std::size_t counts[] = {0, 1, 3, 12};
    return counts[choice & 3];
}

struct Position
{
    std::size_t agent = 0; ///< kAgents: sent in clear
    std::uint8_t systemId = 0;
    bool isBound = false; ///< the list had the agent of this system then; without it, the system may be clear
    int removals = 0;     ///< of that agent from the list until then
};

struct Agent
{
    std::unique_ptr<RemoteEnd> end;
    Peer listed; ///< by the station
    bool isListed = true;
    int removals = 0;        ///< from the list
    bool saidYes = false;    ///< to a pairing, since the station's window opened
    std::uint32_t shown = 0; ///< the greatest number of a position that was shown
    TimePoint shownSince{};
};

class StationFlight
{
public:
    /// `paths`: two bits for the carrier of each agent, two for the number of udpout links; then whether there are more agents,
    /// and whether both listen at the last of these links instead.
    StationFlight(std::uint8_t paths, std::uint8_t settings) : m_callLinks(callLinksOf(paths >> 4))
    {
        static const auto station = newIdentity(100);
        auto secrets = std::make_unique<engine::SecretFiles>();
        secrets->identity = station;
        auto counters = std::make_unique<MemoryCounterStore>();
        m_counters = counters.get();
        secrets->counters = std::move(counters);
        for (std::size_t i = 0; i < kAgents; ++i) {
            static const std::shared_ptr<const crypto::X25519KeyPair> keys[] = {newIdentity(1), newIdentity(2)};
            Agent &agent = m_agents[i];
            agent.listed.key = publicKeyOf(*keys[i]);
            agent.listed.name = "air";
            agent.listed.systemIds = {systemOf(i)};
            secrets->peers.push_back(agent.listed);
            Config config;
            config.role = Role::Agent;
            config.identity = keys[i];
            config.policy = policyOf(settings & 1);
            config.peers = {{publicKeyOf(*station), "ground", PeerRole::Pilot, {}}};
            RemoteEnd::Way way{pathOf(paths, i), true};
            if (paths & 0x80 && m_callLinks > i)
                way = {{callLink(m_callLinks - 1 - i), addressOf(99)}, false};
            agent.end = std::make_unique<RemoteEnd>(std::move(config), std::vector{way}, Node{systemOf(i), 191}, 10 + i, now());
        }
        static const std::vector<Peer> absent = absentAgents();
        if (paths & 0x40)
            m_absent = absent;
        secrets->peers.insert(secrets->peers.end(), m_absent.begin(), m_absent.end());
        for (const Peer &peer : secrets->peers)
            m_calls.addAgent(peer.key);
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
        for (std::size_t i = 0; i < m_callLinks; ++i)
            m_station->addLink(callLink(i), SimulatedHost::url("udpout:192.0.2.1:14550"));
        pass(2s);
    }

    void run(ByteReader &in)
    {
        const GrowthWatch growth;
        for (int steps = 0; steps < 200 && in.ok() && !in.atEnd(); ++steps)
            step(in);
        growth.judge();
    }

private:
    static SimulatedHost &host() { return SimulatedHost::instance(); }
    static TimePoint now() { return host().now(); }
    static std::uint8_t systemOf(std::size_t agent) { return static_cast<std::uint8_t>(agent + 1); }
    static LinkId callLink(std::size_t index)
    {
        return LinkId{static_cast<std::uint32_t>(kFirstCall) + static_cast<std::uint32_t>(index)};
    }
    static bool isCallLink(LinkId link) { return link >= kFirstCall; }
    static std::vector<Peer> absentAgents()
    {
        std::vector<Peer> out;
        for (std::size_t i = 0; i < kAbsentAgents; ++i)
            out.push_back({publicKeyOf(*newIdentity(1000 + i)), "absent", PeerRole::Pilot, {}, {}});
        return out;
    }
    /// Where an agent is, or a stranger at a link.
    static Address addressAt(LinkId link, std::size_t number)
    {
        return isCallLink(link) ? SimulatedHost::remoteOf(link) : addressOf(number);
    }
    LinkId linkOf(std::size_t agent) const { return m_agents[agent].end->ways()[0].engine.link; }

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
            const LinkId link = linkOf(number);
            receive(link, addressAt(link, argument & 0x80 ? 7 : number), position(kAgents, argument & 0x7f));
            return pump();
        }
        case 11: // The list of peers; the keys stay bound to their systems.
            agent.removals += agent.isListed && !(argument & 1);
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
            host().reconnect(linkOf(number), addressAt(linkOf(number), number));
            agent.end->reconnect(now(), linkOf(number));
            return pump();
        case 21: { // from a stranger: any bytes, or what an agent has sent
            const std::size_t stranger = kFirstStranger + (argument & 3);
            if (argument & 0x80)
                receive(kDatagrams, addressOf(stranger), anyBytes(in, in.u8()));
            else if (const auto block = agent.end->repeat(in.u8()))
                receive(kDatagrams, addressOf(stranger), block->bytes);
            return pump();
        }
        case 22: // a router at a udpout link
            if (m_callLinks > 0) {
                const LinkId link = callLink(in.u8() % m_callLinks);
                receive(link, SimulatedHost::remoteOf(link), position(kAgents, argument & 0x7f));
            }
            return pump();
        case 23: // any bytes at a udpout link
            if (m_callLinks > 0) {
                const LinkId link = callLink(argument % m_callLinks);
                receive(link, SimulatedHost::remoteOf(link), anyBytes(in, in.u8()));
            }
            return pump();
        case 25: // what an agent has sent in TUNNEL, from a stranger, as short as MAVLink can make it
            if (const auto block = agent.end->repeat(argument)) {
                if (const Bytes frame = withoutPadding(block->bytes); !frame.empty())
                    receive(kDatagrams, addressOf(kFirstStranger + (argument & 3)), frame);
            }
            return pump();
        case 24: m_isCut = argument & 1; return; // what comes from agents is lost
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
        m_positions.push_back({sender, systemId, isBound, isBound ? m_agents[systemId - 1u].removals : 0});
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
        peers.insert(peers.end(), m_absent.begin(), m_absent.end());
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
            deliver(sender, *block);
        pump();
    }
    void deliver(std::size_t sender, const RemoteEnd::Block &block)
    {
        if (!m_isCut)
            receive(linkOf(sender), addressAt(linkOf(sender), sender), block.bytes);
    }
    void receive(LinkId link, const Address &from, ByteView bytes)
    {
        m_exchanges.received(link, from, bytes.size());
        const std::uint8_t head = messageHead(Carrier::Datagram, bytes);
        const bool isMavlink = head == 0 && bringsMavlink(bytes);
        // Answers, numbers and cookies show that it receives first messages, records more; clear frames are answered as such.
        if (link != kDatagrams || (isMavlink && !asksInTunnel(bytes))
            || (head != 0 && head != kAnnouncementHead && head != kCallHead))
            m_exchanges.proved(link, from);
        const TimePoint arrived = now();
        host().receive(link, from, bytes);
        collect();
        if (isCallLink(link) && isMavlink)
            m_calls.mavlinkCame(arrived, link);
        else if (isCallLink(link) && head != 0)
            m_calls.agentAnswered(link);
    }
    /// Empty unless it is one TUNNEL.
    static Bytes withoutPadding(ByteView bytes)
    {
        const auto frame = mavlink::readFrame(bytes, mavlink::Dialect::builtin());
        if (!frame || frame->messageId() != mavlink::Tunnel::kId)
            return {};
        auto tunnel = mavlink::Tunnel::decode(frame->payload());
        std::fill(tunnel.payload.begin() + std::min<std::size_t>(tunnel.payload_length, tunnel.payload.size()),
                  tunnel.payload.end(), std::uint8_t(0));
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        const ByteView written = mavlink::FrameWriter(frame->systemId(), frame->componentId()).write(tunnel, buffer);
        return Bytes(written.begin(), written.end());
    }
    /// Whether it is one TUNNEL with a message that proves nothing, and is answered by another one.
    static bool asksInTunnel(ByteView bytes)
    {
        const auto frame = mavlink::readFrame(bytes, mavlink::Dialect::builtin());
        const std::uint8_t head = messageHead(Carrier::Tunnel, bytes);
        return frame && frame->bytes().size() == bytes.size() && frame->messageId() == mavlink::Tunnel::kId
            && (head == kAnnouncementHead || head == kCallHead);
    }
    static bool bringsMavlink(ByteView bytes)
    {
        bool out = false;
        mavlink::scanFrames(bytes, mavlink::Dialect::builtin(), [&](const mavlink::ScanItem &item) {
            out = out || (item.frame && !engine::isSealedInPlace(item));
        });
        return out;
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
            collect();
            takePaired();
            const std::vector<SentBlock> sent = std::exchange(m_sent, {});
            bool moved = !sent.empty();
            for (std::size_t i = 0; i < kAgents; ++i) {
                RemoteEnd &end = *m_agents[i].end;
                for (const SentBlock &block : sent) {
                    if (block.link == linkOf(i) && (block.to == addressAt(block.link, i) || block.to == Address{}))
                        end.receive(now(), block.link, block.bytes);
                }
                end.poll(now());
                while (const auto block = end.next()) {
                    moved = true;
                    deliver(i, *block);
                }
            }
            if (!moved)
                return;
        }
    }
    void collect()
    {
        for (SentBlock &sent : host().takeSent()) {
            judge(sent);
            m_sent.push_back(std::move(sent));
        }
    }

    // ---- the oracles

    void judge(const SentBlock &sent)
    {
        const std::uint8_t head = messageHead(Carrier::Datagram, sent.bytes);
        if (isCallLink(sent.link)) {
            if (head == kFirstHead)
                m_calls.sent(now(), sent.link, sent.bytes);
        } else if (sent.to != Address{} && head != kPairingSealedHead) {
            m_exchanges.sent(sent.link, sent.to, sent.bytes.size());
        }
    }
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
            // Bytes of a stream may wait until they are known not to be a record; then the list of that moment counts.
            if (shown.agent == kAgents && shown.removals != m_agents[system - 1u].removals)
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

    const std::size_t m_callLinks;
    std::vector<Peer> m_absent;
    CallWatch m_calls;
    bool m_isCut = false;
    Exchanges m_exchanges;
    std::vector<SentBlock> m_sent; ///< by the station, on their way
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
    const std::uint8_t paths = in.u8();
    StationFlight flight(paths, in.u8());
    flight.run(in);
    return 0;
}
