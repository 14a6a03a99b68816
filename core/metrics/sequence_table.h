// One SequenceTracker for each sender (link, system, component, address): every MAVLink component has its own sequence, and
// every link its own losses. A vehicle with two modems numbers the frames of each by itself, also where both end at one
// listening link.
#pragma once

#include "core/base/path.h"
#include "core/metrics/sequence_tracker.h"

#include <array>
#include <cstddef>
#include <unordered_map>

namespace skyseal::metrics {

class SequenceTable
{
public:
    struct Sender
    {
        LinkId link{};
        std::uint8_t system = 0;
        std::uint8_t component = 0;
        Address remote = {}; ///< all zero where the sequence is the same from any address, as in a session
        bool operator==(const Sender &) const = default;
    };

    SequenceTable();

    /// Counts one frame. Allocates only for a new sender. Since plain MAVLink senders can be forged, the table is bounded:
    /// when kMostSenders are known, a new sender replaces the one that was silent longest, whose counts stay in the sums. An
    /// established sender (kEstablishedAfter frames, the last within kEstablishedFor) is not replaced; when all are
    /// established, frames of new senders count only in untracked().
    void note(const Sender &sender, std::uint8_t sequence, TimePoint now);
    void expectRestart(const Sender &sender);

    /// All zero for an unknown sender.
    SequenceCounts counts(const Sender &sender) const;
    SequenceCounts countsOfSystem(std::uint8_t system) const;
    SequenceCounts total() const;
    std::size_t size() const { return m_trackers.size(); }
    std::uint64_t evicted() const { return m_evicted; }     ///< senders that were replaced
    std::uint64_t untracked() const { return m_untracked; } ///< frames of senders for which there was no place

    static constexpr std::size_t kMostSenders = 256;
    static constexpr std::uint64_t kEstablishedAfter = 8;
    static constexpr Duration kEstablishedFor = std::chrono::seconds(10);

private:
    struct Hash
    {
        std::size_t operator()(const Sender &sender) const;
    };

    bool makeRoom(TimePoint now);

    std::unordered_map<Sender, SequenceTracker, Hash> m_trackers;
    std::array<SequenceCounts, 256> m_evictedOfSystem{};
    std::uint64_t m_evicted = 0;
    std::uint64_t m_untracked = 0;
};

} // namespace skyseal::metrics
