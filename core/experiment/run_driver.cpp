#include "core/experiment/run_driver.h"

#include "core/engine/station/snapshot.h"

#include <limits>
#include <utility>

namespace skyseal::experiment {

namespace {

using std::chrono::milliseconds;

constexpr Duration kSwitchPatience = std::chrono::seconds(15);
constexpr Duration kSilencePatience = std::chrono::seconds(20); ///< beyond the time that the warm-up and the measurement take
constexpr Duration kMostSettling = std::chrono::seconds(30);    ///< of a saturated load; the run is measured all the same
constexpr int kFirstWarmUps = 4; ///< warm-ups before the first run of programs that have just started
constexpr Duration kProbePatience = std::chrono::seconds(10);
constexpr Duration kReportEvery = std::chrono::seconds(1);
constexpr Duration kReportPatience = std::chrono::seconds(4); ///< beyond the warm-up or the run, for reports of the agent

} // namespace

RunDriver::RunDriver(LinkDriver &link, const Plan &plan, std::function<ProgramUsage()> programs)
    : m_link(link), m_plan(plan), m_measurement(std::move(programs))
{
    m_clock.start();
    m_measured.setSingleShot(true);
    m_measured.setTimerType(Qt::PreciseTimer);
    connect(&m_measured, &QTimer::timeout, this, &RunDriver::requestEnd);
}

void RunDriver::begin(const Sample &sample, bool isFirst)
{
    m_sample = sample;
    m_isFirst = isFirst;
    m_link.beginSwitch(m_plan.arms[sample.run.arm].suite);
    beginSwitch();
}

void RunDriver::enter(Stage stage, Duration patience)
{
    m_stage.enter(stage, patience, now(), m_link.snapshotTime());
    m_link.setSnapshotsPerSecond(snapshotsPerSecond());
}

/// The rate that the stage needs. A run that is measured has its two probes only, whatever its arm.
int RunDriver::snapshotsPerSecond() const
{
    switch (m_stage.stage()) {
    case Stage::Beginning:
    case Stage::Measuring:
    case Stage::Ending: return 0;
    default: return LinkDriver::kWatching;
    }
}

void RunDriver::handleSnapshot()
{
    switch (m_stage.stage()) {
    case Stage::Switching: continueSwitch(); break;
    case Stage::WarmingUp:
        if (!m_link.isUnderSuite())
            beginSwitch(); // the link was lost before the measurement began
        else if (isWarm(m_stage.age(m_link.snapshotTime())))
            requestBegin();
        break;
    case Stage::Measuring: watchMeasuring(); break;
    case Stage::Reporting:
        if (m_measurement.takeEndReport(m_link.measured(), *m_link.snapshot()))
            end();
        break;
    case Stage::Idle:
    case Stage::Beginning:
    case Stage::Ending: break;
    }
}

void RunDriver::handleProbe(const LinkDriver::Snapshot &snapshot)
{
    if (m_stage.age(snapshot->time) < 0 || (!m_stage.is(Stage::Beginning) && !m_stage.is(Stage::Ending)))
        return; // of a run that was given up meanwhile
    m_link.take(snapshot);
    if (m_stage.is(Stage::Beginning))
        beginMeasuring();
    else
        requestReport();
}

void RunDriver::handleSessionUp(const channel::SessionUp &up)
{
    const bool isMeasured = m_stage.is(Stage::Measuring) || m_stage.is(Stage::Ending);
    if (isMeasured && !m_link.measured().isPlain() && m_measurement.isReplacedBy(up))
        end(RunMeasurement::kSessionEnded);
}

void RunDriver::handleSwitch(const channel::SwitchDone &done)
{
    if (m_stage.is(Stage::Measuring) && !done.rekey && done.failure == channel::SwitchFailure::None)
        return end(sentence("Reason", "another suite came into use during the run"));
    if (!m_stage.is(Stage::Switching))
        return;
    using Outcome = SuiteSwitch::Outcome;
    const Outcome outcome = m_link.finishSwitch(done, now());
    if (outcome == Outcome::Retry)
        enter(Stage::Switching, kSwitchPatience); // the link works, only slowly
    else if (outcome == Outcome::Failed)
        end(m_link.suiteSwitch().problem());
}

void RunDriver::handleTimeout()
{
    if (m_stage.is(Stage::Measuring))
        m_measurement.tick();
    if (!m_stage.isOverdue(now()))
        return;
    if (m_stage.is(Stage::Reporting))
        end(); // without the agent's costs
    else
        end(sentence("Reason", "the link fell silent"));
}

void RunDriver::beginSwitch()
{
    if (!m_link.measured().isPlain())
        m_link.holdSuite();
    enter(Stage::Switching, kSwitchPatience);
    continueSwitch();
}

void RunDriver::continueSwitch()
{
    if (m_link.isUnderSuite())
        beginWarmUp();
    else
        m_link.orderSwitch(now());
}

void RunDriver::beginWarmUp()
{
    m_settling = LoadSettling(lineRate(m_plan.conditions[m_sample.run.condition].settings));
    m_measurement.awaitReport(m_link.measured(), *m_link.snapshot());
    m_link.station().requestCosts(!m_link.measured().isPlain());
    enter(Stage::WarmingUp, kFirstWarmUps * m_plan.warmUp + kReportPatience + kMostSettling + kSilencePatience);
}

/// A load that follows the answers of the other end takes its time to find its rate, most of all after a pause. A warm-up
/// that is too short for the agent's report ends after it.
bool RunDriver::isWarm(double inStage)
{
    const double least = (m_isFirst ? kFirstWarmUps : 1) * seconds(m_plan.warmUp);
    if (m_plan.loads[m_sample.run.load] != Load::Saturated)
        return isReported(inStage, least) && inStage >= least;
    const engine::Snapshot &snapshot = *m_link.snapshot();
    std::uint64_t bytes = 0;
    double trip = std::numeric_limits<double>::quiet_NaN();
    for (const engine::LinkSnapshot &link : snapshot.links)
        bytes += link.rxBytes;
    for (const engine::VehicleSnapshot &vehicle : snapshot.vehicles) {
        if (!vehicle.state.lost)
            trip = vehicle.state.latency;
    }
    m_settling.note(snapshot.time, bytes, trip);
    const bool settled = m_settling.settled() || inStage >= seconds(kMostSettling);
    return settled && isReported(inStage, least) && inStage >= least;
}

/// The agent's costs count from a report of the last second before the run, and none of those during the run has them: they
/// would be part of the traffic and of the agent's time, in sealed runs only.
bool RunDriver::isReported(double inStage, double least)
{
    if (m_link.measured().isPlain())
        return true;
    if (inStage >= least + seconds(kReportPatience)) {
        m_link.station().requestCosts(false);
        return true;
    }
    const engine::Snapshot &snapshot = *m_link.snapshot();
    if (m_measurement.hasReport())
        return RunMeasurement::costsHaveStopped(m_link.measured(), snapshot);
    if (inStage >= least - seconds(kReportEvery) && m_measurement.takeReport(m_link.measured(), snapshot))
        m_link.station().requestCosts(false);
    return false;
}

void RunDriver::requestBegin()
{
    enter(Stage::Beginning, kProbePatience);
    m_link.station().requestProbe();
}

void RunDriver::beginMeasuring()
{
    if (!m_link.isUnderSuite())
        return beginSwitch(); // the link was lost at the last moment
    m_measurement.begin(m_link.measured(), m_link.snapshot());
    Q_EMIT measuring();
    enter(Stage::Measuring, m_plan.measure + kSilencePatience);
    m_measured.start(std::chrono::duration_cast<milliseconds>(m_plan.measure));
}

/// Only a borrowed station publishes snapshots during a run.
void RunDriver::watchMeasuring()
{
    const engine::Snapshot &snapshot = *m_link.snapshot();
    if (m_measurement.sessionChanged(m_link.measured(), snapshot))
        requestEnd();
}

void RunDriver::requestEnd()
{
    if (!m_stage.is(Stage::Measuring))
        return;
    enter(Stage::Ending, kProbePatience);
    m_link.station().requestProbe();
}

/// The run is over, and what the agent has to say about it is no part of it any more.
void RunDriver::requestReport()
{
    m_measurement.readEnd(m_link.measured(), m_link.snapshot());
    if (!m_measurement.hasBeginReport())
        return end();
    m_link.station().requestCosts(true);
    enter(Stage::Reporting, kReportPatience);
}

void RunDriver::end(Reason problem)
{
    m_stage.enterUnlimited(Stage::Idle);
    if (m_link.station().isOpen())
        m_link.station().requestCosts(false);
    Sample sample = m_sample;
    sample.problem = std::move(problem);
    if (sample.problem.empty())
        m_measurement.end(m_link.measured(), m_plan, sample);
    if (sample.problem.empty())
        sample.values[Metric::Switch] = m_link.suiteSwitch().milliseconds();
    Q_EMIT ended(sample);
}

} // namespace skyseal::experiment

#include "moc_run_driver.cpp"
