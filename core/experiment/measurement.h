// One run's values: what happened between two snapshots of the station, and between two looks at the agent's process.
#pragma once

#include "core/engine/station/snapshot.h"
#include "core/experiment/metric.h"
#include "core/experiment/results.h"
#include "core/impair/impairment.h"

#include <memory>
#include <optional>

namespace skyseal::experiment {

/// The agent's costs, as its newest report brought them over the sealed link.
struct AgentReport
{
    std::uint32_t stamp = 0; ///< microseconds of the agent's clock, modulo 2^32
    channel::EndCosts costs;
};
std::optional<AgentReport> agentReport(const engine::SessionSnapshot &session);

struct Reading
{
    std::shared_ptr<const engine::Snapshot> station; ///< with a probe
    std::optional<AgentReport> agent;                ///< made during the run
    /// For runs without two reports: from the kernel, where the agent runs on this machine and its process is known.
    std::optional<Duration> agentCpu;
    std::optional<std::uint64_t> agentMemory;
    std::optional<std::uint64_t> microjoules; ///< of the whole processor, growing
};

/// Whether MAVLink's sequence numbers, of 8 bits, tell on such a link what was lost and what came late or twice. Frames that
/// may overtake too many others look like lost ones and second copies.
bool numbersTell(const impair::Settings &link, Load load);

/// Everything but Metric::Switch. `sealed`: whether records are what the link carries. `numbersTell`: see above.
Values valuesBetween(const Reading &begin, const Reading &end, bool sealed, bool numbersTell);

/// The counters that the above takes the differences of.
Counted countedBy(const engine::Snapshot &snapshot);

} // namespace skyseal::experiment
