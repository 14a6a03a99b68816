// How the CPU time of an arm depends on its load: a + b × frames + c × wake-ups, fitted to the runs of a sweep's paced loads.
// A frame costs what it costs to open and to handle; a wake-up costs the same whatever the cipher, and several frames share it.
// Pure functions.
#pragma once

#include "core/experiment/least_squares.h"
#include "core/experiment/results.h"

#include <limits>

namespace skyseal::experiment {

enum class LinkEnd : std::uint8_t { Station, Agent };
std::string_view name(LinkEnd end);

struct CostModel
{
    std::size_t condition = 0, arm = 0;
    LinkEnd end{};
    /// Of CPU time in ns per second: what passes without a load, ns; ns for a frame; ns for a wake-up.
    LinearFit fit;
    /// Standard deviation between launches, ns per second; NaN of a single launch, whose interval holds for it alone.
    double launchDeviation = std::numeric_limits<double>::quiet_NaN();
    unsigned launches = 1;
    /// Half of the 95 % interval of a term. Between launches the constant has launches − 1 degrees of freedom.
    double halfWidth(std::size_t term) const;
    std::vector<const Sample *> runs; ///< of each residual; they point into the results
    std::vector<double> values;       ///< CPU time of each run, ns per second

    static constexpr std::size_t kConstant = 0, kPerFrame = 1, kPerWakeUp = 2, kTerms = 3;
};

/// One for each condition, arm (but the repeated one) and end that has valid runs of at least two paced loads, more runs than
/// terms, and whose frames and wake-ups do not depend on each other. With the launch as a random effect (random_intercept.h);
/// of a single launch, or where there are too few runs for that, by ordinary least squares.
std::vector<CostModel> costModels(const Results &results);

/// For a report: the coefficients with their intervals, and the residuals of each load. Empty without a paced load.
std::string costModelHtml(const Results &results);

} // namespace skyseal::experiment
