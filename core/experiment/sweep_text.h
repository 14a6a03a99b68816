// A sweep's outcome for people at a terminal.
#pragma once

#include "core/experiment/results.h"

#include <string>
#include <vector>

namespace skyseal::experiment {

/// What stands in place of a figure: "not measured", or "not in this framing" for an arm that does not exist.
const char *missingText(const Arm &arm);

/// "mean ± half of the 95 % interval", "–" where nothing was measured, "not in this framing" where nothing can be; an
/// asterisk marks outliers among the samples.
std::string meanText(const Results &results, const Cell &cell, Metric metric);

/// Tables, one for each condition and load, and what is to be said below them.
std::vector<std::string> sweepText(const Results &results);

/// One line for a run that just ended.
std::string runText(const Plan &plan, const Sample &sample, std::size_t runs, double remaining);

} // namespace skyseal::experiment
