// sweep.json: the complete results of a sweep for programs, and the JSON lines of a running sweep. README.md beside this file
// documents the schema; a change that breaks readers raises kSweepSchemaVersion.
#pragma once

#include "core/experiment/results.h"
#include "core/experiment/verdicts.h"

#include <string>
#include <vector>

namespace skyseal::experiment {

inline constexpr unsigned kSweepSchemaVersion = 4;

std::string sweepJson(const Results &results, const std::vector<Verdict> &verdicts);

/// JSON objects with "event" for a run that begins, whose warm-up is still ahead, a finished run, the end of the runs and a
/// verdict, one line each. `problem`: a sentence if the plan was not carried out completely.
std::string beginEvent(const Plan &plan, const Run &run, std::size_t order);
std::string runEvent(const Plan &plan, const Sample &sample, std::size_t runs, double remaining);
std::string endEvent(const Results &results, bool opened, const std::string &problem, const IdlePower &idle);
std::string expectEvent(const Plan &plan, const Verdict &verdict);

} // namespace skyseal::experiment
