// One MAVLink frame whose length, checksum and message id have been verified: a view into the received bytes.
// https://mavlink.io/en/guide/serialization.html
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/mavlink/dialect.h"

namespace skyseal::mavlink {

inline constexpr std::uint8_t kMagic1 = 0xfe;
inline constexpr std::uint8_t kMagic2 = 0xfd;
inline constexpr std::uint8_t kFlagSigned = 0x01;
inline constexpr std::size_t kSignatureLength = 13;
inline constexpr std::size_t kMaxFrameLength = 280;

/// True for the first byte of a frame of version 1 or 2.
constexpr bool isMagic(std::uint8_t byte)
{
    return byte == kMagic1 || byte == kMagic2;
}

/// A valid frame. Lives as long as the bytes and the dialect it was read with.
class Frame
{
public:
    ByteView bytes() const { return m_bytes; }
    int version() const { return m_bytes[0] == kMagic2 ? 2 : 1; }
    std::uint8_t incompatFlags() const { return version() == 2 ? m_bytes[2] : 0; }
    std::uint8_t sequence() const { return m_bytes[version() == 2 ? 4 : 2]; }
    std::uint8_t systemId() const { return m_bytes[version() == 2 ? 5 : 3]; }
    std::uint8_t componentId() const { return m_bytes[version() == 2 ? 6 : 4]; }
    std::uint32_t messageId() const { return m_info->id; }
    const MessageInfo &info() const { return *m_info; }
    /// As received: shorter than the message (trimmed zeros) or longer (fields of a newer dialect).
    ByteView payload() const { return m_bytes.subspan(version() == 2 ? 10 : 6, m_bytes[1]); }
    bool isSigned() const { return (incompatFlags() & kFlagSigned) != 0; }
    /// Link id, timestamp (48 bits) and signature (48 bits); empty when not signed.
    ByteView signatureBlock() const { return isSigned() ? m_bytes.last(kSignatureLength) : ByteView(); }

    /// Target system and component; 0 = broadcast.
    std::uint8_t targetSystem() const { return byteAt(m_info->targetSystemOffset); }
    std::uint8_t targetComponent() const { return byteAt(m_info->targetComponentOffset); }

private:
    friend class FrameReader;
    Frame(ByteView bytes, const MessageInfo *info) : m_bytes(bytes), m_info(info) {}

    std::uint8_t byteAt(std::int16_t offset) const
    {
        const ByteView content = payload();
        return offset >= 0 && static_cast<std::size_t>(offset) < content.size() ? content[static_cast<std::size_t>(offset)] : 0;
    }

    ByteView m_bytes;
    const MessageInfo *m_info;
};

enum class FrameFault : std::uint8_t {
    Garbage,   ///< does not begin with a frame's first byte
    Truncated, ///< the frame continues after the end
    BadCrc,
    UnknownMessage,       ///< no such id in the dialect, so its checksum cannot be checked
    UnknownIncompatFlags, ///< an unknown format; the checksum is right
    BadSignature
};

/// Keyword as in JSON: "bad_crc".
std::string_view nameOf(FrameFault fault);

struct FrameError
{
    FrameFault fault{};
    std::size_t length = 0; ///< of the whole frame according to its header; 0 if there is no header
};

/// Reads one frame at the start of `bytes`, which may continue after it. Never reads past the end, never allocates.
Result<Frame, FrameError> readFrame(ByteView bytes, const Dialect &dialect);

} // namespace skyseal::mavlink
