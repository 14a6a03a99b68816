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

/// Enough for a damaged frame that claims the greatest length, and the longest frame after it, in a datagram of the two.
constexpr std::size_t kReserve = 2 * OverlappingCrc::kLongestRange;

/// Of random bytes about 32 % go through the CRC: twice as much is allowed from the longest datagram of Ethernet on. Beyond it,
/// the share is above that of random bytes, so that they cost no frame.
std::size_t ofDatagram(std::size_t received)
{
    constexpr std::size_t kEthernet = 1472;
    return kReserve + received / 4 + (received > kEthernet ? (received - kEthernet) / 8 : 0);
}

/// A stream has no end at which a remainder is lost: the longer it is, the less the constant matters.
std::size_t ofStream(std::size_t received)
{
    return kReserve + received / 16 * 9;
}

} // namespace

bool OverlappingCrc::affords(std::size_t offset, std::size_t bytes, std::size_t received) const
{
    if (m_limit == WastedWork::Unlimited)
        return true;
    return m_wasted + unprocessed(offset, bytes)
        <= (m_limit == WastedWork::OfDatagram ? ofDatagram(received) : ofStream(received));
}

/// Number of these bytes that a check would process.
std::size_t OverlappingCrc::unprocessed(std::size_t offset, std::size_t bytes) const
{
    if (!m_overlapping || offset > m_end)
        return bytes;
    return offset + bytes > m_end ? offset + bytes - m_end : 0;
}

bool OverlappingCrc::matchesByPrefixes(std::size_t offset, ByteView bytes, std::uint8_t crcExtra, std::uint16_t expected)
{
    const std::uint64_t before = m_processed;
    extendPrefixes(offset, bytes);
    const auto begin = static_cast<std::uint16_t>(prefix(offset) ^ kCrcStart);
    const auto state = static_cast<std::uint16_t>(prefix(offset + bytes.size()) ^ advance(begin, bytes.size()));
    const bool matches = crcStep(state, crcExtra) == expected;
    m_wasted += matches ? 0 : m_processed - before;
    return matches;
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

/// Computes the prefixes of this range. Bytes outside of all ranges are skipped: the prefixes start anew after them.
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
