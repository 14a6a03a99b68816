// One timer of the event loop for the deadlines of protocol objects, which have no timers. I/O thread.
#pragma once

#include "core/link/steady_now.h"

#include <QtCore/QTimer>

#include <algorithm>
#include <functional>

namespace skyseal::engine {

/// Calls back once at the time that was last set, never earlier.
class DeadlineTimer
{
public:
    explicit DeadlineTimer(std::function<void()> due)
    {
        m_timer.setSingleShot(true);
        m_timer.setTimerType(Qt::PreciseTimer);
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, std::move(due));
    }

    /// kNever stops it. Cheap if the time has not changed.
    void set(TimePoint moment)
    {
        if (moment == m_moment && (m_timer.isActive() || moment == kNever))
            return;
        m_moment = moment;
        if (moment == kNever) {
            m_timer.stop();
            return;
        }
        const TimePoint now = steadyNow();
        const Duration wait = moment <= now ? Duration::zero() : moment - now; // TimePoint::min() is "at once"
        m_timer.start(std::min(std::chrono::ceil<std::chrono::milliseconds>(wait), kLongest));
    }

private:
    static constexpr std::chrono::milliseconds kLongest = std::chrono::hours(1);

    QTimer m_timer;
    TimePoint m_moment = kNever;
};

} // namespace skyseal::engine
