#include "core/experiment/run_measurement.h"

#include "core/engine/station/snapshot.h"
#include "core/experiment/load_check.h"
#include "core/link/steady_now.h"

#include <limits>

namespace skyseal::experiment {

namespace {

constexpr double kMayBeForeign = 0.01; ///< of all accepted frames

std::optional<AgentCostReport> reportIn(const MeasuredLink &link, const engine::Snapshot &snapshot)
{
    const engine::SessionSnapshot *up = link.session(snapshot);
    return up ? agentCostReport(*up) : std::nullopt;
}

} // namespace

Reading RunMeasurement::readingOf(const MeasuredLink &link, const Snapshot &snapshot)
{
    Reading out;
    out.station = snapshot;
    out.programs = m_programs();
    out.machine = metrics::machineUsage();
    out.microjoules = m_energy.microjoules(steadyNow());
    if (link.isPlain()) {
        out.mavlink = snapshot->clear;
    } else if (const engine::SessionSnapshot *up = link.session(*snapshot)) {
        out.mavlink = up->mavlink;
        out.rx = up->stats.rx;
        out.peerRx = up->stats.peerRx;
    }
    return out;
}

void RunMeasurement::awaitReport(const MeasuredLink &link, const engine::Snapshot &snapshot)
{
    const auto report = reportIn(link, snapshot);
    m_reportBefore = report ? std::optional(report->stamp) : std::nullopt;
    m_report.reset();
}

bool RunMeasurement::takeReport(const MeasuredLink &link, const engine::Snapshot &snapshot)
{
    const auto report = reportIn(link, snapshot);
    if (!report || report->stamp == m_reportBefore)
        return false;
    m_report = report;
    m_reporter = link.session(snapshot)->info.session;
    return true;
}

bool RunMeasurement::costsHaveStopped(const MeasuredLink &link, const engine::Snapshot &snapshot)
{
    return !reportIn(link, snapshot);
}

void RunMeasurement::begin(const MeasuredLink &link, const Snapshot &snapshot)
{
    const engine::SessionSnapshot *up = link.session(*snapshot);
    m_session = up ? std::optional(up->info.session) : std::nullopt;
    m_peer = up ? std::optional(up->info.peer) : std::nullopt;
    m_begin = readingOf(link, snapshot);
    if (m_session && m_reporter == m_session)
        m_begin.agent = m_report;
}

void RunMeasurement::tick()
{
    m_energy.microjoules(steadyNow());
}

bool RunMeasurement::sessionChanged(const MeasuredLink &link, const engine::Snapshot &snapshot) const
{
    const engine::SessionSnapshot *up = link.session(snapshot);
    return !link.isPlain() && up && up->info.session != m_session;
}

void RunMeasurement::readEnd(const MeasuredLink &link, const Snapshot &snapshot)
{
    m_end = readingOf(link, snapshot);
}

bool RunMeasurement::takeEndReport(const MeasuredLink &link, const engine::Snapshot &snapshot)
{
    const engine::SessionSnapshot *up = link.session(snapshot);
    if (up && up->info.session == m_session)
        m_end.agent = reportIn(link, snapshot);
    return m_end.agent.has_value();
}

void RunMeasurement::end(const MeasuredLink &link, const Plan &plan, Sample &sample)
{
    const Snapshot &snapshot = m_end.station;
    const engine::SessionSnapshot *up = link.session(*snapshot);
    const crypto::SuiteId suite = plan.arms[sample.run.arm].suite;
    if (!link.isPlain() && (!up || up->info.session != m_session || up->info.suite != suite)) {
        sample.problem = kSessionEnded;
        return;
    }
    const impair::ImpairmentSettings &line = plan.conditions[sample.run.condition].settings;
    const Load load = plan.loads[sample.run.load];
    Values values = valuesBetween(m_begin, m_end, !link.isPlain(), sequenceNumbersCountLoss(line, load));
    values[Metric::LineLoad] = lineLoad(m_begin, m_end, line);
    if (link.bareCipher()) // its time is in that of the ends, and not measured by itself; the agent has no part in it
        values[Metric::CpuSuite] = values[Metric::AgentCpuSuite] = std::numeric_limits<double>::quiet_NaN();
    if (snapshot->unreadable > m_begin.station->unreadable) {
        sample.problem = MeasuredLink::kUnreadable;
        return;
    }
    if (!link.hasVehicle(*snapshot) || values[Metric::Packets] == 0) {
        sample.problem = sentence("Reason", "the vehicle fell silent during the run");
        return;
    }
    sample.values = values;
    sample.invalid = loadProblem(load, values);
    if (const double foreign = foreignShare(m_begin, m_end); foreign > kMayBeForeign)
        sample.invalid = sentence("Reason", "%1 % of the frames came from another vehicle, which the costs contain")(
            readable(100 * foreign));
    sample.seconds = snapshot->time - m_begin.station->time;
    sample.begin = countedBy(m_begin);
    sample.end = countedBy(m_end);
    sample.messages = messagesBetween(m_begin, m_end);
}

} // namespace skyseal::experiment
