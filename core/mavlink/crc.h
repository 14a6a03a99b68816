// The checksum of MAVLink: CRC-16/MCRF4XX (X.25 polynomial, reflected), over the frame without its first byte and then
// CRC_EXTRA.
#pragma once

#include "core/base/bytes.h"

#include <array>

namespace skyseal::mavlink {

inline constexpr std::uint16_t kCrcStart = 0xffff;

/// The state after each possible byte, from a state of zero.
inline constexpr std::array<std::uint16_t, 256> kCrcOfByte = [] {
    constexpr std::uint16_t kPolynomial = 0x8408; // x^16 + x^12 + x^5 + 1, reflected
    std::array<std::uint16_t, 256> table{};
    for (unsigned byte = 0; byte < 256; ++byte) {
        auto crc = static_cast<std::uint16_t>(byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = static_cast<std::uint16_t>((crc & 1) ? (crc >> 1) ^ kPolynomial : crc >> 1);
        table[byte] = crc;
    }
    return table;
}();

/// The state after one more byte.
constexpr std::uint16_t crcStep(std::uint16_t crc, std::uint8_t byte)
{
    return static_cast<std::uint16_t>((crc >> 8) ^ kCrcOfByte[(crc ^ byte) & 0xff]);
}

/// The state after all `bytes`. Processes eight bytes per step.
std::uint16_t crcAccumulate(std::uint16_t crc, ByteView bytes);

} // namespace skyseal::mavlink
