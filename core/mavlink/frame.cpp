#include "core/mavlink/frame.h"

#include "core/mavlink/crc.h"

namespace skyseal::mavlink {

/// The only class that can construct a Frame.
class FrameReader
{
public:
    static Result<Frame, FrameError> read(ByteView bytes, const Dialect &dialect)
    {
        if (bytes.size() < 2)
            return fail(!bytes.empty() && !isMagic(bytes[0]) ? FrameFault::Garbage : FrameFault::Truncated, 0);
        const bool v2 = bytes[0] == kMagic2;
        if (!v2 && bytes[0] != kMagic1)
            return fail(FrameFault::Garbage, 0);
        if (bytes.size() < (v2 ? 10u : 6u))
            return fail(FrameFault::Truncated, 0);
        const std::size_t payloadEnd = (v2 ? 10u : 6u) + bytes[1];
        const bool isSigned = v2 && (bytes[2] & kFlagSigned);
        const std::size_t length = payloadEnd + 2 + (isSigned ? kSignatureLength : 0);
        if (bytes.size() < length)
            return fail(FrameFault::Truncated, length);

        const std::uint32_t id = v2 ? std::uint32_t(bytes[7]) | std::uint32_t(bytes[8]) << 8 | std::uint32_t(bytes[9]) << 16
                                    : bytes[5];
        const MessageInfo *info = dialect.find(id);
        if (!info)
            return fail(FrameFault::UnknownMessage, length);
        std::uint16_t crc = crcAccumulate(kCrcStart, bytes.subspan(1, payloadEnd - 1));
        crc = crcAccumulate(crc, {&info->crcExtra, 1});
        if (crc != (bytes[payloadEnd] | bytes[payloadEnd + 1] << 8))
            return fail(FrameFault::BadCrc, length);
        if (v2 && (bytes[2] & ~kFlagSigned))
            return fail(FrameFault::UnknownIncompatFlags, length);
        return Frame(bytes.first(length), info);
    }

private:
    static bool isMagic(std::uint8_t byte) { return byte == kMagic1 || byte == kMagic2; }
    static Result<Frame, FrameError> fail(FrameFault fault, std::size_t length)
    {
        return tl::unexpected(FrameError{fault, length});
    }
};

Result<Frame, FrameError> readFrame(ByteView bytes, const Dialect &dialect)
{
    return FrameReader::read(bytes, dialect);
}

std::string_view nameOf(FrameFault fault)
{
    static constexpr std::string_view kNames[] = {
        "garbage", "truncated", "bad_crc", "unknown_message", "unknown_incompat_flags", "bad_signature"};
    return kNames[static_cast<std::size_t>(fault)];
}

} // namespace skyseal::mavlink
