// What a sweep brought: every single measurement as it was taken, and where and with what it was taken. Everything else
// (means, figures, reports) is computed from this.
#pragma once

#include "core/experiment/metric.h"
#include "core/experiment/plan.h"

#include <string>
#include <utility>
#include <vector>

namespace skyseal::experiment {

struct Sample
{
    Run run;
    unsigned order = 0;  ///< of all runs of the sweep, as they were made; the first is 0
    double start = 0;    ///< seconds since the sweep began
    double seconds = 0;  ///< that were measured
    Values values;
    std::string problem; ///< why nothing was measured; empty when all is well
};

/// Names and values in the order in which they are shown: "machine", "processor", "libsodium", …
using Setting = std::vector<std::pair<std::string, std::string>>;

struct Results
{
    Plan plan;
    Setting setting;
    std::vector<Sample> samples;
    bool complete = false; ///< false: cancelled, or given up
    double seconds = 0;    ///< that the sweep took
};

/// One place of the design: all its repeats belong together.
struct Cell
{
    std::size_t condition = 0, load = 0, arm = 0;
    bool operator==(const Cell &) const = default;
};

std::vector<Cell> cells(const Plan &plan);
/// The samples of a cell in the order of their repeats, NaN where one could not be measured.
std::vector<double> valuesOf(const Results &results, const Cell &cell, Metric metric);
/// The numbers (Sample::order) that belong to valuesOf.
std::vector<unsigned> ordersOf(const Results &results, const Cell &cell);

} // namespace skyseal::experiment
