// claims.csv: the paper's claims with the intervals and margins that they were judged by, one line for each ratio.
#pragma once

#include "core/experiment/claims.h"

#include <string>

namespace skyseal::experiment {

std::string claimsCsv(const Results &results, const std::vector<Claim> &claims);
/// The data dictionary of claimsCsv().
std::string claimColumnsCsv();

} // namespace skyseal::experiment
