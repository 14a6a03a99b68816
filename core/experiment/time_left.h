// Estimates the remaining time of a sweep from the durations of its runs so far. The first run of a block takes longer, since
// programs are started for it; this extra time is added once for each remaining block.
#pragma once

#include <cstddef>

namespace skyseal::experiment {

class TimeLeft
{
public:
    /// `planned`: least duration of a run in seconds.
    explicit TimeLeft(double planned) : m_planned(planned) {}

    /// `seconds`: from the end of the previous run to the end of this one.
    void runEnded(double seconds, bool firstOfBlock);
    /// Seconds for the remaining runs, of which `blocks` are the first of a block.
    double of(std::size_t runs, std::size_t blocks) const;

private:
    struct Mean
    {
        double sum = 0;
        std::size_t count = 0;
        double value(double otherwise) const { return count > 0 ? sum / static_cast<double>(count) : otherwise; }
    };
    double m_planned;
    Mean m_first, m_others;
};

} // namespace skyseal::experiment
