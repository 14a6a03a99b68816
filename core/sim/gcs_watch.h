// Detects the loss of the ground station: its heartbeats stopped after at least one arrived.
#pragma once

#include "core/base/clock.h"

namespace skyseal::sim {

class GcsWatch
{
public:
    enum class Event { None, Lost, Back };

    /// A heartbeat of the station with the system id SYSID_MYGCS.
    void heartbeat(TimePoint now)
    {
        m_seen = true;
        m_last = now;
    }

    bool lost() const { return m_lost; }

    /// Returns the change since the last call.
    Event update(TimePoint now, Duration timeout)
    {
        const bool silent = m_seen && now - m_last > timeout;
        if (silent == m_lost)
            return Event::None;
        m_lost = silent;
        return silent ? Event::Lost : Event::Back;
    }

private:
    bool m_seen = false;
    bool m_lost = false;
    TimePoint m_last{};
};

} // namespace skyseal::sim
