// How exactly a sweep knows what suites cost, and how many launches a wanted precision takes.
#pragma once

#include "core/experiment/results.h"

#include <optional>

namespace skyseal::experiment {

/// A sweep that goes on until it is precise does so for this many launches at least: an interval that is narrow by chance must
/// not end it at once.
inline constexpr unsigned kLeastLaunchesUntil = 10;

/// Launches with at least one run.
unsigned launchesIn(const Results &results);

struct Precision
{
    /// Half of the widest 95 % interval among the ratios to the reference by CPU time per frame, of both ends: 0.03 is 3 %.
    double halfWidth = 0;
    /// Launches after which it is expected to be the goal.
    unsigned launchesNeeded = 0;
};

/// nullopt as long as a ratio has no interval, such as that of a load without enough valid runs. Needs two launches.
std::optional<Precision> precisionOf(const Results &results, double goal);

} // namespace skyseal::experiment
