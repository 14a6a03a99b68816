// Inline framing (PROTOCOL.md, section 12): a MAVLink 2 frame sealed in place. Header and target bytes stay clear and are
// authenticated; the rest of the payload is encrypted at the same length; the checksum is that of the encrypted frame; in the
// place of a signature there are
//
//   epoch 1 | counter 4 | tag 8
//
// The incompatibility flags are 0x81: bit 0 announces 13 bytes after the checksum, so that a receiver that does not know bit 7
// still finds the end of the frame and skips it. Little-endian, like MAVLink.
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
/// Limit of the counter, which records and inline frames of an epoch share.
inline constexpr std::uint32_t kMaxInlineCounter = (1u << 24) - 1;

/// Returns true if the bytes begin like an inline frame and are long enough for one. InlineFrame::read() checks the rest.
constexpr bool looksInline(ByteView bytes)
{
    return bytes.size() >= 10 + 2 + kInlineTrailer && bytes[0] == 0xfd && bytes[2] == kInlineFlags;
}

/// Implicit fields that a tag covers beside the frame.
struct InlinePlace
{
    std::uint8_t epochByte = 0; ///< low byte of the epoch's number
    std::uint32_t counter = 0;
    Direction direction{};
    Carrier carrier{};
};

/// Offsets of the clear bytes of a payload, ascending.
class ClearBytes
{
public:
    /// Leaves out offsets beyond the payload (no such field, or a trimmed zero).
    ClearBytes(const MessageTraits::Message &message, std::size_t payloadLength);

    std::size_t hiddenLength() const { return m_length - (m_first != kNone) - (m_second != kNone); }
    /// Copies the payload without its clear bytes to the front of `out`, and back.
    void gather(ByteView payload, MutableByteView out) const;
    void scatter(ByteView hidden, MutableByteView payload) const;
    /// Returns both offsets (255 = none) and both bytes (0 if none).
    std::array<std::uint8_t, 4> describe(ByteView payload) const;

private:
    static constexpr std::uint8_t kNone = 255; // No payload has a byte at 255.

    std::size_t m_length;
    std::uint8_t m_first = kNone;
    std::uint8_t m_second = kNone;
};

/// A plain frame that can be sealed in place: MAVLink 2, without incompatibility flags (so not signed), of a known message,
/// with a right checksum. A view: valid as long as its bytes.
class SealableFrame
{
public:
    /// Returns nullopt for anything else, and if bytes follow the frame.
    static std::optional<SealableFrame> read(ByteView frame, const MessageTraits &traits);

    std::size_t sealedSize() const { return m_bytes.size() + kInlineTrailer; }
    /// Writes `sealedSize()` bytes to `out`, which must have that size and not overlap the frame. Returns false if the library
    /// failed.
    [[nodiscard]] bool seal(const InlinePlace &place, crypto::InlineCipher &cipher, MutableByteView out) const;

private:
    SealableFrame(ByteView bytes, const MessageTraits::Message &message, const MessageTraits &traits)
        : m_bytes(bytes), m_message(message), m_traits(&traits)
    {}

    ByteView m_bytes;
    MessageTraits::Message m_message;
    const MessageTraits *m_traits;
};

/// A sealed frame with a right form and checksum; open() authenticates it. A view: valid as long as its bytes.
class InlineFrame
{
public:
    /// Returns nullopt unless the bytes are exactly one such frame: flags 0x81, the length in its header, a known message, a
    /// right checksum, a counter within the limit.
    static std::optional<InlineFrame> read(MutableByteView frame, const MessageTraits &traits);

    std::uint8_t epochByte() const { return m_bytes[m_bytes.size() - kInlineTrailer]; }
    std::uint32_t counter() const;

    /// Checks the tag and restores the plain frame in place. Returns nullopt, and changes nothing, if the tag is wrong.
    std::optional<MutableByteView> open(Direction direction, Carrier carrier, crypto::InlineCipher &cipher) const;

private:
    InlineFrame(MutableByteView bytes, const MessageTraits::Message &message, const MessageTraits &traits)
        : m_bytes(bytes), m_message(message), m_traits(&traits)
    {}

    MutableByteView m_bytes;
    MessageTraits::Message m_message;
    const MessageTraits *m_traits;
};

} // namespace skyseal::channel
