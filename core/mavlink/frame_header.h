// Header fields of a whole frame, including frames of messages that are not in the dialect (isWholeFrame()).
// https://mavlink.io/en/guide/serialization.html
#pragma once

#include "core/mavlink/frame.h"

namespace skyseal::mavlink {

inline std::uint8_t systemIdOf(ByteView frame)
{
    return frame[frame[0] == kMagic2 ? 5 : 3];
}

inline std::uint8_t componentIdOf(ByteView frame)
{
    return frame[frame[0] == kMagic2 ? 6 : 4];
}

/// MAVLink 1 has no signatures.
inline bool isSignedFrame(ByteView frame)
{
    return frame[0] == kMagic2 && (frame[2] & kFlagSigned) != 0;
}

inline std::uint32_t messageIdOf(ByteView frame)
{
    if (frame[0] != kMagic2)
        return frame[5];
    return frame[7] | frame[8] << 8 | static_cast<std::uint32_t>(frame[9]) << 16;
}

} // namespace skyseal::mavlink
