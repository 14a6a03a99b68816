// Possible disturbances of a run, and the measurement's own share in it, as sentences without a full stop. Values beyond
// thresholds warn, no more.
// Pure functions of the results.
#pragma once

#include "core/experiment/results.h"

#include <string>
#include <vector>

namespace skyseal::experiment {

/// "other programs used 35 % of a core", without a comma; empty for a run that nothing is known to have disturbed, and for one
/// that failed.
std::vector<std::string> disturbances(const Sample &sample);

/// For the first page of a report and for the window: how much of the thread that was measured was the measurement, at most,
/// under each load. Empty where it is not known.
Reason meterText(const Results &results);

/// For the first page of a report: "12 of 72 runs were disturbed, so that their figures are noisier and may be wrong: other
/// programs used up to 35 % of a core (9 runs); …". Empty if none was.
Reason disturbedRuns(const Results &results);

} // namespace skyseal::experiment
