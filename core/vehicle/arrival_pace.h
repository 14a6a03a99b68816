// Intervals between the messages of an answer that has many. They show when it has paused: it has ended, or its end was lost.
// No clock.
#pragma once

#include "core/vehicle/rtt_estimator.h"

#include <optional>

namespace skyseal::vehicle {

class ArrivalPace
{
public:
    /// A request was sent: the time until the first message of its answer is no interval.
    void restart() { m_latest.reset(); }
    /// True until the first message since the request arrives.
    bool isWaiting() const { return !m_latest; }
    void arrived(TimePoint now)
    {
        if (m_latest)
            m_intervals.measure(now - *m_latest);
        m_latest = now;
    }
    /// Without a message for so long, the answer has paused.
    Duration pause() const { return m_intervals.timeout() * 2; }

private:
    RttEstimator m_intervals;
    std::optional<TimePoint> m_latest;
};

} // namespace skyseal::vehicle
