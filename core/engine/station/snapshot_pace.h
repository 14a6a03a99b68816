// Schedules the snapshots: at most 30 a second while something changes, two a second otherwise; or none at all. No clock.
#pragma once

#include "core/base/clock.h"

#include <algorithm>

namespace skyseal::engine {

class SnapshotPace
{
public:
    static constexpr Duration kIdlePeriod = std::chrono::milliseconds(500);

    /// `perSecond`: greatest number of snapshots a second, up to 30; 0: none becomes due.
    explicit SnapshotPace(int perSecond) { setPerSecond(perSecond); }
    void setPerSecond(int perSecond)
    {
        m_paused = perSecond <= 0;
        m_least = Duration(std::chrono::seconds(1)) / std::clamp(perSecond, 1, 30); // not of whole seconds
    }

    /// Something that a snapshot shows has changed.
    void markChanged() { m_changed = true; }
    /// Returns true, and counts the snapshot as taken, if one is due.
    bool takeIfDue(TimePoint now)
    {
        const bool first = m_last == TimePoint::min();
        if (m_paused || (!first && (now - m_last < m_least || (!m_changed && now - m_last < kIdlePeriod))))
            return false;
        m_last = now;
        m_changed = false;
        return true;
    }
    /// The number of the next snapshot, from 1.
    std::uint64_t takeNumber() { return ++m_number; }
    /// kNever while nothing has changed; the two a second are due at any other wake-up.
    TimePoint nextDeadline() const { return m_changed && !m_paused ? m_last + m_least : kNever; }

private:
    Duration m_least{};
    bool m_paused = false;
    TimePoint m_last = TimePoint::min();
    bool m_changed = true;
    std::uint64_t m_number = 0;
};

} // namespace skyseal::engine
