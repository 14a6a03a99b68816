// Entry format of a .tlog, as used by Mission Planner, QGroundControl and MAVProxy: eight bytes with the microseconds since
// 1970-01-01 UTC, big-endian, then the frame. The file has no header, length fields or checksums beside those of the frames.
#pragma once

#include "core/base/bytes.h"
#include "core/base/clock.h"

#include <optional>

namespace skyseal::tlog {

inline constexpr std::size_t kTimeLength = 8;

/// Whether a recording may have this time: from 1970 to the year 2200.
bool isPlausible(WallTime time);

/// Writes one entry to `out` and returns the written bytes; empty when it does not fit. Times before 1970 become 1970.
MutableByteView writeEntry(MutableByteView out, WallTime time, ByteView frame);

/// Reads the timestamp at the front of `bytes`; nullopt when they are fewer than eight or the time is implausible.
std::optional<WallTime> readTime(ByteView bytes);

} // namespace skyseal::tlog
