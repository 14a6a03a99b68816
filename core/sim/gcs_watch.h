// Notices that the ground station fell silent: its heartbeats stopped after at least one was heard.
#pragma once

#include "core/base/clock.h"

namespace skyseal::sim {

class GcsWatch
{
public:
    enum class Event { None, Lost, Back };

    /// A heartbeat of the one station that counts (SYSID_MYGCS).
    void heartbeat(TimePoint now)
    {
        m_seen = true;
        m_last = now;
    }

    bool lost() const { return m_lost; }

    /// A change since the last call; each is told once.
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
