// The time line of a recording: from the recorded times of its entries to positions since its beginning, which never decrease.
#pragma once

#include "core/base/clock.h"

#include <optional>

namespace skyseal::tlog {

class LogTime
{
public:
    /// A longer step forward is no pause in the recording but a clock that was set, or a damaged time.
    static constexpr std::chrono::hours kLongestStep{24};
    /// Silence for which a replay waits: by then every vehicle is lost, and nothing else would be seen before the next entry.
    static constexpr std::chrono::seconds kLongestWait{5};
    /// The line ends here, at 20 days, so that no arithmetic on positions overflows; milliseconds of it fit 31 bits.
    static constexpr std::chrono::hours kLongest{480};

    /// Takes the time of the next entry and returns its position. An entry without a time has the position of the one before
    /// it. When the clock was set, back or far forward, no time passes.
    Duration note(std::optional<WallTime> time);

    /// Of the last entry.
    Duration position() const { return m_position; }
    /// Recorded time of the first entry that has one; nullopt before it, and in a file without times.
    std::optional<WallTime> first() const { return m_first; }

private:
    std::optional<WallTime> m_first, m_last;
    Duration m_position{};
};

} // namespace skyseal::tlog
