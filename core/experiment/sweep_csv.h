// sweep.csv and ratios.csv: the samples and the comparisons of a sweep as tables, with their data dictionaries. README.md
// beside this file documents them.
#pragma once

#include "core/experiment/results.h"

#include <string>

namespace skyseal::experiment {

/// The samples: one line per run, one column per metric; empty where a value could not be measured.
std::string sweepCsv(const Results &results);
/// The data dictionary of sweepCsv(): name, unit and description of each column, in their order.
std::string sweepColumnsCsv();
/// The comparisons, which are the result of a sweep: one line each, the A/A ones last.
std::string ratiosCsv(const Results &results);
/// The data dictionary of ratiosCsv().
std::string ratioColumnsCsv();

} // namespace skyseal::experiment
