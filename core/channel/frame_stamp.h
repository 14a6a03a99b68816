// The time at which a station sealed frames, in front of them in the plaintext of its records (PROTOCOL.md, section 6): two
// bits 1 0 and 22 bits of its session clock, in units of 1024 microseconds.
#pragma once

#include "core/base/bytes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace skyseal::channel {

inline constexpr std::size_t kFrameStampLength = 3;

/// Writes the stamp (microseconds modulo 2^32) and the frames to `out`, which must hold both. Returns what was written.
inline ByteView stampFrames(std::uint32_t stamp, ByteView frames, MutableByteView out)
{
    const std::uint32_t units = stamp >> 10;
    out[0] = static_cast<std::uint8_t>(0x80 | (units & 0x3f));
    out[1] = static_cast<std::uint8_t>(units >> 6);
    out[2] = static_cast<std::uint8_t>(units >> 14);
    std::copy(frames.begin(), frames.end(), out.begin() + kFrameStampLength);
    return out.first(kFrameStampLength + frames.size());
}

/// The stamp in front of the frames in the plaintext of a record: microseconds modulo 2^32, rounded down; nullopt without.
inline std::optional<std::uint32_t> frameStamp(ByteView plaintext)
{
    if (plaintext.size() < kFrameStampLength || (plaintext[0] & 0xc0) != 0x80)
        return std::nullopt;
    const std::uint32_t units = (plaintext[0] & 0x3fu) | std::uint32_t{plaintext[1]} << 6 | std::uint32_t{plaintext[2]} << 14;
    return units << 10;
}

} // namespace skyseal::channel
