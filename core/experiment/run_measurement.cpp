#include "core/experiment/run_measurement.h"

#include "core/engine/station/snapshot.h"
#include "core/experiment/load_check.h"
#include "core/link/steady_now.h"

#include <limits>

namespace skyseal::experiment {

namespace {

std::optional<AgentCostReport> reportIn(const MeasuredLink &link, const engine::Snapshot &snapshot)
{
    const engine::SessionSnapshot *up = link.session(snapshot);
    return up ? agentCostReport(*up) : std::nullopt;
}

} // namespace

Reading RunMeasurement::readingOf(const MeasuredLink &link, const Snapshot &snapshot)
{
    return {snapshot, reportIn(link, *snapshot), m_programs(), metrics::machineUsage(), m_energy.microjoules(steadyNow())};
}

void RunMeasurement::awaitReport(const MeasuredLink &link, const engine::Snapshot &snapshot)
{
    const auto report = reportIn(link, snapshot);
    m_reportBefore = report ? std::optional(report->stamp) : std::nullopt;
}

bool RunMeasurement::isReported(const MeasuredLink &link, const engine::Snapshot &snapshot) const
{
    if (link.isPlain())
        return true;
    const auto report = reportIn(link, snapshot);
    return report && report->stamp != m_reportBefore;
}

void RunMeasurement::begin(const MeasuredLink &link, const Snapshot &snapshot)
{
    const engine::SessionSnapshot *up = link.session(*snapshot);
    m_session = up ? std::optional(up->info.session) : std::nullopt;
    m_peer = up ? std::optional(up->info.peer) : std::nullopt;
    m_begin = readingOf(link, snapshot);
    if (!isReported(link, *snapshot))
        m_begin.agent.reset();
}

void RunMeasurement::tick()
{
    m_energy.microjoules(steadyNow());
}

void RunMeasurement::noteReport(const MeasuredLink &link, const engine::Snapshot &snapshot)
{
    if (!m_begin.agent && isReported(link, snapshot))
        m_begin.agent = reportIn(link, snapshot);
}

bool RunMeasurement::sessionChanged(const MeasuredLink &link, const engine::Snapshot &snapshot) const
{
    const engine::SessionSnapshot *up = link.session(snapshot);
    return !link.isPlain() && up && up->info.session != m_session;
}

void RunMeasurement::end(const MeasuredLink &link, const Snapshot &snapshot, const Plan &plan, Sample &sample)
{
    const engine::SessionSnapshot *up = link.session(*snapshot);
    const crypto::SuiteId suite = plan.arms[sample.run.arm].suite;
    if (!link.isPlain() && (!up || up->info.session != m_session || up->info.suite != suite)) {
        sample.problem = kSessionEnded;
        return;
    }
    const impair::ImpairmentSettings &line = plan.conditions[sample.run.condition].settings;
    const Load load = plan.loads[sample.run.load];
    const Reading end = readingOf(link, snapshot);
    Values values = valuesBetween(m_begin, end, !link.isPlain(), sequenceNumbersCountLoss(line, load));
    values[Metric::LineLoad] = lineLoad(m_begin, end, line);
    if (link.bareCipher()) // its time is in that of the ends, and not measured by itself; the agent has no part in it
        values[Metric::CpuSuite] = values[Metric::AgentCpuSuite] = std::numeric_limits<double>::quiet_NaN();
    if (snapshot->unreadable > m_begin.station->unreadable) {
        sample.problem = MeasuredLink::kUnreadable;
        return;
    }
    if (!link.hasVehicle(*snapshot) || values[Metric::Packets] == 0) {
        sample.problem = "the vehicle fell silent during the run";
        return;
    }
    sample.values = values;
    sample.invalid = loadProblem(load, values);
    sample.seconds = snapshot->time - m_begin.station->time;
    sample.begin = countedBy(m_begin);
    sample.end = countedBy(end);
}

} // namespace skyseal::experiment
