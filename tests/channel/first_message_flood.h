// A flood of first messages by a sender that knows the agent's public key, and the answers to it.
#pragma once

#include "core/channel/cookie.h"
#include "core/channel/handshake_messages.h"
#include "pair.h"

#include <map>

namespace skyseal::test {

using namespace std::chrono_literals;

inline constexpr int kFloodPerMillisecond = 20;

inline Path addressNumber(std::uint32_t number)
{
    Path path{LinkId{1}, {}};
    path.remote.ip = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff, 10, 0, 0, 0};
    for (unsigned i = 0; i < 3; ++i)
        path.remote.ip[13 + i] = static_cast<std::uint8_t>(number >> 8 * i);
    path.remote.port = static_cast<std::uint16_t>(1024 + number);
    return path;
}

/// A sender that knows the agent's public key: its first messages have a valid mac1 and random bytes behind it.
class Flood
{
public:
    Flood(Pair &pair, std::uint32_t addresses) : m_pair(pair), m_addresses(addresses), m_mac(pair.air().publicKey()) {}

    void sendOne()
    {
        FirstMessage message;
        m_random.fill(message);
        message[0] = firstByte(HandshakeMessage::First);
        m_mac.sign(message);
        const std::uint32_t from = ++m_next % m_addresses;
        const bool real = m_answersCookies && m_cookies.contains(from);
        if (real)
            signWithCookie(m_cookies[from], message);
        give(from, message);
        while (const auto out = m_pair.air().pollTransmit()) {
            if (out->to != addressNumber(from)) { // addressed to others: normal traffic of the agent
                m_pair.link.send(m_pair.now, {Air, m_pair.air().port, 0, Bytes(out->bytes.begin(), out->bytes.end())});
                continue;
            }
            bytesOut += out->bytes.size();
            const auto cookie = openCookie(m_pair.air().publicKey(), ByteView(message).last(16), out->bytes);
            if (cookie && m_answersCookies)
                m_cookies[from] = *cookie;
            cookies += cookie.has_value();
        }
    }
    void answerCookies() { m_answersCookies = true; }

    std::uint64_t bytesIn = 0;
    std::uint64_t bytesOut = 0;
    std::uint64_t cookies = 0;

private:
    void give(std::uint32_t from, FirstMessage message)
    {
        bytesIn += message.size();
        m_pair.air().handleDatagram(m_pair.now, addressNumber(from), message);
    }

    Pair &m_pair;
    std::uint32_t m_addresses;
    Mac1 m_mac;
    SeededRandom m_random{99};
    std::uint32_t m_next = 0;
    bool m_answersCookies = false;
    std::map<std::uint32_t, Cookie> m_cookies;
};

/// Floods an agent for two seconds before the station starts. Returns whether the session is up within three seconds.
inline bool connectsIn(Pair &pair, Flood &flood, Duration before = 2s)
{
    pair.every(1ms, [&flood] {
        for (int i = 0; i < kFloodPerMillisecond; ++i)
            flood.sendOne();
    });
    pair.kill(Ground);
    pair.run(before);
    pair.start(Ground);
    return pair.run(3s, [&] { return pair.bothUp(); });
}

} // namespace skyseal::test
