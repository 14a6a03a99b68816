// One SequenceTracker for every (link, system, component) that sends to us: a vehicle with an autopilot, a gimbal and a
// companion counts three sequences, and each link loses its own.
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
        bool operator==(const Sender &) const = default;
    };

    SequenceTable();

    /// Counts one frame. Allocates only for a sender that was never seen. Where anybody can send, anybody can make senders up:
    /// when kMostSenders are known, a new one takes the place of the one that was silent longest, and what that one counted
    /// stays in the sums. One that has been heard kEstablishedAfter times, and within kEstablishedFor, keeps its place; when
    /// all are such, the new one is counted in untracked() alone.
    void note(const Sender &sender, std::uint8_t sequence, TimePoint now);
    void expectRestart(const Sender &sender);

    /// Zeros for a sender that was never seen.
    SequenceCounts counts(const Sender &sender) const;
    SequenceCounts countsOfSystem(std::uint8_t system) const;
    SequenceCounts countsOfLink(LinkId link) const; ///< of the senders that are known now
    SequenceCounts total() const;
    std::size_t size() const { return m_trackers.size(); }
    std::uint64_t evicted() const { return m_evicted; }     ///< senders that gave their place to a new one
    std::uint64_t untracked() const { return m_untracked; } ///< frames of senders that found no place

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
