// A whole agent between a vehicle and three stations. The input is the settings of both, the ground links of the agent (one or
// several, which call or listen, in the same or different carriers) and a program of steps: time passes, stations send frames,
// in records or sealed in place, frames are held back, replayed, changed, cut off or copied to another link, links fail in one
// direction or both, clear frames and any bytes arrive, also from strangers, roles change, stations pair and close, the store
// fails. Whatever happens, each frame that leaves for the vehicle is one that a station sealed, once; unless it only asks, a
// pilot sealed it, a moment ago, and has not closed since; nobody is paired without both people; addresses that proved nothing
// get no more than they sent, and nothing unasked where the agent listens; and nothing grows.
#include "tests/fuzz/agent_settings.h"
#include "tests/fuzz/exchanges.h"
#include "tests/fuzz/ground_frames.h"
#include "tests/fuzz/harmless_frame.h"
#include "tests/fuzz/remote_end.h"
#include "tests/fuzz/simulated_host.h"

#include "core/crypto/init_crypto.h"
#include "core/engine/agent/agent_core.h"
#include "core/mavlink/dialect.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/frame_intake.h"
#include "core/mavlink/messages.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <cstdlib>
#include <map>

using namespace skyseal;
using namespace skyseal::channel;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

using engine::groundIndex;
using engine::groundLink;
using engine::kVehicleLink;

constexpr std::size_t kStations = 3;
constexpr std::size_t kFirstStranger = 50; ///< the number of its address
constexpr Duration kStep = 50ms;

const Address kVehicleAddress = addressOf(100);

/// A frame that a station sealed. Its number is its place in the order of sealing.
struct SealedFrame
{
    std::size_t station = 0;
    TimePoint sent;
    bool arrived = false; ///< at the vehicle
};

struct Station
{
    std::unique_ptr<RemoteEnd> end;
    Peer listed; ///< by the agent
    bool isListed = true;
    bool saidYes = false;                                  ///< to a pairing, since the agent's window opened
    std::vector<std::pair<std::size_t, TimePoint>> obeyed; ///< commands in the order of arrival
    std::size_t closed = 0; ///< frames that were sealed before a Close that the agent has accepted, of all stations
};

