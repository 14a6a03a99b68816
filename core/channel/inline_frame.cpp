#include "core/channel/inline_frame.h"

#include "core/base/byte_reader.h"
#include "core/base/byte_writer.h"

#include <algorithm>
#include <utility>

namespace skyseal::channel {

namespace {

constexpr std::uint8_t kMagic = 0xfd;
constexpr std::size_t kHeader = 10;
constexpr std::size_t kChecksum = 2;

using Hidden = std::array<std::uint8_t, 255>;

/// Returns the traits of the message if the bytes are one MAVLink 2 frame with these flags and `trailer` bytes after it, and
/// its checksum is right.
std::optional<MessageTraits::Message> traitsOf(ByteView bytes, std::uint8_t flags, std::size_t trailer,
                                               const MessageTraits &traits)
{
    if (bytes.size() < kHeader + kChecksum + trailer || bytes[0] != kMagic || bytes[2] != flags)
        return std::nullopt;
    const std::size_t payloadEnd = kHeader + bytes[1];
    if (bytes.size() != payloadEnd + kChecksum + trailer)
        return std::nullopt;
    const std::uint32_t id = std::uint32_t(bytes[7]) | std::uint32_t(bytes[8]) << 8 | std::uint32_t(bytes[9]) << 16;
    const auto message = traits.message(id);
    if (!message)
        return std::nullopt;
    const std::uint16_t checksum = traits.checksum(bytes.subspan(1, payloadEnd - 1), message->crcExtra);
    const bool right = checksum == (bytes[payloadEnd] | bytes[payloadEnd + 1] << 8);
    return right ? message : std::nullopt;
}

void writeChecksum(MutableByteView frame, std::uint8_t crcExtra, const MessageTraits &traits)
{
    const std::size_t payloadEnd = kHeader + frame[1];
    const std::uint16_t checksum = traits.checksum(ByteView(frame).subspan(1, payloadEnd - 1), crcExtra);
    frame[payloadEnd] = static_cast<std::uint8_t>(checksum);
    frame[payloadEnd + 1] = static_cast<std::uint8_t>(checksum >> 8);
}

/// Associated data: header on the wire 10 | epoch 1 | offsets of the targets 2 | the
/// targets 2 | suite 1 | direction 1 | carrier 1.
class InlineAssociatedData
{
public:
    InlineAssociatedData(ByteView frame, const ClearBytes &clear, const InlinePlace &place, crypto::SuiteId suite)
    {
        ByteWriter out(m_bytes);
        out.bytes(frame.first(kHeader));
        out.u8(place.epochByte);
        out.bytes(clear.describe(frame.subspan(kHeader, frame[1])));
        out.u8(static_cast<std::uint8_t>(suite));
        out.u8(static_cast<std::uint8_t>(place.direction));
        out.u8(static_cast<std::uint8_t>(place.carrier));
    }
    ByteView view() const { return m_bytes; }

private:
    std::array<std::uint8_t, kHeader + 8> m_bytes{};
};

} // namespace

ClearBytes::ClearBytes(const MessageTraits::Message &message, std::size_t payloadLength) : m_length(payloadLength)
{
    const auto present = [payloadLength](std::int16_t offset) {
        return offset >= 0 && static_cast<std::size_t>(offset) < payloadLength ? static_cast<std::uint8_t>(offset) : kNone;
    };
    m_first = present(message.targetSystemOffset);
    m_second = present(message.targetComponentOffset);
    if (m_second < m_first)
        std::swap(m_first, m_second);
}

void ClearBytes::gather(ByteView payload, MutableByteView out) const
{
    auto to = out.begin();
    std::size_t from = 0;
    for (const std::size_t clear : {std::size_t(m_first), std::size_t(m_second), payload.size()}) {
        const std::size_t end = std::min(clear, payload.size());
        if (end > from)
            to = std::copy_n(payload.begin() + static_cast<std::ptrdiff_t>(from), end - from, to);
        from = end + 1;
    }
}

void ClearBytes::scatter(ByteView hidden, MutableByteView payload) const
{
    auto from = hidden.begin();
    std::size_t to = 0;
    for (const std::size_t clear : {std::size_t(m_first), std::size_t(m_second), payload.size()}) {
        const std::size_t end = std::min(clear, payload.size());
        if (end > to) {
            std::copy_n(from, end - to, payload.begin() + static_cast<std::ptrdiff_t>(to));
            from += static_cast<std::ptrdiff_t>(end - to);
        }
        to = end + 1;
    }
}

std::array<std::uint8_t, 4> ClearBytes::describe(ByteView payload) const
{
    const auto byteAt = [&](std::uint8_t offset) { return offset == kNone ? std::uint8_t(0) : payload[offset]; };
    return {m_first, m_second, byteAt(m_first), byteAt(m_second)};
}

std::optional<SealableFrame> SealableFrame::read(ByteView frame, const MessageTraits &traits)
{
    const auto message = traitsOf(frame, 0, 0, traits);
    return message ? std::optional(SealableFrame(frame, *message, traits)) : std::nullopt;
}

bool SealableFrame::seal(const InlinePlace &place, crypto::InlineCipher &cipher, MutableByteView out) const
{
    const MutableByteView frame = out.first(sealedSize());
    std::copy(m_bytes.begin(), m_bytes.end(), frame.begin());
    frame[2] = kInlineFlags;
    const MutableByteView payload = frame.subspan(kHeader, frame[1]);
    const ClearBytes clear(m_message, payload.size());
    Hidden buffer;
    const MutableByteView hidden = MutableByteView(buffer).first(clear.hiddenLength());
    clear.gather(payload, hidden);
    const InlineAssociatedData associated(frame, clear, place, cipher.suite());
    const auto tag = cipher.seal(place.counter, associated.view(), hidden);
    if (!tag)
        return false;
    clear.scatter(hidden, payload);
    writeChecksum(frame, m_message.crcExtra, *m_traits);
    ByteWriter trailer(frame.last(kInlineTrailer));
    trailer.u8(place.epochByte);
    trailer.u32(place.counter);
    trailer.bytes(*tag);
    return trailer.ok();
}

std::optional<InlineFrame> InlineFrame::read(MutableByteView frame, const MessageTraits &traits)
{
    const auto message = traitsOf(frame, kInlineFlags, kInlineTrailer, traits);
    if (!message)
        return std::nullopt;
    const InlineFrame read(frame, *message, traits);
    return read.counter() <= kMaxInlineCounter ? std::optional(read) : std::nullopt;
}

std::uint32_t InlineFrame::counter() const
{
    ByteReader trailer(ByteView(m_bytes).last(kInlineTrailer - 1));
    return trailer.u32();
}

std::optional<MutableByteView> InlineFrame::open(Direction direction, Carrier carrier, crypto::InlineCipher &cipher) const
{
    const MutableByteView payload = m_bytes.subspan(kHeader, m_bytes[1]);
    const ClearBytes clear(m_message, payload.size());
    Hidden buffer;
    const MutableByteView hidden = MutableByteView(buffer).first(clear.hiddenLength());
    clear.gather(payload, hidden);
    const InlineAssociatedData associated(m_bytes, clear, {epochByte(), counter(), direction, carrier}, cipher.suite());
    crypto::InlineCipher::Tag tag;
    std::copy_n(m_bytes.end() - crypto::InlineCipher::kTagLength, tag.size(), tag.begin());
    if (!cipher.open(counter(), associated.view(), hidden, tag))
        return std::nullopt;
    clear.scatter(hidden, payload);
    m_bytes[2] = 0;
    const MutableByteView frame = m_bytes.first(m_bytes.size() - kInlineTrailer);
    writeChecksum(frame, m_message.crcExtra, *m_traits);
    return frame;
}

} // namespace skyseal::channel
