// A message that is sent again until it is answered: after the measured round trip for the first attempts, then after twice as
// long again and again. No I/O and no clock.
#pragma once

#include "core/vehicle/rtt_estimator.h"

#include <algorithm>

namespace skyseal::vehicle {

class Repetition
{
public:
    static constexpr int kQuickAttempts = 3; ///< at the same pace

    /// `slowest`: the pace slows down to this, or to that of the round trip if that is longer.
    explicit Repetition(Duration slowest = RttEstimator::kMostTimeout) : m_slowest(slowest) {}

    /// Another message takes the place of the one before.
    void begin() { m_attempts = 0; }
    /// The message was sent, for the first time or again.
    void sent(TimePoint now, const RttEstimator &rtt)
    {
        if (m_attempts++ == 0)
            m_first = now;
        const Duration most = std::max(m_slowest, rtt.timeout());
        Duration patience = rtt.timeout();
        for (int i = kQuickAttempts; i < m_attempts && patience < most; ++i)
            patience *= 2;
        m_due = now + std::min(patience, most);
    }
    /// Nothing is to be repeated.
    void stop() { m_due = kNever; }
    /// For a reason of its own the message is not due before this time.
    void postpone(TimePoint until) { m_due = until; }

    /// The message was answered. Of one that was sent several times nobody knows which is answered: it measures nothing (Karn's
    /// algorithm).
    void measure(TimePoint now, RttEstimator &rtt) const
    {
        if (m_attempts == 1)
            rtt.measure(now - m_first);
    }

    int attempts() const { return m_attempts; }
    bool isRepeated() const { return m_attempts > 1; }
    TimePoint first() const { return m_first; }
    /// The message is due again; kNever while none is.
    TimePoint due() const { return m_due; }

private:
    Duration m_slowest;
    int m_attempts = 0;
    TimePoint m_first{};
    TimePoint m_due = kNever;
};

} // namespace skyseal::vehicle
