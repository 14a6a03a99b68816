// Cost of each kind of message that anyone can send, without a key, to a station with the longest list of peers and to an
// agent: nanoseconds of CPU time for one, and bytes of state after a flood of them from as many addresses. Datagrams, the same
// messages in COBS and in TUNNEL, streams without an end, frames sealed in place, pairing open and closed.
#include "core/channel/endpoint.h"
#include "inline_pair.h"

#include "core/channel/pairing.h"
#include "core/crypto/init_crypto.h"
#include "core/engine/common/ingress.h"
#include "tests/support/idle_link.h"
#include "tests/support/stranger_messages.h"
#include "tests/support/stranger_wire.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <malloc.h>
#include <new>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

std::atomic<std::int64_t> liveBytes = 0;

} // namespace

void *operator new(std::size_t size)
{
    void *memory = std::malloc(size);
    if (!memory)
        throw std::bad_alloc();
    liveBytes += static_cast<std::int64_t>(malloc_usable_size(memory));
    return memory;
}

void operator delete(void *memory) noexcept
{
    liveBytes -= static_cast<std::int64_t>(malloc_usable_size(memory));
    std::free(memory);
}

void operator delete(void *memory, std::size_t) noexcept
{
    operator delete(memory);
}

namespace {

constexpr LinkId kLink{1};
constexpr std::size_t kListed = 256;
constexpr int kMessages = 2048; ///< of one timing, from as many addresses
constexpr int kRounds = 9;

/// One end that receives: its ingress, endpoint, and pairing while it is open.
class Receiver final : public engine::IngressSink
{
public:
    Receiver(Side side, Carrier carrier, bool inPlace, const engine::IngressRules &rules, const char *url, bool pairing)
        : m_side(side), m_pair(optionsOf(carrier, inPlace)), m_link(url, kLink),
          m_ingress(mavlink::Dialect::builtin(), m_carriers)
    {
        m_pair.run(2s, [this] { return m_pair.bothUp(); });
        m_pair.link.attacker = [this](TimePoint, SentDatagram &flight) {
            if (flight.from != m_side && channel::Endpoint::ownsFrame(flight.bytes))
                m_knows.sealedInPlace = flight.bytes;
            else if (flight.from != m_side && flight.bytes[0] < 0x58)
                m_knows.record = flight.bytes;
            return true;
        };
        if (inPlace) {
            m_pair.ground().switchSuite(m_pair.now, SuiteId::Aes256Ctr);
            m_pair.every(100ms, [this] { m_pair.sendFrame(m_side == Ground ? Air : Ground, 255); });
        }
        m_pair.run(2s);
        m_pair.stopTraffic();
        if (inPlace && m_knows.sealedInPlace.empty())
            std::abort(); // the rows would name what was not measured
        m_knows.receiver = end().publicKey();
        m_knows.listed = m_pair.configOf(side).peers.front().key;
        std::vector<channel::Peer> peers;
        for (std::size_t i = 0; i + 1 < kListed; ++i) {
            channel::PublicKey key;
            m_random.fill(key);
            peers.push_back({key, "peer-" + std::to_string(i), {}, {}, {}});
        }
        peers.push_back(m_pair.configOf(side).peers.front());
        end().setPeers(m_pair.now, std::move(peers));
        if (pairing) {
            channel::PairingConfig config;
            config.role = side == Ground ? channel::Role::Station : channel::Role::Agent;
            config.identity = end().identity;
            config.callTo = {peersPath()};
            if (side == Air)
                config.listensOn = {kLink}; // so that it answers requests
            m_pairing.emplace(std::move(config), m_random, m_pair.now);
            m_pairing->handleDeadline(m_pair.now);
            noteCalls();
        }
        m_ingress.addLink(kLink, rules, *this);
    }

    const StrangersKnowledge &knows() const { return m_knows; }
    /// Where the session's peer sends from: on a stream, strangers send from there as well.
    Path peersPath() const { return m_pair.pathOf(m_side == Ground ? Air : Ground); }
    void take(const Path &path, Bytes &bytes) { m_ingress.take(m_link, {path, bytes, m_pair.now}); }
    /// A flood of 50,000 a second.
    void pass() { m_pair.now += 20us; }

private:
    static PairOptions optionsOf(Carrier carrier, bool inPlace)
    {
        PairOptions out = inPlace ? inlineOptions() : PairOptions{};
        out.carrier = carrier;
        return out;
    }
    Pair::End &end() { return m_pair.ends[m_side]; }
    void noteCalls()
    {
        while (const auto sent = m_pairing->pollTransmit())
            m_knows.token = channel::calledToken(sent->bytes).value_or(m_knows.token);
    }

    bool takePairing(const link::Link &, const link::ReceivedBlock &message) override
    {
        if (!m_pairing || message.bytes.empty() || !channel::Pairing::owns(message.bytes[0]))
            return false;
        m_pairing->handleDatagram(message.time, message.path, message.bytes);
        noteCalls();
        while (m_pairing->pollEvent()) {}
        return true;
    }
    bool namesSession(ByteView message) const override { return m_pair.ends[m_side].endpoint->namesSerialSession(message); }
    bool takeRecord(const link::Link &, const link::ReceivedBlock &message) override
    {
        channel::Endpoint &endpoint = *end().endpoint;
        const bool opened = endpoint.handleDatagram(message.time, message.path, message.bytes).has_value();
        while (endpoint.pollTransmit()) {}
        while (endpoint.pollEvent()) {}
        return opened;
    }
    void takeSealedInPlace(const link::Link &, const link::ReceivedBlock &frame) override
    {
        channel::Endpoint &endpoint = *end().endpoint;
        endpoint.handleInlineFrame(frame.time, frame.path, frame.bytes);
        while (endpoint.pollEvent()) {}
    }
    void takeClear(const link::Link &, const link::ReceivedBlock &, const mavlink::ScanItem &) override {}

