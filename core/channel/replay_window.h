// Replay window of one epoch and direction: a ring of bit blocks (RFC 6479). It also counts the missing records, exactly, since
// every epoch begins at counter 0.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace skyseal::channel {

/// Call fresh() before the tag is verified and mark() only after it: a forged counter must not move the window.
class ReplayWindow
{
public:
    static constexpr std::uint32_t kEntries = 2048;

    enum class Arrival : std::uint8_t { Newest, Late };

    /// Returns false for a counter that was seen, or is `kEntries` or more behind the newest.
    bool fresh(std::uint32_t counter) const
    {
        if (counter >= m_next)
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

    /// One past the newest counter; 0 if none was seen.
    std::uint32_t next() const { return m_next; }
    std::uint64_t seen() const { return m_seen; }

    /// Sets the sender's own count of its records, which reveals the loss of the last ones.
    void expect(std::uint32_t sent) { m_expected = sent > m_expected ? sent : m_expected; }
    /// Counters known to be sent that have not arrived (yet).
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
        // Clear the blocks that enter the window; block 0 is clear at the first call.
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
