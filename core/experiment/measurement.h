// The values of one run: differences between two snapshots of the station and two readings of the agent's costs.
#pragma once

#include "core/engine/common/totals.h"
#include "core/experiment/metric.h"
#include "core/experiment/results.h"
#include "core/impair/impairment.h"
#include "core/metrics/machine_usage.h"
#include "core/metrics/process_usage.h"

#include <memory>
#include <optional>

namespace skyseal::engine {
struct Snapshot;
struct SessionSnapshot;
} // namespace skyseal::engine

namespace skyseal::experiment {

/// The agent's costs in its newest report over the sealed link.
struct AgentCostReport
{
    std::uint32_t stamp = 0; ///< microseconds of the agent's clock, modulo 2^32
    channel::EndCosts costs;
};
/// nullopt before the first report.
std::optional<AgentCostReport> agentCostReport(const engine::SessionSnapshot &session);

/// Resource usage of a sweep's programs at one time, from the kernel; empty for those that are not known processes here.
struct ProgramUsage
{
    TimePoint at{};
    std::optional<Duration> agentCpu, simulatorCpu, relayCpu, autopilotCpu;
    std::optional<std::uint64_t> agentMemory;
    std::optional<metrics::ContextSwitches> agentSwitches;
    std::optional<std::uint64_t> missedSends; ///< of a paced load, as its generator counts them ten times a second
    std::optional<Counted::Relay> relay;      ///< by its log
};

/// State of all counters at one edge of a run.
struct Reading
{
    std::shared_ptr<const engine::Snapshot> station; ///< with a probe
    engine::MavlinkTotals mavlink;                   ///< frames that the link carried as the run demands, and no others
    channel::ReceiveCounters rx, peerRx;             ///< records of its session to the station, and to the agent
    std::optional<AgentCostReport> agent;            ///< of the run's suite alone
    ProgramUsage programs;
    metrics::MachineUsage machine;            ///< read together with `programs`
    std::optional<std::uint64_t> microjoules; ///< of the machine, see metrics::EnergyMeter
};

/// Returns true if MAVLink's 8-bit sequence numbers distinguish loss from reordering and duplicates on such a link. They do not
/// where jitter lets a frame overtake more than metrics::SequenceTracker::kShortWindow others.
bool sequenceNumbersCountLoss(const impair::ImpairmentSettings &link, Load load);

/// All values but Metric::LineLoad, Metric::Switch, Metric::SessionMemory and those that depend on the idle power
/// (idle_power.h); NaN where one could not be measured. `sealed`: the link carries records. `countsLoss`: see
/// sequenceNumbersCountLoss().
Values valuesBetween(const Reading &begin, const Reading &end, bool sealed, bool countsLoss);

/// Metric::LineLoad between two readings; NaN if the line has no limited rate.
double lineLoad(const Reading &begin, const Reading &end, const impair::ImpairmentSettings &line);
/// Bytes per second that a line carries in one direction; nullopt without a limit.
std::optional<double> lineRate(const impair::ImpairmentSettings &line);

/// Accepted frames between two readings, by message id.
std::map<std::uint32_t, std::uint64_t> messagesBetween(const Reading &begin, const Reading &end);

/// Share of the accepted frames between two readings that the link carried otherwise: those of another vehicle, in clear or in
/// a session of its own. The costs of the station's thread contain them.
double foreignShare(const Reading &begin, const Reading &end);

/// The counters of valuesBetween() as they stand in a reading.
Counted countedBy(const Reading &reading);

} // namespace skyseal::experiment
