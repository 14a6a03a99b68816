// Forged and replayed records of a session since the owner's last alarm. At most one alarm a second, so that a flood cannot
// fill a log.
#pragma once

#include "core/channel/interval_limit.h"

#include <optional>
#include <utility>

namespace skyseal::channel {

class ForgeryCounter
{
public:
    struct Counts
    {
        std::uint64_t forged = 0;
        std::uint64_t replayed = 0;
    };

    explicit ForgeryCounter(TimePoint now) : m_alarms(std::chrono::seconds(1), now) {}

    void addForged() { ++m_pending.forged; }
    /// A replayed record alone raises no alarm: networks duplicate datagrams.
    void addReplayed() { ++m_pending.replayed; }

    std::uint64_t pendingForged() const { return m_pending.forged; }
    TimePoint deadline() const { return m_pending.forged > 0 ? m_alarms.next() : kNever; }
    /// Returns the counts if an alarm is due, and starts counting anew.
    std::optional<Counts> take(TimePoint now)
    {
        if (m_pending.forged == 0 || !m_alarms.take(now))
            return std::nullopt;
        return std::exchange(m_pending, {});
    }

private:
    Counts m_pending;
    IntervalLimit m_alarms;
};

} // namespace skyseal::channel
