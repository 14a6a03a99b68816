// Reports that the counters of handshakes cannot be stored: at the beginning, each minute while it lasts, and at the end.
// No I/O and no clock.
#pragma once

#include "core/base/clock.h"

#include <optional>
#include <string>

namespace skyseal::engine {

/// Event: this program cannot store the counters of handshakes, or can store them again.
struct CounterStorage
{
    std::string problem; ///< empty: they can be stored again
};

class StorageWatch
{
public:
    static constexpr Duration kRepeatEvery = std::chrono::minutes(1);

    /// Takes the state of the store, about once a second. Returns the event that is due.
    std::optional<CounterStorage> note(TimePoint now, std::string problem)
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
    const std::string &problem() const { return m_problem; }

private:
    std::string m_problem;
    TimePoint m_due = TimePoint::min();
};

} // namespace skyseal::engine
