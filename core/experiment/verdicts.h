// Checks the results of a sweep against the assertions of a script: one verdict for each suite, condition and load that an
// assertion covers.
#pragma once

#include "core/experiment/expectation.h"
#include "core/experiment/results.h"

#include <optional>
#include <string>
#include <vector>

namespace skyseal::experiment {

struct Verdict
{
    std::string expectation; ///< its text
    std::size_t condition = 0;
    std::string suite;               ///< checked for this suite; empty if the assertion names its suites
    std::optional<std::size_t> load; ///< checked for this load; nullopt if the assertion names its loads
    Expectation::Outcome outcome;
};

/// Fails if the assertion names a suite, load or framing that the plan does not measure.
Result<void, InputError> fits(const Expectation &expectation, const Plan &plan);

/// An assertion for every suite skips suites that ran but have no such value (plain MAVLink has no records), unless none has
/// it. A suite without a successful run under a load that the assertion covers was not measured, and the verdict fails.
std::vector<Verdict> judge(const Expectation &expectation, const Results &results);

/// "loss<=0.001 [aes-256-gcm] [natural]: 0 against 0.001: holds"; the load only if the plan has several.
std::string verdictText(const Verdict &verdict, const Plan &plan);

} // namespace skyseal::experiment
