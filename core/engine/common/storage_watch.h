// Reports that the counters of handshakes cannot be stored: at the beginning, each minute while it lasts, and at the end.
// No I/O and no clock.
#pragma once

#include "core/base/clock.h"
#include "core/base/reason.h"

#include <optional>

namespace skyseal::engine {

/// Event: this program cannot store the counters of handshakes, or can store them again.
struct CounterStorage
{
    Reason problem; ///< empty: they can be stored again
};

class StorageWatch
{
public:
    static constexpr Duration kRepeatEvery = std::chrono::minutes(1);

    /// Takes the state of the store, about once a second. Returns the event that is due.
    std::optional<CounterStorage> note(TimePoint now, Reason problem)
    {
        const bool wasFailing = !m_problem.empty();
        m_problem = std::move(problem);
        if (m_problem.empty()) {
            m_due = TimePoint::min();
            return wasFailing ? std::optional(CounterStorage{}) : std::nullopt;
        }
        if (now < m_due)
            return std::nullopt;
        m_due = now + kRepeatEvery;
        return CounterStorage{m_problem};
    }
    const Reason &problem() const { return m_problem; }

private:
    Reason m_problem;
    TimePoint m_due = TimePoint::min();
};

} // namespace skyseal::engine
