// A sweep held against what somebody expected of it: the assertions of a script, one line for each suite, condition and
// load that an assertion speaks of.
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
    std::string suite;               ///< that it was checked for; empty when it names its suites itself
    std::optional<std::size_t> load; ///< that it was checked for; nothing when it names its loads itself
    Expectation::Outcome outcome;
};

/// An error when the plan does not hold what it speaks of.
Result<void, InputError> fits(const Expectation &expectation, const Plan &plan);

/// An assertion for every suite leaves out those that ran and have no such value (plain MAVLink has no records), but one at least
/// must have it. A suite of which no run succeeded, under one of the loads that it speaks of, was not measured, and fails.
std::vector<Verdict> judge(const Expectation &expectation, const Results &results);

/// "loss<=0.001 [aes-256-gcm] [natural]: 0 against 0.001: holds"; the load where the plan has several
std::string sentence(const Verdict &verdict, const Plan &plan);

} // namespace skyseal::experiment
