// Payloads of the two handshake messages (PROTOCOL.md, section 4), encrypted and bound to the session by the handshake hash.
//
//   first message   flags 1 | connection id 2 | suites 6 | counter 5                      14 bytes
//   answer          flags 1 | connection id 2 | suites 6 | chosen suite 1                 10 bytes
//   number          counter 5                                                              5 bytes
//
// flags: bit 0 research suites allowed, bit 1 plain allowed, bit 2 inline framing allowed, bit 3 inline framing preferred;
// the others are sent as 0 and ignored when received. suites: see suite_list.h.
#pragma once

#include "core/channel/negotiation.h"
#include "core/channel/wire_format.h"

#include <array>
#include <optional>

namespace skyseal::channel {

/// Greatest handshake counter that the five bytes of a message can carry.
inline constexpr std::uint64_t kGreatestCounter = (std::uint64_t(1) << 40) - 1;

struct FirstPayload
{
    static constexpr std::size_t kLength = 14;
    ConnectionId connection{};
    SuiteOffer offer;
    std::uint64_t counter = 0; ///< 1 to kGreatestCounter

    std::array<std::uint8_t, kLength> write() const;
    /// Returns nullopt if the length is wrong. Suites that this build does not know are left out of the offer.
    static std::optional<FirstPayload> read(ByteView bytes);
};

struct AnswerPayload
{
    static constexpr std::size_t kLength = 10;
    ConnectionId connection{};
    SuiteOffer offer;
    crypto::SuiteId chosen{};

    std::array<std::uint8_t, kLength> write() const;
    /// Returns nullopt if the length is wrong or the chosen suite is unknown.
    static std::optional<AnswerPayload> read(ByteView bytes);
};

struct NumberPayload
{
    static constexpr std::size_t kLength = 5;
    std::uint64_t lastSeen = 0; ///< greatest counter that the agent remembers; written as kGreatestCounter at most

    std::array<std::uint8_t, kLength> write() const;
    static std::optional<NumberPayload> read(ByteView bytes);
};

} // namespace skyseal::channel
