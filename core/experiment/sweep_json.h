// sweep.json: everything that a sweep brought, for programs. README.md beside this file documents the schema; a change that
// breaks readers raises kSweepSchemaVersion.
#pragma once

#include "core/experiment/results.h"
#include "core/experiment/verdicts.h"

#include <string>
#include <vector>

namespace skyseal::experiment {

inline constexpr unsigned kSweepSchemaVersion = 2;

std::string sweepJson(const Results &results, const std::vector<Verdict> &verdicts);
/// The raw samples: one line a run, one column a metric; a value that could not be measured is empty.
std::string sweepCsv(const Results &results);

/// Lines for scripts while a sweep runs, each a JSON object with "event".
std::string runEvent(const Plan &plan, const Sample &sample, std::size_t runs, double remaining);
std::string expectEvent(const Plan &plan, const Verdict &verdict);

} // namespace skyseal::experiment
