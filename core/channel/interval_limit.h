// At most one event or message in an interval.
#pragma once

#include "core/base/clock.h"

namespace skyseal::channel {

class IntervalLimit
{
public:
    /// The first one is due at `now`.
    IntervalLimit(Duration interval, TimePoint now) : m_interval(interval), m_next(now) {}

    /// Returns true if one is due, and starts the next interval.
    bool take(TimePoint now)
    {
        if (now < m_next)
            return false;
        m_next = now + m_interval;
        return true;
    }
    /// Time from which the next one is due.
    TimePoint next() const { return m_next; }

private:
    Duration m_interval;
    TimePoint m_next;
};

} // namespace skyseal::channel
