// Reads the header of a frame and verifies its checksum by a function of the caller: one pass of the CRC (readFrame()), or a
// method for overlapping frames (FrameScanner).
// https://mavlink.io/en/guide/serialization.html
#pragma once

#include "core/mavlink/frame.h"

#include <concepts>

namespace skyseal::mavlink {

inline constexpr std::size_t kHeaderLength1 = 6, kHeaderLength2 = 10; ///< from the first byte to the payload
inline constexpr std::size_t kChecksumLength = 2;

/// The length of the frame at the start of `bytes` according to its header, which may exceed `bytes`; 0 if the header
/// is incomplete. Checks nothing else.
constexpr std::size_t frameLength(ByteView bytes)
{
    if (bytes.empty() || !isMagic(bytes[0]))
        return 0;
    const bool v2 = bytes[0] == kMagic2;
    const std::size_t header = v2 ? kHeaderLength2 : kHeaderLength1;
    if (bytes.size() < header)
        return 0;
    return header + bytes[1] + kChecksumLength + (v2 && (bytes[2] & kFlagSigned) ? kSignatureLength : 0);
}

/// The only class that can construct a Frame.
class FrameReader
{
public:
    /// Reads one frame at the start of `bytes`. `matches(covered, crcExtra, expected)` returns true if the checksum over the
    /// bytes that it covers and CRC_EXTRA is the expected one; it is called once, only for a whole frame of a known message.
    template<std::predicate<ByteView, std::uint8_t, std::uint16_t> Matches>
    static Result<Frame, FrameError> read(ByteView bytes, const Dialect &dialect, Matches &&matches)
    {
        const std::size_t length = frameLength(bytes);
        if (length == 0)
            return fail(!bytes.empty() && !isMagic(bytes[0]) ? FrameFault::Garbage : FrameFault::Truncated, 0);
        if (bytes.size() < length)
            return fail(FrameFault::Truncated, length);

        const bool v2 = bytes[0] == kMagic2;
        const std::size_t payloadEnd = (v2 ? kHeaderLength2 : kHeaderLength1) + bytes[1];
        const std::uint32_t id = v2 ? std::uint32_t(bytes[7]) | std::uint32_t(bytes[8]) << 8 | std::uint32_t(bytes[9]) << 16
                                    : bytes[5];
        const MessageInfo *info = dialect.find(id);
        if (!info)
            return fail(FrameFault::UnknownMessage, length);
        const auto expected = static_cast<std::uint16_t>(bytes[payloadEnd] | bytes[payloadEnd + 1] << 8);
        if (!matches(bytes.subspan(1, payloadEnd - 1), info->crcExtra, expected))
            return fail(FrameFault::BadCrc, length);
        if (v2 && (bytes[2] & ~kFlagSigned))
            return fail(FrameFault::UnknownIncompatFlags, length);
        return Frame(bytes.first(length), info);
    }

private:
    static Result<Frame, FrameError> fail(FrameFault fault, std::size_t length)
    {
        return tl::unexpected(FrameError{fault, length});
    }
};

} // namespace skyseal::mavlink
