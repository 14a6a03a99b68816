// Whether the load of a run was what its name says. A run that was not is no measurement of that load. Pure function.
#pragma once

#include "core/base/reason.h"
#include "core/experiment/metric.h"
#include "core/experiment/plan.h"

namespace skyseal::experiment {

/// Per cent of a line's rate, or of a core, from which on it counts as used up.
inline constexpr double kUsedUp = 95;

/// Per cent of the sends of a paced load that its generator may miss.
inline constexpr double kMayMiss = 1;

/// The reason why these are no values of a run under this load; empty if they are. A saturated load fills the line, the core
/// of the station's I/O thread or that of the agent; with less, the generator sets the rate, and not what is measured. Of a
/// paced load its generator misses at most kMayMiss.
Reason loadProblem(Load load, const Values &values);

} // namespace skyseal::experiment
