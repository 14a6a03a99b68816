#include "core/channel/handshake_payload.h"

#include "core/base/byte_reader.h"
#include "core/base/byte_writer.h"

#include <algorithm>

namespace skyseal::channel {

namespace {

enum Flag : std::uint8_t { ResearchAllowed = 1, PlainAllowed = 2, InlineAllowed = 4, InlinePreferred = 8 };

void writeHead(ByteWriter &out, ConnectionId connection, const SuiteOffer &offer)
{
    const int suites = (offer.allowResearch ? ResearchAllowed : 0) | (offer.allowPlain ? PlainAllowed : 0);
    const int framings = (offer.allowInline ? InlineAllowed : 0) | (offer.preferInline ? InlinePreferred : 0);
    out.u8(static_cast<std::uint8_t>(suites | framings));
    out.u16(static_cast<std::uint16_t>(connection));
    const auto number = [&](std::size_t i) { return i < offer.suites.size() ? static_cast<unsigned>(offer.suites[i]) : 0u; };
    for (std::size_t i = 0; i < kMaxOfferedSuites; i += 2)
        out.u8(static_cast<std::uint8_t>(number(i) | number(i + 1) << 4));
}

void readHead(ByteReader &in, ConnectionId &connection, SuiteOffer &offer)
{
    const std::uint8_t flags = in.u8();
    offer.allowResearch = flags & ResearchAllowed;
    offer.allowPlain = flags & PlainAllowed;
    offer.allowInline = flags & InlineAllowed;
    offer.preferInline = offer.allowInline && (flags & InlinePreferred);
    connection = ConnectionId{in.u16()};
    for (std::size_t i = 0; i < kMaxOfferedSuites / 2; ++i) {
        const std::uint8_t pair = in.u8();
        for (const unsigned number : {pair & 15u, pair >> 4 & 15u}) {
            // A suite that this build does not know is one that it does not offer, so it may be skipped.
            const auto suite = crypto::suiteFromNumber(static_cast<std::uint8_t>(number));
            const bool known = suite && *suite != crypto::SuiteId::None;
            if (known && std::find(offer.suites.begin(), offer.suites.end(), *suite) == offer.suites.end())
                offer.suites.push_back(*suite);
        }
    }
}

} // namespace

std::array<std::uint8_t, FirstPayload::kLength> FirstPayload::write() const
{
    std::array<std::uint8_t, kLength> out{};
    ByteWriter writer(out);
    writeHead(writer, connection, offer);
    writer.u64(counter);
    return out;
}

std::optional<FirstPayload> FirstPayload::read(ByteView bytes)
{
    FirstPayload payload;
    ByteReader in(bytes);
    readHead(in, payload.connection, payload.offer);
    payload.counter = in.u64();
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

} // namespace skyseal::channel
