#include "core/mavlink/crc.h"

namespace skyseal::mavlink {

namespace {

using Table = std::array<std::array<std::uint16_t, 256>, 8>;

/// table[n][b]: effect of byte b on the checksum if n more bytes follow it.
constexpr Table makeTable()
{
    Table table{kCrcOfByte};
    for (std::size_t n = 1; n < 8; ++n) {
        for (unsigned byte = 0; byte < 256; ++byte)
            table[n][byte] = crcStep(table[n - 1][byte], 0);
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
        crc = crcStep(crc, *at);
    return crc;
}

} // namespace skyseal::mavlink
