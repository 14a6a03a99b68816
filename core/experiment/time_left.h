// How long a sweep will still take, from what its runs have taken so far. The first run of a block takes longer than the
// others, since programs start for it and settle; that is counted for each block to come, not for each run.
#pragma once

#include <cstddef>

namespace skyseal::experiment {

class TimeLeft
{
public:
    /// `planned`: seconds that a run takes at the least.
    explicit TimeLeft(double planned) : m_planned(planned) {}

    /// A run took so many seconds, since the end of the one before it.
    void runEnded(double seconds, bool firstOfBlock);
    /// Seconds, for so many runs in so many blocks that begin with one of them.
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
