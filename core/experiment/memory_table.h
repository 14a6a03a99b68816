// Memory of the programs and of each suite, as a table of the report. A pure function of the results.
#pragma once

#include "core/experiment/results.h"

#include <string>

namespace skyseal::experiment {

/// HTML; empty if no memory was measured.
std::string memoryTable(const Results &results);

} // namespace skyseal::experiment
