// Ratio of one arm's cost to another's, estimated from the blocks in which the runs were randomised.
//
// Every block holds each arm once, so that what a block shares (heat, other programs, the programs' start) cancels. How much
// the difference of two arms varies from one start of the programs to the next is a property of these starts, and repeats
// within one launch do not show it (Kalibera and Jones 2013): the launch is a random effect on the arms. Within each launch the
// arms' effects come from value = arm + block; from these effects, one of each arm and launch, the interval comes from effect =
// arm + launch, with (arms − 1)(launches − 1) degrees of freedom. With equally many runs everywhere that is the exact analysis
// of the mixed model; a run that is missing costs its block's share of the information and nothing else. One launch alone says
// nothing about another, so its interval, from the blocks, holds for that launch only.
#pragma once

#include "core/experiment/two_way_fit.h"

#include <vector>

namespace skyseal::experiment {

struct BlockValue
{
    std::size_t launch = 0, block = 0; ///< blocks are numbered within their launch
    std::size_t arm = 0;
    double value = 0;
};

struct BlockContrast
{
    double estimate = 0; ///< the second arm less the first
    double error = 0, degrees = 0;
    std::size_t units = 0; ///< launches, or blocks of the only launch, that hold both arms
};

class BlockModel
{
public:
    BlockModel(const std::vector<BlockValue> &values, std::size_t arms);

    /// False: the interval is that of a single launch.
    bool hasLaunches() const { return m_launches > 1; }
    /// NaN throughout if no block joins the two arms; `error` is NaN without degrees of freedom.
    BlockContrast contrast(std::size_t first, std::size_t second) const;

private:
    struct Reduced
    {
        std::vector<TwoWayValue> values;
        std::size_t launches = 0;
    };
    static Reduced reduced(const std::vector<BlockValue> &values, std::size_t arms);
    explicit BlockModel(Reduced reduced, std::size_t arms);

    std::vector<TwoWayValue> m_values; ///< that are fitted
    std::size_t m_launches = 0;
    TwoWayFit m_fit;
};

} // namespace skyseal::experiment
