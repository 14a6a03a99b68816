// Text output of a sweep for the terminal.
#pragma once

#include "core/experiment/results.h"

#include <string>
#include <vector>

namespace skyseal::experiment {

/// The reference of ratios: "plain MAVLink", or an arm's name.
std::string referenceText(const Plan &plan);

/// Shown in place of a value: "not measured", or "not in this framing" for an arm that does not exist.
const char *missingText(const SweepArm &arm);

/// "mean ± half of the 95 % interval", "–" if not measured, "not in this framing" if the arm does not exist. An asterisk marks
/// outliers among the samples.
std::string meanText(const Results &results, const Cell &cell, Metric metric);

/// "3 runs", "1 run", "1 to 3 runs": the range of the numbers of runs, one for each arm; zeros are left out.
std::string runsText(const std::vector<std::size_t> &counts);
/// The same for the successful runs of all cells of a sweep.
std::string runsText(const Results &results);

/// "ended after 2 of 12 runs"; empty for a complete sweep.
Reason endedEarly(const Results &results);
/// "2 of 72 runs failed: none (natural load): no vehicle was heard", each arm, load and reason once; empty if no run failed.
Reason failedRuns(const Results &results);

/// "3 of 72 runs are not valid and left out of every comparison; the first of them, rc4 (saturated load): not saturated: …";
/// empty if all are valid.
Reason invalidRuns(const Results &results);

/// For each condition and load the means and the ratios to the reference, then the notes below them.
std::vector<std::string> sweepText(const Results &results);

/// One line for a finished run.
std::string runText(const Plan &plan, const Sample &sample, std::size_t runs, double remaining);

} // namespace skyseal::experiment
