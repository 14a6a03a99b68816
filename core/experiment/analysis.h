// Statistics of a sweep: a summary for each cell of the design, and trends. Pure functions of the results. README.md describes
// the methods; contrast.h compares arms.
#pragma once

#include "core/experiment/results.h"
#include "core/experiment/statistics.h"

#include <vector>

namespace skyseal::experiment {

/// Summarises the samples of a cell. There is no interval if the runs are not independent (MetricInfo::independent). No metric
/// can be negative, so intervals are cut off at zero, and those of shares at one. If nothing was lost in any run, Student's t
/// has no variance to use: the interval ends at boundOfNone() for all frames or records of these runs together.
Summary summaryOf(const Results &results, const Cell &cell, Metric metric);

/// Whether the values of a metric rose or fell with the order of the runs of a launch, whatever the arm: programs that had not
/// warmed up, or a machine that slowed down.
struct OrderTrend
{
    std::size_t condition = 0, load = 0;
    Metric metric{};
    double perRun = 0; ///< relative change from one run to the next: 0.001 is a tenth of a per cent
    double p = 1;      ///< corrected over all such tests of the sweep
    bool remains() const { return p < 0.05; }
};

/// By log(value) = arm + launch + slope × order (least_squares.h), within each condition and load, for the metrics that compare
/// costs and have more positive values than that has terms. Launches differ from each other, which is no trend.
std::vector<OrderTrend> orderTrends(const Results &results);
/// Mean of the samples of an arm; NaN if there are none.
double meanOf(const Results &results, std::size_t condition, std::size_t load, const SweepArm &arm, Metric metric);
/// True if any sample of the sweep has a value.
bool wasMeasured(const Results &results, Metric metric);

} // namespace skyseal::experiment
