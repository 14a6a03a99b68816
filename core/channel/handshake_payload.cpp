#include "core/channel/handshake_payload.h"

#include "core/base/byte_reader.h"
#include "core/base/byte_writer.h"
#include "core/channel/suite_list.h"

#include <algorithm>

namespace skyseal::channel {

namespace {

enum Flag : std::uint8_t { ResearchAllowed = 1, PlainAllowed = 2, InlineAllowed = 4, InlinePreferred = 8 };

void writeCounter(ByteWriter &out, std::uint64_t counter)
{
    out.u32(static_cast<std::uint32_t>(counter));
    out.u8(static_cast<std::uint8_t>(counter >> 32));
}

std::uint64_t readCounter(ByteReader &in)
{
    const std::uint64_t low = in.u32();
    return low | static_cast<std::uint64_t>(in.u8()) << 32;
}

void writeHead(ByteWriter &out, ConnectionId connection, const SuiteOffer &offer)
{
    const int suites = (offer.allowResearch ? ResearchAllowed : 0) | (offer.allowPlain ? PlainAllowed : 0);
    const int framings = (offer.allowInline ? InlineAllowed : 0) | (offer.preferInline ? InlinePreferred : 0);
    out.u8(static_cast<std::uint8_t>(suites | framings));
    out.u16(static_cast<std::uint16_t>(connection));
    std::vector<std::uint8_t> numbers;
    for (const crypto::SuiteId suite : offer.suites)
        numbers.push_back(static_cast<std::uint8_t>(suite));
    out.bytes(packSuiteNumbers(numbers)); // all of them fit: offerOf() cuts the list
}

void readHead(ByteReader &in, ConnectionId &connection, SuiteOffer &offer)
{
    const std::uint8_t flags = in.u8();
    offer.allowResearch = flags & ResearchAllowed;
    offer.allowPlain = flags & PlainAllowed;
    offer.allowInline = flags & InlineAllowed;
    offer.preferInline = offer.allowInline && (flags & InlinePreferred);
    connection = ConnectionId{in.u16()};
    SuiteListField field{};
    const ByteView list = in.bytes(field.size());
    std::copy(list.begin(), list.end(), field.begin());
    for (const std::uint8_t number : unpackSuiteNumbers(field)) {
        // A suite that this build does not know is one that it does not offer, so it can be left out.
        if (const auto suite = crypto::suiteFromNumber(number))
            offer.suites.push_back(*suite);
    }
}

} // namespace

std::array<std::uint8_t, FirstPayload::kLength> FirstPayload::write() const
{
    std::array<std::uint8_t, kLength> out{};
    ByteWriter writer(out);
    writeHead(writer, connection, offer);
    writeCounter(writer, counter);
    return out;
}

std::optional<FirstPayload> FirstPayload::read(ByteView bytes)
{
    FirstPayload payload;
    ByteReader in(bytes);
    readHead(in, payload.connection, payload.offer);
    payload.counter = readCounter(in);
    if (!in.ok() || !in.atEnd())
        return std::nullopt;
    return payload;
}

std::array<std::uint8_t, AnswerPayload::kLength> AnswerPayload::write() const
{
    std::array<std::uint8_t, kLength> out{};
    ByteWriter writer(out);
    writeHead(writer, connection, offer);
    writer.u8(static_cast<std::uint8_t>(chosen));
    return out;
}

std::optional<AnswerPayload> AnswerPayload::read(ByteView bytes)
{
    AnswerPayload payload;
    ByteReader in(bytes);
    readHead(in, payload.connection, payload.offer);
    const auto chosen = crypto::suiteFromNumber(in.u8());
    if (!in.ok() || !in.atEnd() || !chosen)
        return std::nullopt;
    payload.chosen = *chosen;
    return payload;
}

std::array<std::uint8_t, NumberPayload::kLength> NumberPayload::write() const
{
    std::array<std::uint8_t, kLength> out{};
    ByteWriter writer(out);
    writeCounter(writer, std::min(lastSeen, kGreatestCounter));
    return out;
}

std::optional<NumberPayload> NumberPayload::read(ByteView bytes)
{
    ByteReader in(bytes);
    const NumberPayload payload{readCounter(in)};
    return in.ok() && in.atEnd() ? std::optional(payload) : std::nullopt;
}

} // namespace skyseal::channel
