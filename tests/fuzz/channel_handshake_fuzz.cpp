// An endpoint of either role without a session, and all that can reach it. The input is a list of operations: datagrams as
// they are, with a MAC made good as anyone can do who knows the public key, or under a cookie; messages of the peer itself
// with whatever payload the fuzzer wants; floods, repetitions, time. Without the peer's key there is never a session, nor
// more to send than was received; and no frame comes out in any case.
#include "pair.h"

#include "core/base/byte_reader.h"
#include "core/channel/cookie.h"
#include "core/channel/endpoint.h"
#include "core/channel/handshake.h"
#include "core/crypto/init_crypto.h"

#include <algorithm>
#include <cstdlib>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

void must(bool holds)
{
    if (!holds)
        std::abort();
}

/// As in the known answers of PROTOCOL.md, so that these are good seeds.
Key32 counted(std::uint8_t first)
{
    Key32 out;
    for (std::size_t i = 0; i < out.size(); ++i)
        out.mutableView()[i] = static_cast<std::uint8_t>(first + i);
    return out;
}

struct Keys
{
    std::shared_ptr<const crypto::X25519KeyPair> station = std::make_shared<crypto::X25519KeyPair>(
        crypto::X25519KeyPair::fromSecret(counted(0x00)));
    std::shared_ptr<const crypto::X25519KeyPair> agent = std::make_shared<crypto::X25519KeyPair>(
        crypto::X25519KeyPair::fromSecret(counted(0x20)));
    std::shared_ptr<const Key32> preshared = std::make_shared<Key32>(counted(0x80));
};

class ViewState
{
public:
    ViewState(const Keys &keys, Role role, Carrier carrier)
        : m_keys(keys), m_agentIsHere(role == Role::Agent), m_own(m_agentIsHere ? *keys.agent : *keys.station),
          m_peer{(m_agentIsHere ? keys.station : keys.agent)->publicKey, "peer", PeerRole::Pilot, {}, keys.preshared},
          m_endpoint(config(role), m_random, m_counters, m_now), m_maker(keys.agent->publicKey, m_random)
    {
        m_path.remote.ip[15] = 1;
        m_path.carrier = carrier;
    }

    void act(std::uint8_t operation, ByteView bytes)
    {
        Bytes datagram(bytes.begin(), bytes.end());
        switch (operation % 9) {
        case 0: readPayloads(datagram); return take(std::move(datagram));
        case 1:
            if (datagram.size() > kMacLength)
                Mac1(m_own.publicKey).sign(datagram);
            return take(std::move(datagram));
        case 2: return underCookie(std::move(datagram));
        case 3: return peerSpeaks(bytes, kAnswerLength);
        case 4: return peerSpeaks(bytes, m_agentIsHere ? kAnswerLength : kNumberLength);
        case 5: // time passes
            m_now += std::chrono::milliseconds(operation * 20);
            m_endpoint.handleDeadline(m_now);
            return pump();
        case 6: return m_agentIsHere ? load() : announce(bytes);
        case 7: // once more, from elsewhere
            m_path.remote.port = operation;
            return take(m_last);
        default: m_endpoint.setPeers(m_now, bytes.empty() ? std::vector<Peer>() : std::vector<Peer>{m_peer}); return pump();
        }
    }

private:
    Config config(Role role) const
    {
        Config out;
        out.role = role;
        out.identity = m_agentIsHere ? m_keys.agent : m_keys.station;
        out.peers = {m_peer};
        out.policy = {defaultSuites(), true, false};
        out.announceTo = {Path{LinkId{1}, {}}};
        return out;
    }

    static void readPayloads(ByteView bytes)
    {
        static_cast<void>(FirstPayload::read(bytes));
        static_cast<void>(AnswerPayload::read(bytes));
        static_cast<void>(NumberPayload::read(bytes));
    }

    void take(Bytes datagram)
    {
        m_last = datagram;
        m_in += datagram.size();
        must(!m_endpoint.handleDatagram(m_now, m_path, datagram));
        pump();
    }

    void pump()
    {
        while (const auto transmit = m_endpoint.pollTransmit()) {
            const ByteView sent = transmit->bytes;
            if (sent[0] == firstByte(HandshakeMessage::Announcement))
                continue;
            m_out += sent.size();
            if (sent[0] == firstByte(HandshakeMessage::First))
                m_first.assign(sent.begin(), sent.end());
            else if (m_agentIsHere && m_last.size() == kFirstLength)
                m_cookie = openCookie(m_keys.agent->publicKey, ByteView(m_last).last(kMacLength), sent).value_or(m_cookie);
        }
        while (m_endpoint.pollEvent())
            continue;
        must(m_endpoint.sessions().empty() || (m_peerSpoke && !m_agentIsHere)); // An agent's waits for a record.
        must(m_peerSpoke || m_out <= m_in);
    }

