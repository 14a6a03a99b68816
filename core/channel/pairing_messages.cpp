#include "core/channel/pairing_messages.h"

#include "core/base/byte_reader.h"
#include "core/base/byte_writer.h"
#include "core/base/printable.h"
#include "core/crypto/hash.h"
#include "core/noise/cipher_state.h"

#include <algorithm>
#include <cstdio>

namespace skyseal::channel {

namespace {

constexpr std::uint8_t kWordMark = 0x80; ///< of a word's number, which is 0 for an opening
constexpr std::uint32_t kCodes = 1'000'000;

static_assert(kOpeningLength == kSealedHead + PairingOpening::kLength + noise::kTagLength);
static_assert(kWordLength == kSealedHead + noise::kTagLength);

PairingId idIn(ByteView datagram)
{
    ByteReader in(datagram.subspan(1, 4));
    return PairingId{in.u32()};
}

/// Cut between two characters of UTF-8.
std::string_view fitting(std::string_view name)
{
    if (name.size() <= kMaxPairingName)
        return name;
    std::size_t size = kMaxPairingName;
    while (size > 0 && (static_cast<std::uint8_t>(name[size]) & 0xc0) == 0x80)
        --size;
    return name.substr(0, size);
}

/// Characters that the peers file accepts, so that a received name can be stored.
char fitCharacter(char c)
{
    const bool fits = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_'
        || c == '.' || static_cast<std::uint8_t>(c) >= 0x80;
    return fits ? c : '-';
}

} // namespace

PairingOpening::Bytes PairingOpening::write() const
{
    Bytes out{};
    ByteWriter writer(out);
    writer.bytes(key);
    writer.u8(systemId);
    const std::string_view sent = fitting(name);
    std::copy(sent.begin(), sent.end(), writer.reserve(kMaxPairingName).begin());
    writer.bytes(nonce);
    return out;
}

PairingOpening PairingOpening::read(const Bytes &bytes)
{
    ByteReader in(bytes);
    PairingOpening out;
    std::ranges::copy(in.bytes(out.key.size()), out.key.begin());
    out.systemId = in.u8();
    const std::string_view sent = asText(in.bytes(kMaxPairingName));
    out.name = printable(sent.substr(0, sent.find('\0')), '-');
    std::transform(out.name.begin(), out.name.end(), out.name.begin(), fitCharacter);
    std::ranges::copy(in.bytes(out.nonce.size()), out.nonce.begin());
    return out;
}

Commitment commitmentTo(const PairingOpening::Bytes &opening)
{
    Commitment out;
    crypto::blake2b(out, {asBytes("skyseal v1 pairing commitment"), opening});
    return out;
}

std::string pairingCode(const PairingDatagram &first, const PairingAnswer &answer, const PairingOpening &station,
                        const PairingOpening &agent)
{
    std::array<std::uint8_t, 32> hash;
    crypto::blake2b(hash, {asBytes("skyseal v1 pairing code"), first, answer, station.nonce, agent.nonce});
    ByteReader in(hash);
    const auto code = static_cast<unsigned>(in.u64() % kCodes);
    char text[8];
    std::snprintf(text, sizeof text, "%03u %03u", code / 1000, code % 1000);
    return text;
}

std::uint8_t Word::number() const
{
    return static_cast<std::uint8_t>(kWordMark | static_cast<unsigned>(mine) << 2 | static_cast<unsigned>(heard));
}

std::optional<Word> Word::fromNumber(std::uint8_t number)
{
    const Word word{static_cast<Decision>(number >> 2 & 3), static_cast<Heard>(number & 3)};
    if ((number & 0xf0) != kWordMark || word.mine > Decision::No)
        return std::nullopt;
    return word;
}

PairingDatagram pairingRequest()
{
    return pairingCall({});
}

PairingDatagram pairingCall(const PairingToken &token)
{
    PairingDatagram out{};
    out[0] = firstByte(PairingMessage::Call);
    std::copy(token.begin(), token.end(), out.begin() + 1);
    return out;
}

PairingDatagram pairingFirst(const PairingHello &hello)
{
    PairingDatagram out{};
    ByteWriter writer(out);
    writer.u8(firstByte(PairingMessage::First));
    writer.u32(static_cast<std::uint32_t>(hello.id));
    writer.bytes(hello.token);
    writer.bytes(hello.share);
    return out;
}

PairingAnswer pairingAnswer(const PairingHello &hello)
{
    PairingAnswer out;
    ByteWriter writer(out);
    writer.u8(firstByte(PairingMessage::Answer));
    writer.u32(static_cast<std::uint32_t>(hello.id));
    writer.bytes(hello.share);
    writer.bytes(hello.commitment);
    return out;
}

std::array<std::uint8_t, kSealedHead> sealedHead(PairingId id, std::uint8_t number)
{
    std::array<std::uint8_t, kSealedHead> out;
    ByteWriter writer(out);
    writer.u8(firstByte(PairingMessage::Sealed));
    writer.u32(static_cast<std::uint32_t>(id));
    writer.u8(number);
    return out;
}

static bool isCallOrRequest(ByteView datagram)
{
    return datagram.size() == kPairingLength && datagram[0] == firstByte(PairingMessage::Call);
}

bool isPairingRequest(ByteView datagram)
{
    return isCallOrRequest(datagram) && std::ranges::all_of(datagram.subspan(1), [](std::uint8_t byte) { return byte == 0; });
}

std::optional<PairingToken> calledToken(ByteView datagram)
{
    if (!isCallOrRequest(datagram) || isPairingRequest(datagram))
        return std::nullopt;
    PairingToken token;
    std::copy_n(datagram.begin() + 1, token.size(), token.begin());
    return token;
}

std::optional<PairingHello> readFirst(ByteView datagram)
{
    if (datagram.size() != kPairingLength || datagram[0] != firstByte(PairingMessage::First))
        return std::nullopt;
    ByteReader in(datagram.subspan(1));
    PairingHello out;
    out.id = PairingId{in.u32()};
    std::ranges::copy(in.bytes(out.token.size()), out.token.begin());
    std::ranges::copy(in.bytes(out.share.size()), out.share.begin());
    if (std::ranges::any_of(in.rest(), [](std::uint8_t byte) { return byte != 0; }))
        return std::nullopt;
    return out;
}

std::optional<PairingHello> readAnswer(ByteView datagram)
{
    if (datagram.size() != kPairingAnswerLength || datagram[0] != firstByte(PairingMessage::Answer))
        return std::nullopt;
    ByteReader in(datagram.subspan(1));
    PairingHello out;
    out.id = PairingId{in.u32()};
    std::ranges::copy(in.bytes(out.share.size()), out.share.begin());
    std::ranges::copy(in.bytes(out.commitment.size()), out.commitment.begin());
    return out;
}

bool isOpening(ByteView datagram)
{
    return datagram.size() == kOpeningLength && datagram[0] == firstByte(PairingMessage::Sealed) && datagram[5] == 0;
}

bool isWord(ByteView datagram)
{
    return datagram.size() == kWordLength && datagram[0] == firstByte(PairingMessage::Sealed) && datagram[5] >= kWordMark;
}

PairingId sealedPairing(ByteView datagram)
{
    return idIn(datagram);
}

} // namespace skyseal::channel
