// The runs of a sweep in the order of its schedule: the current one, where a block begins, and the time that is left.
#pragma once

#include "core/experiment/plan.h"
#include "core/experiment/time_left.h"

namespace skyseal::experiment {

class RunQueue
{
public:
    explicit RunQueue(const Plan &plan);

    std::size_t size() const { return m_runs.size(); }
    /// Index of the current run; size() at the end. It is the run's Sample::order.
    std::size_t position() const { return m_position; }
    bool atEnd() const { return m_position == m_runs.size(); }
    /// Must not be called at the end.
    const Run &current() const { return m_runs[m_position]; }
    /// True if the current run is the first of its launch, condition and load. The programs of a lab are started for it.
    bool atBlockStart() const { return beginsBlock(m_position); }
    /// Ends the current run. `now`: seconds since the sweep began.
    void finishRun(double now);
    /// Estimate in seconds until the last run ends.
    double remaining() const;

private:
    bool beginsBlock(std::size_t run) const;

    std::vector<Run> m_runs;
    TimeLeft m_timeLeft;
    std::size_t m_position = 0;
    double m_lastEnd = 0; ///< seconds since the sweep began
};

} // namespace skyseal::experiment