    /// To the agent a message under its newest cookie; to the station a cookie for its newest message.
    void underCookie(Bytes datagram)
    {
        if (m_agentIsHere) {
            if (datagram.size() > kMacLength)
                signWithCookie(m_cookie, datagram);
            return take(std::move(datagram));
        }
        if (m_first.empty())
            return;
        const CookieMessage cookie = m_maker.make(m_now, m_path, m_first);
        take(Bytes(cookie.begin(), cookie.end()));
    }

    noise::HandshakeState peersNoise() const
    {
        std::string prologue("skyseal channel v1");
        prologue.push_back(static_cast<char>(m_path.carrier));
        auto out = m_agentIsHere ? noise::HandshakeState::initiator(asBytes(prologue), m_keys.station->clone(), m_own.publicKey)
                                 : noise::HandshakeState::responder(asBytes(prologue), m_keys.agent->clone());
        out.setPsk(m_keys.preshared->clone());
        return out;
    }

    /// A first message, or an answer or number to one, with this payload.
    void peerSpeaks(ByteView bytes, std::size_t answerLength)
    {
        noise::HandshakeState noise = peersNoise();
        Bytes datagram(m_agentIsHere ? kFirstLength : answerLength);
        std::size_t head = 1;
        datagram[0] = firstByte(m_agentIsHere                       ? HandshakeMessage::First
                                    : answerLength == kNumberLength ? HandshakeMessage::Cookie
                                                                    : HandshakeMessage::Answer);
        if (!m_agentIsHere) {
            std::array<std::uint8_t, FirstPayload::kLength> asked{};
            if (m_first.empty() || !noise.readMessage(ByteView(m_first).subspan(1, kFirstNoiseLength), asked))
                return;
            std::copy_n(asked.begin() + 1, 2, datagram.begin() + 1); // its connection id
            head = 3;
        }
        const std::size_t room = datagram.size() - head - kMacLength;
        Bytes payload(room - (m_agentIsHere ? noise::kFirstOverhead : noise::kSecondOverhead));
        std::copy_n(bytes.begin(), std::min(bytes.size(), payload.size()), payload.begin());
        must(noise.writeMessage(payload, MutableByteView(datagram).subspan(head, room), m_random).has_value());
        Mac1(m_own.publicKey).sign(datagram);
        m_peerSpoke = true;
        take(std::move(datagram));
    }

    /// So many first messages with a right mac1 that cookies are given out.
    void load()
    {
        for (int i = 0; i < 12; ++i) {
            Bytes message(kFirstLength, static_cast<std::uint8_t>(i + 1));
            message[0] = firstByte(HandshakeMessage::First);
            Mac1(m_own.publicKey).sign(message);
            take(std::move(message));
        }
    }

    void announce(ByteView bytes)
    {
        m_path.remote.port = bytes.empty() ? 0 : bytes[0];
        const auto announcement = Announcement(m_peer.key).make(m_random);
        take(Bytes(announcement.begin(), announcement.end()));
    }

    const Keys &m_keys;
    const bool m_agentIsHere;
    const crypto::X25519KeyPair &m_own;
    const Peer m_peer;
    SeededRandom m_random{1};
    MemoryCounterStore m_counters;
    TimePoint m_now{1h};
    Path m_path{LinkId{1}, {}};
    Endpoint m_endpoint;
    CookieMaker m_maker;
    Cookie m_cookie{};
    Bytes m_first; ///< the newest of the station
    Bytes m_last;  ///< what came last
    std::uint64_t m_in = 0, m_out = 0;
    bool m_peerSpoke = false;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const bool ready = crypto::initCrypto();
    must(ready);
    static const Keys keys;
    ByteReader in(ByteView(data, size));
    const std::uint8_t how = in.u8();
    ViewState view(keys, how & 1 ? Role::Agent : Role::Station, static_cast<Carrier>(1 + (how >> 1) % 3));
    for (int count = 0; count < 24 && !in.atEnd() && in.ok(); ++count) {
        const std::uint8_t operation = in.u8();
        view.act(operation, in.bytes(std::min<std::size_t>(in.u8(), in.remaining())));
    }
    return 0;
}
