// The sizes that records are measured at: those of a heartbeat, an attitude, a large telemetry message and the longest one.
#pragma once

#include <array>
#include <cstddef>

namespace skyseal::bench {

inline constexpr std::size_t kAssociatedSize = 9; // first byte, connection id, counter, suite, direction, carrier
inline constexpr std::array<std::size_t, 4> kSizes{9, 28, 64, 255};

} // namespace skyseal::bench
