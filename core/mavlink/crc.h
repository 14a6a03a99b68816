// The checksum of MAVLink: CRC-16/MCRF4XX (X.25 polynomial, reflected), over the frame without its first byte and then
// CRC_EXTRA.
#pragma once

#include "core/base/bytes.h"

namespace skyseal::mavlink {

inline constexpr std::uint16_t kCrcStart = 0xffff;

/// Eight bytes a step.
std::uint16_t crcAccumulate(std::uint16_t crc, ByteView bytes);

} // namespace skyseal::mavlink
