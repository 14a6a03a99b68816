// A sweep's outcome for people at a terminal.
#pragma once

#include "core/experiment/results.h"

#include <string>
#include <vector>

namespace skyseal::experiment {

/// "mean ± half of the 95 % interval", "–" where nothing was measured; an asterisk marks outliers among the samples.
std::string meanText(const Results &results, const Cell &cell, Metric metric);

/// Tables, one for each condition and load, and what is to be said below them.
std::vector<std::string> sweepText(const Results &results);

/// One line for a run that just ended.
std::string runText(const Plan &plan, const Sample &sample, std::size_t runs, double remaining);

} // namespace skyseal::experiment
