#include "core/mavlink/overlapping_crc.h"

#include <algorithm>

namespace skyseal::mavlink {

namespace {

/// advance() for each number of bytes, for the four bits at each of the four places of a state.
using AdvanceTable = std::array<std::array<std::array<std::uint16_t, 16>, 4>, OverlappingCrc::kLongestRange + 1>;

constexpr AdvanceTable makeAdvanceTable()
{
    AdvanceTable table{};
    for (unsigned place = 0; place < 4; ++place) {
        for (unsigned bits = 0; bits < 16; ++bits) {
            auto state = static_cast<std::uint16_t>(bits << 4 * place);
            for (auto &row : table) {
                row[place][bits] = state;
                state = crcStep(state, 0);
            }
        }
    }
    return table;
}

constexpr AdvanceTable kAdvance = makeAdvanceTable();

std::uint16_t advance(std::uint16_t state, std::size_t bytes)
{
    const auto &row = kAdvance[bytes];
    return static_cast<std::uint16_t>(row[0][state & 15] ^ row[1][state >> 4 & 15] ^ row[2][state >> 8 & 15]
                                      ^ row[3][state >> 12]);
}

} // namespace

bool OverlappingCrc::matchesByPrefixes(std::size_t offset, ByteView bytes, std::uint8_t crcExtra, std::uint16_t expected)
{
    extendPrefixes(offset, bytes);
    const auto begin = static_cast<std::uint16_t>(prefix(offset) ^ kCrcStart);
    const auto state = static_cast<std::uint16_t>(prefix(offset + bytes.size()) ^ advance(begin, bytes.size()));
    return crcStep(state, crcExtra) == expected;
}

void OverlappingCrc::expectOverlap()
{
    if (!m_overlapping)
        beginPrefixes(0);
    m_overlapping = true;
}

void OverlappingCrc::beginPrefixes(std::size_t offset)
{
    m_end = offset;
    prefix(offset) = 0;
}

/// Makes the prefixes of this range known. Bytes that lie in no range are left out: the prefixes begin anew behind them.
void OverlappingCrc::extendPrefixes(std::size_t offset, ByteView bytes)
{
    if (offset > m_end)
        beginPrefixes(offset);
    if (m_end >= offset + bytes.size())
        return;
    ByteView added = bytes.subspan(m_end - offset);
    m_processed += added.size();
    std::uint16_t state = prefix(m_end);
    while (!added.empty()) {
        // The state after the block is computed apart from those within it, since each of these waits for the one before.
        const ByteView block = added.first(std::min<std::size_t>(added.size(), 8));
        const std::uint16_t after = crcAccumulate(state, block);
        for (const std::uint8_t byte : block) {
            state = crcStep(state, byte);
            prefix(++m_end) = state;
        }
        state = after;
        added = added.subspan(block.size());
    }
}

} // namespace skyseal::mavlink
