#include "core/experiment/time_left.h"

#include <algorithm>

namespace skyseal::experiment {

void TimeLeft::runEnded(double seconds, bool firstOfBlock)
{
    Mean &mean = firstOfBlock ? m_first : m_others;
    mean.sum += seconds;
    ++mean.count;
}

double TimeLeft::of(std::size_t runs, std::size_t blocks) const
{
    const double run = std::max(m_planned, m_others.value(m_planned));
    const double start = std::max(0.0, m_first.value(run) - run);
    return static_cast<double>(runs) * run + static_cast<double>(blocks) * start;
}

} // namespace skyseal::experiment
