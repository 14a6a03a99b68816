#include "core/experiment/run_queue.h"

#include <tuple>
#include <utility>

namespace skyseal::experiment {

namespace {

constexpr double kBetweenRuns = 0.2; ///< seconds, for the switch from one run to the next

} // namespace

RunQueue::RunQueue(const Plan &plan) : m_runs(schedule(plan)), m_timeLeft(seconds(plan.measure + plan.warmUp) + kBetweenRuns) {}

void RunQueue::finishRun(double now)
{
    m_timeLeft.runEnded(now - std::exchange(m_lastEnd, now), atBlockStart());
    ++m_position;
}

double RunQueue::remaining() const
{
    std::size_t blocks = 0;
    for (std::size_t i = m_position; i < m_runs.size(); ++i)
        blocks += beginsBlock(i);
    return m_timeLeft.of(m_runs.size() - m_position, blocks);
}

bool RunQueue::beginsBlock(std::size_t run) const
{
    const auto blockOf = [](const Run &one) { return std::tuple(one.launch, one.condition, one.load); };
    return run == 0 || blockOf(m_runs[run]) != blockOf(m_runs[run - 1]);
}

} // namespace skyseal::experiment
