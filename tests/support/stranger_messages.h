// Every kind of datagram that a sender without a key can make, each at its costliest for the receiver: for benchmarks and
// floods. A sender that knows the public keys, and hears the link, can also make the last ones of a group.
#pragma once

#include "core/channel/handshake_messages.h"
#include "core/channel/inline_frame.h"
#include "core/channel/mac1.h"
#include "core/channel/pairing_messages.h"
#include "core/crypto/cpace_generator.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"

#include <algorithm>
#include <array>
#include <random>
#include <string_view>

namespace skyseal::test {

/// The knowledge of a stranger on the wire.
struct StrangersKnowledge
{
    channel::PublicKey receiver{}; ///< the public key of the end that receives
    channel::PublicKey listed{};   ///< the public key of a peer that it lists
    Bytes record;                  ///< one that was sent to that end; empty without a session
    channel::PairingToken token{}; ///< of a call that an agent sent while its pairing window is open
    Bytes sealedInPlace{};         ///< a frame that was sent to that end; empty where the session seals none in place
};

struct StrangerMessage
{
    const char *name;
    Bytes (*make)(const StrangersKnowledge &knows, std::mt19937_64 &random);

    /// MAVLink frames and bytes like them, which no carrier wraps.
    bool isBare() const
    {
        const std::string_view text = name;
        return text.starts_with("clear") || text.starts_with("frame");
    }
};

inline Bytes randomBytes(std::mt19937_64 &random, std::size_t size, int first = -1)
{
    Bytes out(size);
    for (std::uint8_t &byte : out)
        byte = static_cast<std::uint8_t>(random());
    if (first >= 0)
        out[0] = static_cast<std::uint8_t>(first);
    return out;
}

inline Bytes withMac1(const StrangersKnowledge &knows, Bytes message)
{
    channel::Mac1(knows.receiver).sign(message);
    return message;
}

/// A record under the newest epoch and an acceptable counter, with a wrong tag.
inline Bytes forgedRecord(const StrangersKnowledge &knows, std::mt19937_64 &random, std::size_t size)
{
    Bytes out = randomBytes(random, size, 0x50);
    std::copy_n(knows.record.begin(), std::min<std::size_t>(knows.record.size(), 3), out.begin());
    out[3] = out[4] = 0xff;
    out[5] = 0x3f;
    return out;
}

/// A frame under the newest epoch and an acceptable counter, with a wrong tag. The trailer is core/channel/PROTOCOL.md section
/// 12: epoch 1, counter 4, tag 8.
inline Bytes forgedInPlace(const StrangersKnowledge &knows, std::mt19937_64 &random)
{
    Bytes out = knows.sealedInPlace;
    if (out.empty()) {
        out = randomBytes(random, channel::kMaxInlineFrame, 0xfd);
        out[1] = 0xff;
        out[2] = channel::kInlineFlags;
    }
    constexpr std::array<std::uint8_t, 4> kCounter{0xff, 0xff, 0x3f, 0};
    const auto trailer = out.end() - static_cast<std::ptrdiff_t>(channel::kInlineTrailer);
    std::copy(kCounter.begin(), kCounter.end(), trailer + 1);
    std::generate(trailer + 5, out.end(), [&random] { return static_cast<std::uint8_t>(random()); });
    return out;
}

inline Bytes zeroesFrom(std::size_t from, Bytes message)
{
    std::fill(message.begin() + static_cast<std::ptrdiff_t>(from), message.end(), std::uint8_t(0));
    return message;
}

inline Bytes clearCommand()
{
    mavlink::FrameWriter writer(255, 190);
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    const ByteView frame = writer.write(
        mavlink::CommandLong{.target_system = 1, .command = mavlink::MAV_CMD_COMPONENT_ARM_DISARM, .param1 = 1}, buffer);
    return {frame.begin(), frame.end()};
}

inline constexpr StrangerMessage kStrangerMessages[] = {
    {"random bytes", [](const StrangersKnowledge &, std::mt19937_64 &random) { return randomBytes(random, 127); }},
    {"clear MAVLink: a command", [](const StrangersKnowledge &, std::mt19937_64 &) { return clearCommand(); }},
    {"clear MAVLink: 0xFE alone", [](const StrangersKnowledge &, std::mt19937_64 &) { return Bytes(1472, 0xfe); }},
    {"clear MAVLink: 0xFD alone", [](const StrangersKnowledge &, std::mt19937_64 &) { return Bytes(1472, 0xfd); }},
    {"another version", [](const StrangersKnowledge &, std::mt19937_64 &random) { return randomBytes(random, 127, 0x69); }},
    {"part of a message in TUNNEL",
     [](const StrangersKnowledge &, std::mt19937_64 &random) { return randomBytes(random, 128, 0x80); }},
    {"record of no session", [](const StrangersKnowledge &, std::mt19937_64 &random) { return randomBytes(random, 60, 0x50); }},
    {"record of the session, 60 bytes",
     [](const StrangersKnowledge &knows, std::mt19937_64 &random) { return forgedRecord(knows, random, 60); }},
    {"record of the session, 1200 bytes",
     [](const StrangersKnowledge &knows, std::mt19937_64 &random) { return forgedRecord(knows, random, 1200); }},
    {"frame sealed in place",
     [](const StrangersKnowledge &knows, std::mt19937_64 &random) { return forgedInPlace(knows, random); }},
    {"announcement without zeros",
     [](const StrangersKnowledge &, std::mt19937_64 &random) { return randomBytes(random, 127, 0x58); }},
    {"announcement",
     [](const StrangersKnowledge &, std::mt19937_64 &random) { return zeroesFrom(33, randomBytes(random, 127, 0x58)); }},
    {"announcement of a listed agent",
     [](const StrangersKnowledge &knows, std::mt19937_64 &random) {
         struct Source final : RandomSource
         {
             explicit Source(std::mt19937_64 &from) : m_from(from) {}
             void fill(MutableByteView out) override
             {
                 for (std::uint8_t &byte : out)
                     byte = static_cast<std::uint8_t>(m_from());
             }
             std::mt19937_64 &m_from;
         } source(random);
         const auto announcement = channel::Announcement(knows.listed).make(source);
         return Bytes(announcement.begin(), announcement.end());
     }},
    {"first message without mac1",
     [](const StrangersKnowledge &, std::mt19937_64 &random) { return randomBytes(random, 127, 0x59); }},
    {"first message with mac1",
     [](const StrangersKnowledge &knows, std::mt19937_64 &random) { return withMac1(knows, randomBytes(random, 127, 0x59)); }},
    {"answer",
     [](const StrangersKnowledge &knows, std::mt19937_64 &random) { return withMac1(knows, randomBytes(random, 77, 0x5a)); }},
    {"number",
     [](const StrangersKnowledge &knows, std::mt19937_64 &random) { return withMac1(knows, randomBytes(random, 72, 0x5b)); }},
    {"cookie without zeros",
     [](const StrangersKnowledge &, std::mt19937_64 &random) { return randomBytes(random, 127, 0x5b); }},
    {"cookie",
     [](const StrangersKnowledge &, std::mt19937_64 &random) { return zeroesFrom(49, randomBytes(random, 127, 0x5b)); }},
    {"pairing: request",
     [](const StrangersKnowledge &, std::mt19937_64 &) {
         const auto request = channel::pairingRequest();
         return Bytes(request.begin(), request.end());
     }},
    {"pairing: call",
     [](const StrangersKnowledge &, std::mt19937_64 &random) { return zeroesFrom(17, randomBytes(random, 127, 0x5c)); }},
    {"pairing: first message",
     [](const StrangersKnowledge &, std::mt19937_64 &random) { return zeroesFrom(53, randomBytes(random, 127, 0x5d)); }},
    {"pairing: first message to a call",
     [](const StrangersKnowledge &knows, std::mt19937_64 &random) {
         static const channel::PairingShare share = crypto::cpaceGenerator({});
         const auto first = channel::pairingFirst(
             {channel::PairingId{static_cast<std::uint32_t>(random())}, share, knows.token});
         return Bytes(first.begin(), first.end());
     }},
    {"pairing: answer", [](const StrangersKnowledge &, std::mt19937_64 &random) { return randomBytes(random, 69, 0x5e); }},
    {"pairing: opening", [](const StrangersKnowledge &, std::mt19937_64 &random) { return randomBytes(random, 95, 0x5f); }},
    {"pairing: word", [](const StrangersKnowledge &, std::mt19937_64 &random) { return randomBytes(random, 22, 0x5f); }},
};

} // namespace skyseal::test
