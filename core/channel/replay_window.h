// Which counters of one epoch and direction were seen: a ring of bit blocks that moves forward (RFC 6479), and the
// account of what is missing, which is exact because every epoch begins at counter 0.
#pragma once

#include "core/base/weakness.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace skyseal::channel {

/// Ask `fresh` before the tag is verified, `mark` only after: a forged counter must not move the window.
class ReplayWindow
{
public:
    static constexpr std::uint32_t kEntries = 2048;

    enum class Arrival : std::uint8_t { Newest, Late };

    /// False for a counter that was seen, or that is `kEntries` or more behind the newest.
    bool fresh(std::uint32_t counter) const
    {
        if (counter >= m_next || weakened(Weakness::NoReplayWindow))
            return true;
        return m_next - 1 - counter < kEntries && (block(counter) & bit(counter)) == 0;
    }

    /// Precondition: `fresh(counter)`, and the record that carried it is authentic.
    Arrival mark(std::uint32_t counter)
    {
        const bool newest = counter >= m_next;
        if (newest)
            advanceTo(counter);
        block(counter) |= bit(counter);
        ++m_seen;
        return newest ? Arrival::Newest : Arrival::Late;
    }

    /// One past the newest counter; 0 while nothing was seen.
    std::uint32_t next() const { return m_next; }
    std::uint64_t seen() const { return m_seen; }

    /// The sender's own account of how many records it sent; reveals the loss of the last ones.
    void expect(std::uint32_t sent) { m_expected = sent > m_expected ? sent : m_expected; }
    /// Counters that were sent as far as known and have not arrived (yet).
    std::uint64_t missing() const { return (m_next > m_expected ? m_next : m_expected) - m_seen; }

private:
    static constexpr std::uint32_t kBlockBits = 64;
    static constexpr std::uint32_t kBlocks = 64; ///< a power of two with at least one block more than the entries need
    static_assert(kBlocks * kBlockBits >= kEntries + kBlockBits);

    static std::uint64_t bit(std::uint32_t counter) { return std::uint64_t{1} << (counter % kBlockBits); }
    std::uint64_t &block(std::uint32_t counter) { return m_blocks[counter / kBlockBits % kBlocks]; }
    const std::uint64_t &block(std::uint32_t counter) const { return m_blocks[counter / kBlockBits % kBlocks]; }

    void advanceTo(std::uint32_t counter)
    {
        // Blocks that come into the window for the first time are cleared; at the first call block 0 is clear already.
        const std::uint32_t from = m_next == 0 ? 0 : (m_next - 1) / kBlockBits;
        const std::uint32_t steps = counter / kBlockBits - from;
        for (std::uint32_t i = 1; i <= steps && i <= kBlocks; ++i)
            m_blocks[(from + i) % kBlocks] = 0;
        m_next = counter + 1;
    }

    std::array<std::uint64_t, kBlocks> m_blocks{};
    std::uint32_t m_next = 0;
    std::uint32_t m_expected = 0;
    std::uint64_t m_seen = 0;
};

} // namespace skyseal::channel
