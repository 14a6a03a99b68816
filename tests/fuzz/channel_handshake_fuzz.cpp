// Handshake messages and announcements in every state of both roles; the input may have its mac1 made good, as an attacker
// who knows the public key can do, and the payloads behind the encryption are read as well.
#include "pair.h"

#include "core/channel/cookie.h"
#include "core/channel/handshake.h"
#include "core/crypto/init_crypto.h"

#include <cstdlib>

using namespace skyseal;
using namespace skyseal::test;

namespace {

std::unique_ptr<Endpoint> endpointOf(Role role, const crypto::X25519KeyPair &own, const crypto::X25519KeyPair &other,
                                     RandomSource &random, CounterStore &counters)
{
    Config config;
    config.role = role;
    config.identity = std::make_shared<crypto::X25519KeyPair>(own.clone());
    Peer peer;
    peer.key = other.publicKey;
    config.peers = {peer};
    config.policy = {defaultSuites(), false, false};
    config.announceTo = {Path{LinkId{1}, {}}};
    return std::make_unique<Endpoint>(std::move(config), random, counters, TimePoint{});
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const bool ready = crypto::initCrypto();
    if (!ready || size < 2)
        return 0;
    SeededRandom random(1);
    const auto station = crypto::X25519KeyPair::generate(random);
    const auto agent = crypto::X25519KeyPair::generate(random);
    MemoryCounterStore counters;
    const bool toAgent = data[0] & 1;
    const bool signIt = data[0] & 2;
    auto endpoint = toAgent ? endpointOf(Role::Agent, agent, station, random, counters)
                            : endpointOf(Role::Station, station, agent, random, counters);
    const Path path{LinkId{1}, {}};
    TimePoint now{};

    Bytes datagram(data + 1, data + size);
    const bool loaded = data[0] & 4; // Cookies are about.
    Bytes first;
    CookieMaker maker(agent.publicKey, random);
    if (!toAgent) { // The station is waiting for an answer.
        auto announcement = Announcement(agent.publicKey).make(random);
        endpoint->handleDatagram(now, path, announcement);
        while (const auto out = endpoint->pollTransmit())
            first.assign(out->bytes.begin(), out->bytes.end());
        if (loaded) {
            auto cookie = maker.make(now, path, first);
            endpoint->handleDatagram(now, path, cookie);
        }
    } else if (loaded) {
        std::optional<Cookie> cookie;
        for (int i = 0; i < 20 && !cookie; ++i) {
            FirstMessage message;
            random.fill(message);
            message[0] = firstByte(HandshakeMessage::First);
            Mac1(agent.publicKey).sign(message);
            const Bytes mac1(message.end() - kMacLength, message.end());
            endpoint->handleDatagram(now, path, message);
            while (const auto out = endpoint->pollTransmit())
                cookie = openCookie(agent.publicKey, mac1, out->bytes);
        }
        if (!cookie)
            std::abort();
        if (data[0] & 8 && datagram.size() > kMacLength)
            signWithCookie(*cookie, datagram);
    }
    if (signIt && datagram.size() > kMacLength)
        Mac1(toAgent ? agent.publicKey : station.publicKey).sign(datagram);
    Bytes copy = datagram;
    if (endpoint->handleDatagram(now, path, copy))
        std::abort();
    if (!endpoint->sessions().empty())
        std::abort(); // Nobody can make a session without the keys.
    endpoint->handleDeadline(now + std::chrono::seconds(1));

    static_cast<void>(FirstPayload::read(datagram));
    static_cast<void>(AnswerPayload::read(datagram));
    static_cast<void>(openCookie(agent.publicKey, agent.publicKey, datagram));
    if (datagram.size() == kFirstLength)
        static_cast<void>(Responder::read(agent, datagram));
    return 0;
}
