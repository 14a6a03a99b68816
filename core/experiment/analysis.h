// Statistics of a sweep: a summary for each cell of the design, the significant differences between suites, and the noise of
// the machine (A/A). Pure functions of the results. README.md describes the methods.
#pragma once

#include "core/experiment/results.h"
#include "core/experiment/statistics.h"

#include <optional>
#include <vector>

namespace skyseal::experiment {

/// Compares two arms by one metric under one condition and load. The p value is corrected over all pairs of arms of that
/// metric, condition and load. The repeated arm (A/A) is left out, and plain MAVLink where its value is zero by definition.
struct ArmComparison
{
    std::size_t condition = 0, load = 0;
    Metric metric{};
    std::size_t first = 0, second = 0; ///< indices of arms
    double firstMean = 0;
    Comparison comparison;
};

/// Compares an arm with its repetition (A/A). The p value is corrected over all such tests of the sweep.
struct NoiseCheck
{
    std::size_t condition = 0, load = 0;
    Metric metric{};
    std::size_t arm = 0, again = 0; ///< indices of arms
    double mean = 0, meanAgain = 0;
    Comparison comparison;
    bool differs() const { return comparison.significant(); }
};

/// Summarises the samples of a cell. There is no interval if the runs are not independent (MetricInfo::independent). No metric
/// can be negative, so intervals are cut off at zero, and those of shares at one. If nothing was lost in any run, Student's t
/// has no variance to use: the interval ends at boundOfNone() for all frames or records of these runs together.
Summary summaryOf(const Results &results, const Cell &cell, Metric metric);

std::vector<ArmComparison> compareArms(const Results &results, std::size_t condition, std::size_t load, Metric metric);
/// For every condition, load and metric. Empty without a repeated arm; metrics with fewer than two samples are left out.
std::vector<NoiseCheck> noiseOf(const Results &results);
/// Whether the values of a metric rose or fell with the order of the runs, whatever the arm: programs that had not warmed up,
/// or a machine that slowed down.
struct OrderTrend
{
    std::size_t condition = 0, load = 0;
    Metric metric{};
    double perRun = 0; ///< relative change from one run to the next: 0.001 is a tenth of a per cent
    double p = 1;      ///< corrected over all such tests of the sweep
    bool remains() const { return p < 0.05; }
};

/// By the logarithms of the values less the mean of their arm, within each condition and load, for the metrics that compare
/// costs. Arms and metrics without two positive values are left out.
std::vector<OrderTrend> orderTrends(const Results &results);
/// Mean of the samples of an arm; NaN if there are none.
double meanOf(const Results &results, std::size_t condition, std::size_t load, const SweepArm &arm, Metric metric);
/// True if any sample of the sweep has a value.
bool wasMeasured(const Results &results, Metric metric);

} // namespace skyseal::experiment
