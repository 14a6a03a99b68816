// Warnings that a reader of a report needs before its figures: the sentences on its first page. Pure function.
#pragma once

#include "core/experiment/results.h"

#include <vector>

namespace skyseal::experiment {

/// An unsuitable build or machine, an incomplete sweep, runs that failed, are not valid or were disturbed, and values that
/// change with the order of the runs. Empty if there is nothing to warn of.
std::vector<Reason> reportWarnings(const Results &results);

} // namespace skyseal::experiment
