// What a sweep's samples say: a summary for each place of the design, which suites differ, and how much of a difference is
// the machine's noise.
#pragma once

#include "core/experiment/results.h"
#include "core/experiment/statistics.h"

#include <optional>
#include <vector>

namespace skyseal::experiment {

/// Two arms of one condition and load, by one metric. Corrected over all pairs of arms of that metric there; left out are the
/// repeated arm (A/A) and plain MAVLink where its value is zero by definition.
struct ArmComparison
{
    std::size_t condition = 0, load = 0;
    Metric metric{};
    std::size_t first = 0, second = 0; ///< indices of arms
    double firstMean = 0;
    Comparison comparison;
};

/// The same suite measured twice under two names. Corrected over all such tests of the sweep.
struct Noise
{
    std::size_t condition = 0, load = 0;
    Metric metric{};
    std::size_t arm = 0, again = 0; ///< indices of arms
    double mean = 0, meanAgain = 0;
    Comparison comparison;
    bool differs() const { return comparison.significant(); }
};

/// Of the samples of a cell; without an interval where the runs are not independent (MetricInfo::independent). Nothing that is
/// measured can be negative, so intervals end at zero, and those of shares at one. Where nothing was lost in any run, Student's t
/// knows of no spread: the interval ends at the bound by all frames or records of these runs together (boundOfNone).
Summary summaryOf(const Results &results, const Cell &cell, Metric metric);

std::vector<ArmComparison> compareArms(const Results &results, std::size_t condition, std::size_t load, Metric metric);
/// Of every place and metric; nothing without an arm that was repeated, and for metrics that it has no two samples of.
std::vector<Noise> noiseOf(const Results &results);
/// Mean of an arm's samples; NaN when it was not measured.
double meanOf(const Results &results, std::size_t condition, std::size_t load, const SweepArm &arm, Metric metric);
/// Whether any sample of the whole sweep has a value.
bool wasMeasured(const Results &results, Metric metric);

} // namespace skyseal::experiment
