// MAVLink sequence loss of one sender on one link. The sequence number has 8 bits, so a late frame would look like 255 lost
// ones; a window therefore keeps the numbers that are missing. A late frame takes its loss back, a second copy counts as a
// duplicate, and a restart of the sender is detected instead of counting its next 256 frames as late.
#pragma once

#include "core/base/clock.h"

#include <bitset>
#include <cstdint>

namespace skyseal::metrics {

struct SequenceCounts
{
    std::uint64_t received = 0; ///< frames, duplicates included
    std::uint64_t lost = 0;     ///< skipped numbers that have not arrived (yet)
    std::uint64_t late = 0;     ///< frames that arrived after a newer one
    std::uint64_t duplicate = 0;
    std::uint64_t restarts = 0; ///< restarts of the sender, and silences longer than kLongestSilence

    SequenceCounts &operator+=(const SequenceCounts &other);
    bool operator==(const SequenceCounts &) const = default;
};

class SequenceTracker
{
public:
    enum class Verdict : std::uint8_t { First, InOrder, AfterGap, Late, Duplicate, Restarted };

    /// Counts a frame that arrived at `now`.
    Verdict note(std::uint8_t sequence, TimePoint now);
    /// The caller knows that the sender restarted (its clock stepped back, a new session): the next number is no gap.
    void expectRestart() { m_known = false; }

    const SequenceCounts &counts() const { return m_counts; }
    TimePoint lastHeard() const { return m_lastTime; }

    /// Distance behind the newest number that still counts as late or duplicate; a larger distance counts as a jump ahead
    /// with losses. The window shrinks by one per millisecond since the newest frame (1000 frames/s is a fast link), down to
    /// kShortWindow, since more numbers may have been sent and lost meanwhile. This allows 150 ms of jitter at 1000 frames/s
    /// and 190 consecutive losses after a pause.
    static constexpr unsigned kWindow = 192;
    static constexpr unsigned kShortWindow = 64;
    /// This many duplicates in one run of consecutive numbers mean that the sender restarted.
    static constexpr unsigned kRestartRun = 16;
    /// After this silence the 8-bit number may have wrapped, so the gap is not counted as loss.
    static constexpr Duration kLongestSilence = std::chrono::seconds(10);

private:
    unsigned windowAt(TimePoint now) const;
    Verdict begin(std::uint8_t sequence, TimePoint now);
    Verdict ahead(std::uint8_t sequence, unsigned step, TimePoint now);
    Verdict behind(std::uint8_t sequence, unsigned back, TimePoint now);
    Verdict restarted(std::uint8_t sequence, TimePoint now);

    bool m_known = false;
    std::uint8_t m_newest = 0;
    std::bitset<kWindow> m_missing; ///< bit k: number m_newest − 1 − k was skipped and counted as lost
    std::bitset<kWindow> m_before;  ///< bit k: that number precedes the first received frame, so it was not counted
    TimePoint m_lastTime{};
    TimePoint m_newestTime{};
    bool m_inRun = false; ///< consecutive numbers behind the newest are arriving
    std::uint8_t m_runNext = 0;
    unsigned m_runDuplicates = 0;
    SequenceCounts m_beforeRun; ///< restored when the run turns out to be a restart
    SequenceCounts m_counts;
};

} // namespace skyseal::metrics
