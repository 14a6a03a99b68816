// A MAVLink 2 frame sealed in place: its header and the bytes that say for whom it is stay clear, and are authenticated; the
// rest of the payload is encrypted at the same length; the checksum is that of the encrypted frame; and where a signature
// would stand there are
//
//   epoch 1 | counter 4 | tag 8
//
// with 0x81 as incompatibility flags: bit 0 says that 13 bytes follow the checksum, so that whoever does not know bit 7
// still finds the frame's end, and skips it. Little-endian, as MAVLink is. PROTOCOL.md section 12.
#pragma once

#include "core/channel/message_traits.h"
#include "core/channel/wire_format.h"
#include "core/crypto/inline_cipher.h"

#include <array>
#include <optional>

namespace skyseal::channel {

inline constexpr std::uint8_t kInlineFlags = 0x81;
inline constexpr std::size_t kInlineTrailer = 13;
inline constexpr std::size_t kMaxInlineFrame = 280;
/// The counter is that of the records of the same epoch, which is never let grow further.
inline constexpr std::uint32_t kMaxInlineCounter = (1u << 24) - 1;

/// True for bytes that begin as an inline frame does and could hold one; InlineFrame::read says whether they do.
constexpr bool looksInline(ByteView bytes)
{
    return bytes.size() >= 10 + 2 + kInlineTrailer && bytes[0] == 0xfd && bytes[2] == kInlineFlags;
}

/// What a tag covers beside the frame itself.
struct InlinePlace
{
    std::uint8_t epochByte = 0; ///< the low byte of the epoch's number, as it travels
    std::uint32_t counter = 0;
    Direction direction{};
    Carrier carrier{};
};

/// Where the clear bytes of a payload stand, in rising order.
class ClearBytes
{
public:
    /// Offsets at which this payload has no byte (the message has no such field, or its zero was trimmed) fall away.
    ClearBytes(const MessageTraits::Message &message, std::size_t payloadLength);

    std::size_t hiddenLength() const { return m_length - (m_first != kNone) - (m_second != kNone); }
    /// The payload without its clear bytes, to the front of `out`, and back again.
    void gather(ByteView payload, MutableByteView out) const;
    void scatter(ByteView hidden, MutableByteView payload) const;
    /// Both offsets (255 = none) and both bytes (then 0).
    std::array<std::uint8_t, 4> describe(ByteView payload) const;

private:
    static constexpr std::uint8_t kNone = 255; // No payload has a byte at 255.

    std::size_t m_length;
    std::uint8_t m_first = kNone;
    std::uint8_t m_second = kNone;
};

/// A plain frame that can be sealed in place: MAVLink 2, without any incompatibility flag (so not signed), of a known
/// message, its checksum right. Lives as long as its bytes.
class SealableFrame
{
public:
    /// nullopt for anything else, and for bytes that go on behind the frame.
    static std::optional<SealableFrame> read(ByteView frame, const MessageTraits &facts);

    std::size_t sealedSize() const { return m_bytes.size() + kInlineTrailer; }
    /// Writes `sealedSize()` bytes to the front of `out`, which has them and is apart from the frame; false when the library
    /// failed.
    [[nodiscard]] bool seal(const InlinePlace &place, crypto::InlineCipher &cipher, MutableByteView out) const;

private:
    SealableFrame(ByteView bytes, const MessageTraits::Message &message, const MessageTraits &facts)
        : m_bytes(bytes), m_message(message), m_facts(&facts)
    {}

    ByteView m_bytes;
    MessageTraits::Message m_message;
    const MessageTraits *m_facts;
};

/// A sealed frame whose form and checksum are right; whether it is authentic only `open` tells. Lives as long as its bytes.
class InlineFrame
{
public:
    /// nullopt unless the bytes are one such frame, exactly: flags 0x81, the length that its header gives, a known message,
    /// a right checksum, a counter that may be.
    static std::optional<InlineFrame> read(MutableByteView frame, const MessageTraits &facts);

    std::uint8_t epochByte() const { return m_bytes[m_bytes.size() - kInlineTrailer]; }
    std::uint32_t counter() const;

    /// Checks the tag and makes the plain frame of it, in place; nullopt, with no byte changed, when it is wrong.
    std::optional<MutableByteView> open(Direction direction, Carrier carrier, crypto::InlineCipher &cipher) const;

private:
    InlineFrame(MutableByteView bytes, const MessageTraits::Message &message, const MessageTraits &facts)
        : m_bytes(bytes), m_message(message), m_facts(&facts)
    {}

    MutableByteView m_bytes;
    MessageTraits::Message m_message;
    const MessageTraits *m_facts;
};

} // namespace skyseal::channel
