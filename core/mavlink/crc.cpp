#include "core/mavlink/crc.h"

#include <array>
#include <cstring>

namespace skyseal::mavlink {

namespace {

constexpr std::uint16_t kPolynomial = 0x8408; // x^16 + x^12 + x^5 + 1, reflected

using Table = std::array<std::array<std::uint16_t, 256>, 8>;

/// table[n][b]: effect of byte b on the checksum if n more bytes follow it.
constexpr Table makeTable()
{
    Table table{};
    for (unsigned byte = 0; byte < 256; ++byte) {
        std::uint16_t crc = static_cast<std::uint16_t>(byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = static_cast<std::uint16_t>((crc & 1) ? (crc >> 1) ^ kPolynomial : crc >> 1);
        table[0][byte] = crc;
    }
    for (std::size_t n = 1; n < 8; ++n) {
        for (unsigned byte = 0; byte < 256; ++byte)
            table[n][byte] = static_cast<std::uint16_t>((table[n - 1][byte] >> 8) ^ table[0][table[n - 1][byte] & 0xff]);
    }
    return table;
}

constexpr Table kTable = makeTable();

} // namespace

std::uint16_t crcAccumulate(std::uint16_t crc, ByteView bytes)
{
    const std::uint8_t *at = bytes.data();
    std::size_t left = bytes.size();
    for (; left >= 8; left -= 8, at += 8) {
        crc = static_cast<std::uint16_t>(kTable[7][at[0] ^ (crc & 0xff)] ^ kTable[6][at[1] ^ (crc >> 8)] ^ kTable[5][at[2]]
                                         ^ kTable[4][at[3]] ^ kTable[3][at[4]] ^ kTable[2][at[5]] ^ kTable[1][at[6]]
                                         ^ kTable[0][at[7]]);
    }
    for (; left > 0; --left, ++at)
        crc = static_cast<std::uint16_t>((crc >> 8) ^ kTable[0][(crc ^ *at) & 0xff]);
    return crc;
}

} // namespace skyseal::mavlink
