// Cells of CSV files.
#pragma once

#include <string>

namespace skyseal::experiment {

/// Empty if not finite.
std::string csvNumber(double value);
/// Quoted, since conditions contain commas.
std::string csvText(const std::string &text);

} // namespace skyseal::experiment
