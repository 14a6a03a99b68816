// A sweep's outcome for people at a terminal.
#pragma once

#include "core/experiment/results.h"

#include <string>
#include <vector>

namespace skyseal::experiment {

/// What stands in place of a figure: "not measured", or "not in this framing" for an arm that does not exist.
const char *missingText(const SweepArm &arm);

/// "mean ± half of the 95 % interval", "–" where nothing was measured, "not in this framing" where nothing can be; an
/// asterisk marks outliers among the samples.
std::string meanText(const Results &results, const Cell &cell, Metric metric);

/// "3 runs", "1 run", "1 to 3 runs": how many were measured of each arm that was measured at all; by `counts`, one an arm.
std::string runsText(const std::vector<std::size_t> &counts);
/// The same of the whole sweep, by the runs that succeeded in each place.
std::string runsText(const Results &results);

/// "ended after 2 of 12 runs"; empty for a whole sweep.
std::string endedEarly(const Results &results);
/// "2 of 72 runs failed: none (natural load): no vehicle was heard", each arm, load and reason once; empty where all is well.
std::string failedRuns(const Results &results);

/// Tables, one for each condition and load, and what is to be said below them.
std::vector<std::string> sweepText(const Results &results);

/// One line for a run that just ended.
std::string runText(const Plan &plan, const Sample &sample, std::size_t runs, double remaining);

} // namespace skyseal::experiment
