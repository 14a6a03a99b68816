// The form of a .tlog, as ground stations have always kept it: each frame behind the microseconds since 1970, eight bytes,
// the most significant first. There is no header, no length and no checksum but the frame's own.
#pragma once

#include "core/base/bytes.h"
#include "core/base/clock.h"

#include <optional>

namespace skyseal::tlog {

inline constexpr std::size_t kTimeLength = 8;

/// Writes one entry into `out` and gives its bytes; empty when it does not fit. Moments before 1970 become 1970.
MutableByteView writeEntry(MutableByteView out, WallTime time, ByteView frame);

/// The time at the start of `bytes`; nullopt when they are fewer than eight or say a moment that no recording has (after
/// 2200).
std::optional<WallTime> readTime(ByteView bytes);

} // namespace skyseal::tlog