class AgentFlight
{
public:
    AgentFlight(std::vector<engine::GroundLink> grounds, std::uint8_t settings)
        : m_grounds(std::move(grounds)), m_limits(limitsOf(settings))
    {
        static const auto agent = newIdentity(100);
        auto secrets = std::make_unique<engine::SecretFiles>();
        secrets->identity = agent;
        auto counters = std::make_unique<MemoryCounterStore>();
        m_counters = counters.get();
        secrets->counters = std::move(counters);
        for (std::size_t i = 0; i < kStations; ++i) {
            static const std::shared_ptr<const crypto::X25519KeyPair> keys[] = {newIdentity(1), newIdentity(2), newIdentity(3)};
            Station &station = m_stations[i];
            station.listed.key = publicKeyOf(*keys[i]);
            station.listed.name = "station";
            station.listed.role = i == 1 ? PeerRole::Observer : PeerRole::Pilot;
            secrets->peers.push_back(station.listed);
            Config config;
            config.identity = keys[i];
            config.policy = policyOf(settings & 1);
            config.peers = {{publicKeyOf(*agent), "air", PeerRole::Pilot, {}}};
            station.end = std::make_unique<RemoteEnd>(std::move(config), waysToAgent(),
                                                      Node{static_cast<std::uint8_t>(250 + i), 190}, 10 + i, now());
        }
        engine::AgentConfig config{.vehicle = SimulatedHost::url("udpin:14560"),
                                   .grounds = m_grounds,
                                   .policy = policyOf(settings & 6),
                                   .freshness = m_limits};
        m_agent = std::make_unique<engine::AgentCore>(std::move(config), std::move(secrets),
                                                      [this](const engine::AgentEvent &event) { judge(event); });
        m_agent->start();
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

    void step(ByteReader &in)
    {
        const std::uint8_t operation = in.u8(), argument = in.u8();
        const std::size_t number = operation / 32 % kStations;
        Station &station = m_stations[number];
        const auto anyBytes = [&] { return in.bytes(std::min<std::size_t>(argument, in.remaining())); };
        switch (operation % 32) {
        case 0: return pass(argument * 10ms);
        case 1: return pass(argument * 100ms);
        case 2: return send(number, m_frames.make(argument & 0x7f, in), argument & 0x80);
        case 3: station.end->hold(argument); return pump();
        case 4: return station.end->withholdNewest(); // step 5 delivers it
        case 5: return arrive(station, station.end->repeat(argument));
        case 6: return arrive(station, station.end->changed(argument, in.u8()));
        case 7: return arrive(station, station.end->cut(argument));
        case 8: return arrive(groundLink(0), addressOf(number), anyBytes());
        case 9: return arrive(kVehicleLink, kVehicleAddress, anyBytes());
        case 10:
            return arrive(argument & 0x80 ? lastGround() : groundLink(0), addressOf(number),
                          m_frames.make(argument & 0x7f, in));
        case 11: return setRole(station, argument);
        case 12: {
            const ByteView bytes = anyBytes();
            return bytes.empty() ? void() : send(number, Bytes(bytes.begin(), bytes.end()), false);
        }
        case 13: m_counters->fails = argument & 1; return;
        case 14: station.end->switchSuite(now(), argument); return pump();
        case 15: station.end->close(now(), m_sealed.size()); return pump();
        case 16: m_agent->snapshot(); return pump();
        case 17: return openPairing(number, argument);
        case 18: return decidePairing(station, argument);
        case 19: m_isArmed = argument & 1; return;
        case 20: return reconnect(number);
        case 21: // from a stranger: any bytes, or what a station has sent
            if (argument & 0x80)
                return arrive(ground(argument), addressOf(kFirstStranger + (argument >> 3 & 3)), strangeBytes(in));
            return overhear(station, ground(argument), kFirstStranger + (argument >> 3 & 3), in.u8());
        case 22: // ground links fail, towards the agent and from it
            m_isCut[0] = argument & 15;
            m_isCut[1] = argument >> 4;
            return;
        case 23: station.end->setCalling(now(), argument & 1); return pump();
        case 24: // what a station has sent, on another link
            return overhear(station, ground(argument), number, in.u8());
        default: return;
        }
    }

    static ByteView strangeBytes(ByteReader &in) { return in.bytes(std::min<std::size_t>(in.u8(), in.remaining())); }
    LinkId lastGround() const { return groundLink(m_grounds.size() - 1); }
    LinkId ground(std::size_t choice) const { return groundLink((choice & 7) % m_grounds.size()); }

    // ---- the stations

    /// Where they find the agent. They call where it listens.
    std::vector<RemoteEnd::Way> waysToAgent() const
    {
        std::vector<RemoteEnd::Way> out;
        for (std::size_t i = 0; i < m_grounds.size(); ++i)
            out.push_back({{groundLink(i), addressOf(99), m_grounds[i].carrier}, listensAt(groundLink(i))});
        return out;
    }
    bool listensAt(LinkId link) const { return m_grounds[groundIndex(link)].url.traits().isDatagramServer(); }

    void reconnect(std::size_t number)
    {
        for (std::size_t i = 0; i < m_grounds.size(); ++i) {
            host().reconnect(groundLink(i), addressOf(number));
            m_stations[number].end->reconnect(now(), groundLink(i));
        }
        pump();
    }

    void send(std::size_t number, const Bytes &frames, bool inRecord)
    {
        if (m_stations[number].end->send(now(), frames, inRecord)) {
            mavlink::scanFrames(frames, mavlink::Dialect::builtin(), [&](const mavlink::ScanItem &item) {
                if (!mavlink::isWholeFrame(item))
                    return;
                m_byBytes[Bytes(item.bytes.begin(), item.bytes.end())].push_back(m_sealed.size());
                m_sealed.push_back({number, now()});
            });
        }
        pump();
    }

    void setRole(Station &station, std::uint8_t role)
    {
        station.isListed = role % 3 != 2;
        station.listed.role = role % 3 == 0 ? PeerRole::Pilot : PeerRole::Observer;
        relist();
    }
    void relist()
    {
        std::vector<Peer> peers;
        for (const Station &each : m_stations) {
            if (each.isListed)
                peers.push_back(each.listed);
        }
        m_agent->setPeers(std::move(peers));
        pump();
    }

    void openPairing(std::size_t number, std::uint8_t choice)
    {
        if (choice & 16 && m_agent->openPairing("air", passphraseOf(choice))) {
            m_shown.reset();
            m_saidYes = false;
            for (Station &each : m_stations)
                each.saidYes = false;
        }
        if (choice & 32)
            m_stations[number].end->openPairing(now(), "ground", 255, choice >> 2);
        pump();
    }
    void decidePairing(Station &station, std::uint8_t choice)
    {
        if (choice & 1)
            station.saidYes = station.end->confirmPairing(now()) || station.saidYes;
        if (choice & 2 && m_shown) {
            m_saidYes = true;
            m_agent->confirmPairing(*m_shown);
        }
        if (choice & 4)
            station.end->cancelPairing(now());
        if (choice & 8)
            m_agent->refusePairing();
        pump();
    }
    void takePaired()
    {
        for (const Peer &peer : std::exchange(m_paired, {})) {
            for (Station &station : m_stations) {
                if (station.listed.key == peer.key) {
                    station.listed.presharedKey = peer.presharedKey;
                    station.isListed = true;
                }
            }
            relist();
        }
    }

    // ---- the path

    void arrive(Station &station, const std::optional<RemoteEnd::Block> &block)
    {
        if (!block)
            return;
        deliver(station, *block);
        pump();
    }
    void arrive(LinkId link, const Address &from, ByteView bytes)
    {
        if (link == kVehicleLink)
            host().receive(link, from, bytes);
        else
            takeAtGround(link, from, bytes);
        pump();
    }
    /// A block that this station has sent arrives on another link, or from a stranger.
    void overhear(Station &station, LinkId link, std::size_t from, std::uint8_t choice)
    {
        const auto block = station.end->repeat(choice);
        if (!block)
            return;
        const bool accepted = takeAtGround(link, addressOf(from), block->bytes);
        if (block->closes && accepted)
            station.closed = *block->closes;
        pump();
    }
    void deliver(Station &station, const RemoteEnd::Block &block)
    {
        if (m_isCut[0] >> groundIndex(block.link) & 1)
            return;
        const auto from = addressOf(static_cast<std::size_t>(&station - m_stations.data()));
        if (takeAtGround(block.link, from, block.bytes) && block.closes)
            station.closed = *block.closes;
    }
    /// Returns true if the agent accepted a record. What it causes is collected first: the Close in it counts afterwards.
    bool takeAtGround(LinkId link, const Address &from, ByteView bytes)
    {
        const Carrier carrier = m_grounds[groundIndex(link)].carrier;
        const bool mayBeRecord = carrier != Carrier::Datagram || bytes.empty()
            || messageHead(carrier, bytes) < kAnnouncementHead;
        const auto good = [&] { return mayBeRecord ? m_agent->snapshot().channel.rx.good : 0; };
        m_exchanges.received(link, from, bytes.size());
        const std::uint64_t before = good();
        host().receive(link, from, bytes);
        const bool accepted = good() > before;
        if (accepted)
            m_exchanges.proved(link, from);
        collect();
        return accepted;
    }

    void pass(Duration span)
    {
        for (Duration passed{}; passed < span; passed += kStep) {
            if (now() >= m_nextHeartbeat) {
                m_nextHeartbeat = now() + 1s;
                mavlink::Heartbeat heartbeat{.type = mavlink::MAV_TYPE_QUADROTOR,
                                             .autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA};
                if (m_isArmed)
                    heartbeat.base_mode = mavlink::MAV_MODE_FLAG_SAFETY_ARMED;
                std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
                host().receive(kVehicleLink, kVehicleAddress, m_vehicle.write(heartbeat, buffer));
            }
            for (Station &station : m_stations)
                station.end->handleDeadline(now());
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
            bool moved = !m_toGround.empty();
            for (const SentBlock &sent : std::exchange(m_toGround, {})) {
                if (m_isCut[1] >> groundIndex(sent.link) & 1)
                    continue;
                for (std::size_t i = 0; i < kStations; ++i) {
                    if (isCalled(sent) || sent.to == addressOf(i))
                        m_stations[i].end->receive(now(), sent.link, sent.bytes);
                }
            }
            for (Station &station : m_stations) {
                station.end->poll(now());
                while (const auto block = station.end->next()) {
                    moved = true;
                    deliver(station, *block);
                }
            }
            if (!moved)
                return;
        }
    }

    // ---- the oracles

    void collect()
    {
        for (SentBlock &sent : host().takeSent()) {
            if (sent.link == kVehicleLink) {
                judge(sent.bytes);
            } else {
                judge(sent);
                m_toGround.push_back(std::move(sent));
            }
        }
    }
    /// Whether a block goes to the address that the operator named, or to all at the other end of a stream.
    static bool isCalled(const SentBlock &sent)
    {
        return sent.to == Address{} || sent.to == SimulatedHost::remoteOf(sent.link);
    }

    /// A block for the ground.
    void judge(const SentBlock &sent)
    {
        const std::uint8_t head = messageHead(m_grounds[groundIndex(sent.link)].carrier, sent.bytes);
        if (listensAt(sent.link) && !m_exchanges.hasProved(sent.link, sent.to)
            && (!m_exchanges.hasReceived(sent.link, sent.to) || head == kAnnouncementHead))
            violated("where the agent listens it announces nothing");
        // Openings and words of a pairing go to an end that has received the agent's random id.
        if (!isCalled(sent) && head != kPairingSealedHead)
            m_exchanges.sent(sent.link, sent.to, sent.bytes.size());
    }

    /// A block for the vehicle, which is one frame.
    void judge(const Bytes &block)
    {
        const auto found = m_byBytes.find(block);
        if (found == m_byBytes.end())
            violated("nothing clear commands");
        const char *reason = nullptr;
        for (const std::size_t number : found->second) {
            reason = whyNot(number, block);
            if (!reason)
                return;
        }
        violated(reason);
    }
    /// Takes one of the sealed frames with these bytes as the one that arrived, or returns the oracle that it violates.
    const char *whyNot(std::size_t number, const Bytes &block)
    {
        SealedFrame &frame = m_sealed[number];
        Station &station = m_stations[frame.station];
        if (frame.arrived)
            return "no command comes twice";
        if (!station.isListed)
            return "no station commands that is not listed";
        if (!isHarmless(block)) {
            if (station.listed.role != PeerRole::Pilot)
                return "no observer commands";
            if (number < station.closed)
                return "nothing commands after the close";
            if (m_limits.age && now() - frame.sent > *m_limits.age)
                return "nothing old commands";
            for (const auto &[earlier, arrived] : station.obeyed) {
                if (earlier > number && now() - arrived > m_limits.overtaken)
                    return "nothing overtaken commands";
            }
            station.obeyed.emplace_back(number, now());
        }
        frame.arrived = true;
        return nullptr;
    }

    void judge(const engine::AgentEvent &event)
    {
        const auto *pairing = std::get_if<PairingEvent>(&event);
        if (!pairing)
            return;
        if (const auto *seen = std::get_if<PairingPeerSeen>(pairing))
            m_shown = seen->peer.key;
        const auto *paired = std::get_if<Paired>(pairing);
        if (!paired)
            return;
        const auto saidYes = [&](const Station &station) { return station.saidYes && station.listed.key == paired->peer.key; };
        if (!m_saidYes || m_shown != paired->peer.key || std::none_of(m_stations.begin(), m_stations.end(), saidYes))
            violated("nobody is paired without both people");
        m_paired.push_back(paired->peer);
    }

    std::vector<engine::GroundLink> m_grounds;
    FreshnessLimits m_limits;
    std::array<std::uint8_t, 2> m_isCut{}; ///< ground links that fail, a bit each: towards the agent, and from it
    Exchanges m_exchanges;                 ///< on the ground links
    MemoryCounterStore *m_counters = nullptr;
    std::array<Station, kStations> m_stations;
    std::vector<SealedFrame> m_sealed;
    std::map<Bytes, std::vector<std::size_t>> m_byBytes; ///< into m_sealed
    GroundFrames m_frames;
    std::vector<SentBlock> m_toGround;
    mavlink::FrameWriter m_vehicle{1, 1};
    TimePoint m_nextHeartbeat{};
    bool m_isArmed = false;
    std::optional<channel::PublicKey> m_shown; ///< by the agent's pairing
    bool m_saidYes = false;                    ///< the agent's person, to that key
    std::vector<Peer> m_paired;                ///< to be listed
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
    auto grounds = groundsOf(in.u8());
    AgentFlight flight(std::move(grounds), in.u8());
    flight.run(in);
    return 0;
}