    Side m_side;
    Pair m_pair;
    SeededRandom m_random{5};
    StrangersKnowledge m_knows;
    IdleLink m_link;
    engine::CarrierWriter m_carriers;
    engine::Ingress m_ingress;
    std::optional<channel::Pairing> m_pairing;
};

double cpuNanoseconds()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e9 + static_cast<double>(time.tv_nsec);
}

/// The best of several rounds for the time, and what the flood left in memory.
void measure(const char *end, const char *carrier, const char *name, Receiver &receiver, bool isStream,
             const std::function<Bytes(std::mt19937_64 &)> &make)
{
    std::mt19937_64 random(11);
    std::vector<Bytes> messages;
    for (int i = 0; i < kMessages; ++i)
        messages.push_back(make(random));
    Path path{kLink, {}};
    path.remote = receiver.peersPath().remote;
    if (!isStream)
        path.remote.ip = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff, 10, 0, 0, 1};
    double best = 0;
    std::int64_t state = 0;
    for (int round = 0; round < kRounds; ++round) {
        std::vector<Bytes> copies = messages; // they may be opened in place
        const std::int64_t before = liveBytes;
        const double begun = cpuNanoseconds();
        for (Bytes &bytes : copies) {
            if (!isStream) {
                path.remote.port = static_cast<std::uint16_t>(path.remote.port + 1);
                path.remote.ip[14] = static_cast<std::uint8_t>(path.remote.ip[14] + 1);
            }
            receiver.take(path, bytes);
            receiver.pass();
        }
        const double took = (cpuNanoseconds() - begun) / kMessages;
        best = round == 0 ? took : std::min(best, took);
        state = std::max(state, liveBytes - before);
    }
    std::printf("| %s | %s | %s | %.0f | %lld |\n", end, carrier, name, best, static_cast<long long>(state));
}

} // namespace

int main()
{
    if (!crypto::initCrypto())
        return 1;
    std::printf("| receiver | carrier | message | ns | bytes of state |\n|---|---|---|---|---|\n");
    const engine::IngressRules stationDatagrams{.takesDatagrams = true, .takesTunnel = true, .dropsNodeHeartbeats = true};
    const engine::IngressRules stationStream{
        .isStream = true, .takesCobs = true, .takesTunnel = true, .clear = engine::ClearScan::UnlessCobs};
    const engine::IngressRules agentDatagrams{.takesDatagrams = true, .clear = engine::ClearScan::Never};
    const engine::IngressRules agentStream{.isStream = true, .takesCobs = true, .clear = engine::ClearScan::Never};
    const engine::IngressRules agentInPlace{.takesDatagrams = true};
    const engine::IngressRules agentTunnel{.takesTunnel = true};
    struct Setup
    {
        const char *end, *name;
        Side side;
        Carrier carrier;
        engine::IngressRules rules;
        bool inPlace = false;
    };
    const Setup setups[] = {
        {"station", "datagram", Ground, Carrier::Datagram, stationDatagrams},
        {"station", "serial", Ground, Carrier::Serial, stationStream},
        {"station", "TUNNEL", Ground, Carrier::Tunnel, stationDatagrams},
        {"agent", "datagram", Air, Carrier::Datagram, agentDatagrams},
        {"agent", "serial", Air, Carrier::Serial, agentStream},
        {"agent", "TUNNEL", Air, Carrier::Tunnel, agentTunnel},
        {"station", "datagram, in place", Ground, Carrier::Datagram, stationDatagrams, true},
        {"agent", "datagram, in place", Air, Carrier::Datagram, agentInPlace, true},
    };
    for (const Setup &setup : setups) {
        const char *url = setup.rules.isStream ? "tcp:127.0.0.1:1" : "udpin:127.0.0.1:0";
        for (const bool pairing : {false, true}) {
            const std::string carrier = std::string(setup.name) + (pairing ? ", pairing open" : "");
            for (const StrangerMessage &message : kStrangerMessages) {
                Receiver receiver(setup.side, setup.carrier, setup.inPlace, setup.rules, url, pairing);
                measure(setup.end, carrier.c_str(), message.name, receiver, setup.rules.isStream, [&](std::mt19937_64 &random) {
                    const Bytes bytes = message.make(receiver.knows(), random);
                    return message.isBare() ? bytes : onTheWire(setup.carrier, bytes);
                });
            }
            if (!setup.rules.isStream)
                continue;
            Receiver receiver(setup.side, setup.carrier, setup.inPlace, setup.rules, url, pairing);
            measure(setup.end, carrier.c_str(), "1460 bytes of COBS without an end", receiver, true,
                    [&](std::mt19937_64 &) { return Bytes(1460, 1); });
        }
    }
    return 0;
}
