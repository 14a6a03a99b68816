// What the two handshake messages carry, encrypted and hashed into the session: connection ids, the suites that each end
// offers, and the counter that makes an old first message worthless.
//
//   first message   flags 1 | connection id 2 | suites 3 | counter 8                      14 bytes
//   answer          flags 1 | connection id 2 | suites 3 | chosen suite 1                  7 bytes
//
// flags: bit 0 research suites allowed, bit 1 plain allowed, bit 2 inline framing allowed, bit 3 inline framing preferred;
// the others are sent as 0 and ignored. suites: six numbers of four bits, best first, low half of a byte first, 0 = none.
#pragma once

#include "core/channel/negotiation.h"
#include "core/channel/wire_format.h"

#include <array>
#include <optional>

namespace skyseal::channel {

struct FirstPayload
{
    static constexpr std::size_t kLength = 14;
    ConnectionId connection{};
    SuiteOffer offer;
    std::uint64_t counter = 0;

    std::array<std::uint8_t, kLength> write() const;
    static std::optional<FirstPayload> read(ByteView bytes);
};

struct AnswerPayload
{
    static constexpr std::size_t kLength = 7;
    ConnectionId connection{};
    SuiteOffer offer;
    crypto::SuiteId chosen{};

    std::array<std::uint8_t, kLength> write() const;
    static std::optional<AnswerPayload> read(ByteView bytes);
};

} // namespace skyseal::channel
