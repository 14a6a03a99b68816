// MAVLink sequence loss of one sender on one link, counted as a person would count it: the sequence is 8 bits wide, so a
// late frame looks like 255 lost ones unless a window remembers which numbers are still missing. A frame that comes late
// takes its loss back, a second copy is a duplicate, and a sender that restarted is noticed instead of being called late
// for the next 256 frames.
#pragma once

#include "core/base/clock.h"

#include <bitset>
#include <cstdint>

namespace skyseal::metrics {

struct SequenceCounts
{
    std::uint64_t received = 0; ///< frames given to note(), duplicates included
    std::uint64_t lost = 0;     ///< numbers passed over and not (yet) seen
    std::uint64_t late = 0;     ///< arrived after a later one
    std::uint64_t duplicate = 0;
    std::uint64_t restarts = 0; ///< the sender began anew, or was silent for too long to count across

    SequenceCounts &operator+=(const SequenceCounts &other);
    bool operator==(const SequenceCounts &) const = default;
};

class SequenceTracker
{
public:
    enum class Verdict : std::uint8_t { First, InOrder, AfterGap, Late, Duplicate, Restarted };

    /// Takes the sequence number of a frame that arrived at `now`.
    Verdict note(std::uint8_t sequence, TimePoint now);
    /// The caller knows that the sender restarted (its clock went back, a new session): nothing is lost in between.
    void expectRestart() { m_known = false; }

    const SequenceCounts &counts() const { return m_counts; }
    TimePoint lastHeard() const { return m_lastTime; }

    /// How far back a number is taken as late or duplicate right after the newest one; jumps ahead of up to 255 − kWindow
    /// are taken as loss. The longer the newest one is ago, the more numbers may have been sent and lost since, so that the
    /// window shrinks by one for each millisecond, a quick link's pace, down to kShortWindow. That holds 150 ms of jitter at
    /// 1000 frames a second, and 190 lost in a row after a pause.
    static constexpr unsigned kWindow = 192;
    static constexpr unsigned kShortWindow = 64;
    /// So many duplicates in one unbroken run of successive numbers are a sender that restarted.
    static constexpr unsigned kRestartRun = 16;
    /// After this silence the 8-bit number may have gone round, so the gap is not counted.
    static constexpr Duration kLongestSilence = std::chrono::seconds(10);

private:
    unsigned windowAt(TimePoint now) const;
    Verdict begin(std::uint8_t sequence, TimePoint now);
    Verdict ahead(std::uint8_t sequence, unsigned step, TimePoint now);
    Verdict behind(std::uint8_t sequence, unsigned back, TimePoint now);
    Verdict restarted(std::uint8_t sequence, TimePoint now);

    bool m_known = false;
    std::uint8_t m_newest = 0;
    std::bitset<kWindow> m_missing; ///< bit k: number m_newest − 1 − k was passed over and counted as lost
    std::bitset<kWindow> m_before;  ///< bit k: that number was sent before we began to listen, so it was never counted
    TimePoint m_lastTime{};
    TimePoint m_newestTime{};
    bool m_inRun = false; ///< successive numbers behind the newest are coming in
    std::uint8_t m_runNext = 0;
    unsigned m_runDuplicates = 0;
    SequenceCounts m_beforeRun; ///< to take back what a run was counted as, once it proves to be a restart
    SequenceCounts m_counts;
};

} // namespace skyseal::metrics
