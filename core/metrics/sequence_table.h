// One SequenceTracker for every (link, system, component) that sends to us: a vehicle with an autopilot, a gimbal and a
// companion counts three sequences, and each link loses its own.
#pragma once

#include "core/base/path.h"
#include "core/metrics/sequence_tracker.h"

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

    /// Counts one frame. Allocates only for a sender that was never seen; beyond kMostSenders (somebody forges them) new
    /// ones are counted in untracked() alone.
    void note(const Sender &sender, std::uint8_t sequence, TimePoint now);
    void expectRestart(const Sender &sender);

    /// Zeros for a sender that was never seen.
    SequenceCounts counts(const Sender &sender) const;
    SequenceCounts countsOfSystem(std::uint8_t system) const;
    SequenceCounts countsOfLink(LinkId link) const;
    SequenceCounts total() const;
    std::uint64_t untracked() const { return m_untracked; }

    static constexpr std::size_t kMostSenders = 1024;

private:
    struct Hash
    {
        std::size_t operator()(const Sender &sender) const;
    };

    std::unordered_map<Sender, SequenceTracker, Hash> m_trackers;
    std::uint64_t m_untracked = 0;
};

} // namespace skyseal::metrics
