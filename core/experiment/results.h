// What a sweep brought: every single measurement as it was taken, and where and with what it was taken. Everything else
// (means, figures, reports) is computed from this.
#pragma once

#include "core/channel/stats.h"
#include "core/experiment/metric.h"
#include "core/experiment/plan.h"

#include <string>
#include <utility>
#include <vector>

namespace skyseal::experiment {

/// What was counted up to a moment, since the link was opened for this and its neighbouring runs: whole numbers, so that a
/// run's losses can be checked one by one against somebody else's account of the same link.
struct Counted
{
    struct Frames
    {
        std::uint64_t taken = 0, lost = 0, late = 0, duplicate = 0;
    };
    Frames mavlink;              ///< by MAVLink's sequence numbers
    channel::ReceiveCounters rx; ///< records to the station
    channel::ReceiveCounters tx; ///< records to the agent, as it told last
};

struct Sample
{
    Run run;
    unsigned order = 0; ///< of all runs of the sweep, as they were made; the first is 0
    double start = 0;   ///< seconds since the sweep began
    double seconds = 0; ///< that were measured
    Values values;
    Counted begin, end;  ///< at the run's edges
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
