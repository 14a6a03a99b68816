// One run's values: what happened between two snapshots of the station, and between two looks at the agent's process.
#pragma once

#include "core/engine/snapshot.h"
#include "core/experiment/metric.h"
#include "core/experiment/results.h"

#include <memory>
#include <optional>

namespace skyseal::experiment {

struct Reading
{
    std::shared_ptr<const engine::Snapshot> station; ///< with a probe
    /// From the kernel, where the agent runs on this machine and its process is known.
    std::optional<Duration> agentCpu;
    std::optional<std::uint64_t> agentMemory;
    std::optional<std::uint64_t> microjoules; ///< of the whole processor, growing
};

/// Everything but Metric::Switch. `sealed`: whether records are what the link carries.
Values valuesBetween(const Reading &begin, const Reading &end, bool sealed);

/// The counters that the above takes the differences of.
Counted countedBy(const engine::Snapshot &snapshot);

} // namespace skyseal::experiment
