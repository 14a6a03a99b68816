#include "core/mavlink/frame.h"

#include "core/mavlink/crc.h"
#include "core/mavlink/frame_reader.h"

namespace skyseal::mavlink {

Result<Frame, FrameError> readFrame(ByteView bytes, const Dialect &dialect)
{
    return FrameReader::read(bytes, dialect, [](ByteView covered, std::uint8_t crcExtra, std::uint16_t expected) {
        return crcStep(crcAccumulate(kCrcStart, covered), crcExtra) == expected;
    });
}

std::string_view nameOf(FrameFault fault)
{
    static constexpr std::string_view kNames[] = {
        "garbage", "truncated", "bad_crc", "unknown_message", "unknown_incompat_flags", "bad_signature"};
    return kNames[static_cast<std::size_t>(fault)];
}

} // namespace skyseal::mavlink
