#include "core/experiment/sweep_runner.h"

#include "core/engine/station/snapshot.h"
#include "core/experiment/statistics.h"
#include "core/link/steady_now.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace skyseal::experiment {

namespace {

using std::chrono::milliseconds;

constexpr Duration kConnectPatience = std::chrono::seconds(20);
constexpr Duration kSwitchPatience = std::chrono::seconds(15);
constexpr Duration kRestorePatience = std::chrono::seconds(6); ///< a switch is confirmed or rolled back within five
constexpr Duration kSettle = milliseconds(500);                ///< a new station requests much that it requests only once
constexpr Duration kSettleAgain = milliseconds(200);
constexpr Duration kMostSettle = std::chrono::seconds(2);    ///< for a vehicle that does not answer TIMESYNC
constexpr Duration kMostSettling = std::chrono::seconds(30); ///< of a saturated load; the run is measured all the same
constexpr int kFirstWarmUps = 4; ///< warm-ups before the first run of programs that have just started
constexpr Duration kProbePatience = std::chrono::seconds(10);
constexpr int kWatching = 20;  ///< snapshots a second while the link is brought into its state
constexpr int kForReports = 1; ///< while a run waits for the agent's first report

std::function<ProgramUsage()> programsOf(const Lab *lab)
{
    return [lab] {
        ProgramUsage out;
        out.at = steadyNow();
        return lab ? lab->usage() : out;
    };
}

} // namespace

SweepRunner::SweepRunner(SweepConfig config)
    : m_config(std::move(config)), m_queue(m_config.plan),
      m_station(m_config.station, m_config.link, m_config.borrowed,
                m_config.lab ? m_config.lab->placement().station : std::nullopt),
      m_measurement(programsOf(m_config.lab)), m_flight(m_config.flight)
{
    m_results.plan = m_config.plan;
    if (m_config.lab)
        m_results.placement = m_config.lab->placement().text();
    connect(&m_station, &SweepStation::snapshotReady, this, &SweepRunner::handleSnapshot);
    connect(&m_station, &SweepStation::probeTaken, this, &SweepRunner::handleProbe);
    connect(&m_station, &SweepStation::eventOccurred, this, &SweepRunner::handleEvent);
    connect(&m_station, &SweepStation::closed, this, [this] {
        if (m_reopens)
            openForLanding();
        else if (isEnding())
            end();
        else
            beginNextRun();
    });
    connect(&m_station, &SweepStation::lost, this, [this] {
        if (m_problem.empty())
            m_problem = "the station ended";
        end();
    });
    connect(&m_tick, &QTimer::timeout, this, &SweepRunner::handleTimeout);
    m_measured.setSingleShot(true);
    m_measured.setTimerType(Qt::PreciseTimer);
    connect(&m_measured, &QTimer::timeout, this, &SweepRunner::requestEnd);
    if (m_config.lab) {
        connect(m_config.lab, &Lab::ended, this, [this](const QString &problem) {
            m_opened = true;    // a program failed, not a link
            m_snapshot.reset(); // what it shows is over
            giveUp(problem.toStdString());
        });
    }
}

SweepRunner::~SweepRunner()
{
    if (m_station.isOpen() && m_station.isBorrowed())
        m_station.giveBack(suiteToResume());
}

void SweepRunner::start()
{
    m_clock.start();
    m_tick.start(milliseconds(100));
    beginNextRun();
}

void SweepRunner::cancel()
{
    if (!m_stage.is(SweepStage::Restoring))
        giveUp("cancelled");
}

void SweepRunner::enter(SweepStage stage, Duration patience)
{
    m_stage.enter(stage, patience, now(), m_snapshot ? m_snapshot->time : 0);
    if (m_station.isOpen())
        m_station.setSnapshotsPerSecond(snapshotsPerSecond());
}

/// That the stage needs. A run that is measured needs none but to see the agent's first report.
int SweepRunner::snapshotsPerSecond() const
{
    switch (m_stage.stage()) {
    case SweepStage::Beginning:
    case SweepStage::Ending: return 0;
    case SweepStage::Measuring: return m_link.isPlain() || m_measurement.hasReport() ? 0 : kForReports;
    default: return kWatching;
    }
}

void SweepRunner::beginNextRun()
{
    if (m_flight.isUp() && (m_queue.atEnd() || m_queue.atBlockStart() || m_flight.endsBefore(m_queue.current().repeat)))
        return beginLanding();
    if (isEnding())
        return restoreLink();
    const Run &run = m_queue.current();
    if (m_queue.atBlockStart()) {
        if (m_station.isOpen())
            return closeStation();
        if (m_config.lab)
            m_config.lab->start(m_config.plan.loads[run.load], m_config.plan.conditions[run.condition], m_config.plan.seed);
    }
    m_runStart = now();
    m_switch.begin(arm().suite);
    m_fresh = !m_station.isOpen();
    m_attempts.beginRun(m_queue.atBlockStart());
    m_isCurrent = false;
    Q_EMIT runBegan(run);
    if (m_fresh)
        openStation();
    else
        prepareLink();
}

void SweepRunner::openStation()
{
    m_snapshot.reset();
    m_link.stationOpened();
    if (!m_station.isBorrowed())
        m_link.setProtection(protectionOf(arm()), nullptr);
    if (const auto opened = m_station.open(protectionOf(arm())); !opened)
        return giveUp(opened.error().text());
    enter(SweepStage::Connecting, kConnectPatience);
}

void SweepRunner::handleEvent(const engine::Event &event)
{
    if (const auto *changed = std::get_if<engine::LinkChanged>(&event)) {
        const engine::LinkSnapshot &link = changed->link;
        m_opened = m_opened || link.phase == engine::LinkPhase::Listening || link.phase == engine::LinkPhase::Connected;
        if (!m_opened && (link.phase == engine::LinkPhase::Failed || link.hostUnknown))
            giveUp(link.url + ": " + link.problem);
    } else if (const auto *up = std::get_if<channel::SessionUp>(&event)) {
        m_link.sessionUp(*up);
        const bool isMeasured = m_stage.is(SweepStage::Measuring) || m_stage.is(SweepStage::Ending);
        if (isMeasured && !m_link.isPlain() && m_measurement.isReplacedBy(*up))
            endRun(RunMeasurement::kSessionEnded);
    } else if (const auto *done = std::get_if<channel::SwitchDone>(&event)) {
        handleSwitch(*done);
    } else if (const auto *result = std::get_if<vehicle::CommandResult>(&event)) {
        m_flight.handleResult(*result);
    } else if (const auto *written = std::get_if<vehicle::ParameterResult>(&event)) {
        m_flight.handleResult(*written);
    }
}

void SweepRunner::handleSnapshot(const RunMeasurement::Snapshot &snapshot)
{
    m_snapshot = snapshot;
    m_link.update(*snapshot);
    m_opened = m_opened || session();
    const double inStage = m_stage.age(snapshot->time);
    switch (m_stage.stage()) {
    case SweepStage::Connecting:
        // The position matters only for a simulator that has just started.
        if (m_config.lab && !m_config.lab->vehicle() ? m_link.hasSettledVehicle(*snapshot) : m_link.hasVehicle(*snapshot))
            enter(SweepStage::Settling, kConnectPatience);
        break;
    case SweepStage::Settling:
        if (isSettled(inStage))
            prepareLink();
        break;
    case SweepStage::Switching: continueSwitch(); break;
    case SweepStage::WarmingUp:
        if (!m_link.isUnder(arm().suite, *snapshot))
            beginSwitch(); // the link was lost before the measurement began
        else if (isWarm(inStage))
            requestBegin();
        break;
    case SweepStage::Measuring: watchRun(*snapshot); break;
    case SweepStage::Flying:
    case SweepStage::Landing: fly(); break;
    case SweepStage::Restoring: continueRestoring(); break;
    case SweepStage::Idle:
    case SweepStage::Closing:
    case SweepStage::Beginning:
    case SweepStage::Ending: break;
    }
}

void SweepRunner::handleProbe(const RunMeasurement::Snapshot &snapshot)
{
    if (m_stage.age(snapshot->time) < 0)
        return; // of a run that was given up meanwhile
    if (!m_stage.is(SweepStage::Beginning) && !m_stage.is(SweepStage::Ending) && !m_stage.is(SweepStage::Restoring))
        return;
    m_snapshot = snapshot;
    m_link.update(*snapshot);
    if (m_stage.is(SweepStage::Beginning))
        return beginMeasuring();
    if (m_stage.is(SweepStage::Ending))
        return endRun();
    m_isCurrent = true;
    continueRestoring();
}

/// An answer to TIMESYNC shows that the vehicle is reached as well; in plain MAVLink that takes its next heartbeat.
bool SweepRunner::isSettled(double inStage) const
{
    const Duration least = m_fresh ? kSettle : kSettleAgain;
    return inStage >= seconds(kMostSettle) || (inStage >= seconds(least) && m_link.isAnswering(*m_snapshot));
}

/// A load that follows the answers of the other end takes its time to find its rate, most of all after a pause.
bool SweepRunner::isWarm(double inStage)
{
    const bool started = m_fresh && !m_station.isBorrowed();
    const double least = (started ? kFirstWarmUps : 1) * seconds(m_config.plan.warmUp);
    if (m_config.plan.loads[m_queue.current().load] != Load::Saturated)
        return inStage >= least;
    std::uint64_t bytes = 0;
    double trip = std::numeric_limits<double>::quiet_NaN();
    for (const engine::LinkSnapshot &link : m_snapshot->links)
        bytes += link.rxBytes;
    for (const engine::VehicleSnapshot &vehicle : m_snapshot->vehicles) {
        if (!vehicle.state.lost)
            trip = vehicle.state.latency;
    }
    m_settling.note(m_snapshot->time, bytes, trip);
    const bool settled = m_settling.settled() || inStage >= seconds(kMostSettling);
    return settled && inStage >= least;
}

/// On a link that works: changes how it carries MAVLink if the run needs another mode, and its suite otherwise.
void SweepRunner::prepareLink()
{
    if (m_reopened)
        return bringDown();
    if (m_flight.needsLeg(m_queue.current().repeat))
        return beginLeg();
    m_link.learnConsent(*m_snapshot);
    const engine::Protection wanted = protectionOf(arm());
    if (const std::string refusal = m_link.refusal(wanted); !refusal.empty())
        return refuseRun(refusal);
    if (m_link.isCarriedAs(wanted))
        return beginSwitch();
    setProtection(wanted);
    enter(SweepStage::Connecting, kConnectPatience);
}

void SweepRunner::setProtection(std::optional<engine::Protection> protection)
{
    m_link.setProtection(protection, m_snapshot.get());
    m_station.setProtection(protection);
}

void SweepRunner::beginSwitch()
{
    if (!m_link.isPlain())
        m_station.holdSuite(arm().suite);
    enter(SweepStage::Switching, kSwitchPatience);
    continueSwitch();
}

void SweepRunner::continueSwitch()
{
    if (m_link.isUnder(arm().suite, *m_snapshot))
        beginWarmUp();
    else
        orderSwitch();
}

void SweepRunner::beginWarmUp()
{
    const Run &run = m_queue.current();
    m_settling = LoadSettling(lineRate(m_config.plan.conditions[run.condition].settings));
    enter(SweepStage::WarmingUp, kFirstWarmUps * m_config.plan.warmUp + kMostSettling + kConnectPatience);
}

void SweepRunner::orderSwitch()
{
    const engine::SessionSnapshot *up = session();
    if (up && !up->info.pending && m_switch.order(up->info.session, now()))
        m_station.switchSuite(up->info.session, m_switch.wanted());
}

void SweepRunner::handleSwitch(const channel::SwitchDone &done)
{
    if (m_stage.is(SweepStage::Measuring) && !done.rekey && done.failure == channel::SwitchFailure::None)
        return endRun("another suite came into use during the run");
    if (!m_stage.is(SweepStage::Switching))
        return;
    using Outcome = SuiteSwitch::Outcome;
    const Outcome outcome = m_switch.finish(done, session() != nullptr, now());
    if (outcome == Outcome::Retry)
        enter(SweepStage::Switching, kSwitchPatience); // the link works, only slowly
    else if (outcome == Outcome::Failed)
        endRun(m_switch.problem());
}

void SweepRunner::requestBegin()
{
    enter(SweepStage::Beginning, kProbePatience);
    m_station.requestProbe();
}

void SweepRunner::beginMeasuring()
{
    if (!m_link.isUnder(arm().suite, *m_snapshot))
        return beginSwitch(); // the link was lost at the last moment
    m_measurement.begin(m_link, m_snapshot);
    nameSource();
    enter(SweepStage::Measuring, m_config.plan.measure + kConnectPatience);
    m_measured.start(std::chrono::duration_cast<milliseconds>(m_config.plan.measure));
}

void SweepRunner::watchRun(const engine::Snapshot &snapshot)
{
    m_measurement.noteReport(m_link, snapshot);
    if (m_measurement.sessionChanged(m_link, snapshot))
        requestEnd();
    else
        m_station.setSnapshotsPerSecond(snapshotsPerSecond());
}

void SweepRunner::requestEnd()
{
    if (!m_stage.is(SweepStage::Measuring))
        return;
    enter(SweepStage::Ending, kProbePatience);
    m_station.requestProbe();
}

void SweepRunner::endRun(std::string problem)
{
    Sample sample = sampleOfRun();
    sample.problem = std::move(problem);
    if (sample.problem.empty())
        m_measurement.end(m_link, m_snapshot, m_config.plan, sample);
    if (const std::string over = m_snapshot ? m_flight.endOfPhase(*m_snapshot) : std::string(); !over.empty())
        return failFlight(over);
    if (!sample.invalid.empty() && m_attempts.mayRepeat()) {
        m_attempts.repeat();
        return beginWarmUp();
    }
    if (sample.problem.empty()) {
        sample.values[Metric::Switch] = m_switch.milliseconds();
        addSessionMemory(sample);
        m_attempts.runMeasured(sample.invalid.empty());
        if (m_link.isPlain())
            m_link.plainSucceeded();
    } else {
        m_attempts.runFailed();
    }
    record(sample);
    if (m_attempts.isLinkLost())
        return giveUp("given up after " + std::to_string(RunAttempts::kMostFailedRuns)
                      + " runs in a row that failed; the last one: " + sample.problem);
    beginNextRun();
}

/// Measured once for each suite, so one sample of each cell has it, however often the suite is run.
void SweepRunner::addSessionMemory(Sample &sample)
{
    const Cell cell{sample.run.condition, sample.run.load, sample.run.arm};
    if (!m_config.heap || arm().again || !m_link.isCarriedAs(engine::Protection::Sealed)
        || summarise(valuesOf(m_results, cell, Metric::SessionMemory)).count > 0)
        return;
    if (const auto bytes = m_config.heap->session(arm().suite))
        sample.values[Metric::SessionMemory] = *bytes;
}

/// A run that the far end does not consent to is no sign of a lost link.
void SweepRunner::refuseRun(const std::string &problem)
{
    Sample sample = sampleOfRun();
    sample.problem = problem;
    record(sample);
    QTimer::singleShot(0, this, [this] { // hundreds of refused runs must not nest
        if (m_stage.is(SweepStage::Idle))
            beginNextRun();
    });
}

Sample SweepRunner::sampleOfRun() const
{
    Sample out;
    out.run = m_queue.current();
    out.order = static_cast<unsigned>(m_queue.position());
    out.start = m_runStart;
    out.attempts = m_attempts.count();
    return out;
}

void SweepRunner::record(const Sample &sample)
{
    m_stage.enterUnlimited(SweepStage::Idle);
    m_queue.finishRun(now());
    m_results.samples.push_back(sample);
    Q_EMIT sampleTaken(sample);
}

void SweepRunner::handleTimeout()
{
    if (!m_stage.isOverdue(now()))
        return;
    if (m_reopened)
        return m_stage.is(SweepStage::Restoring) ? closeStation() : abandonFlight();
    switch (m_stage.stage()) {
    case SweepStage::Connecting:
    case SweepStage::Settling:
        // Without a link each further run would only wait as long.
        if (!m_link.isPlain())
            return giveUp("no sealed session with a vehicle came up");
        m_link.plainSilent();
        endRun("no vehicle was heard in plain MAVLink; do both ends allow it?");
        break;
    case SweepStage::Restoring: closeStation(); break;
    default: endRun("the link fell silent");
    }
}

void SweepRunner::giveUp(const std::string &problem)
{
    if (!m_problem.empty())
        return;
    m_problem = problem;
    if (m_flight.isUp())
        bringDown();
    else if (!m_stage.is(SweepStage::Closing))
        restoreLink();
}

/// Puts the link back on the suite that it had first. A station of the sweep's own is closed at once where that cannot be done.
void SweepRunner::restoreLink()
{
    m_isCurrent = false;
    if (!m_station.isOpen())
        return end();
    if (!m_link.firstSuite() || (!m_station.isBorrowed() && (m_link.isPlain() || !session())))
        return closeStation();
    m_switch.begin(*m_link.firstSuite());
    if (m_station.isBorrowed())
        setProtection(std::nullopt);
    m_station.holdSuite(*m_link.firstSuite());
    enter(SweepStage::Restoring, kRestorePatience);
    m_station.requestProbe(); // behind every order so far
}

void SweepRunner::continueRestoring()
{
    if ((m_isCurrent && m_link.isRestored(*m_snapshot)) || (!session() && !m_station.isBorrowed()))
        return closeStation();
    orderSwitch();
}

void SweepRunner::closeStation()
{
    m_stage.enterUnlimited(SweepStage::Closing);
    m_station.close(suiteToResume());
}

/// A link that is not known to be back on its first suite goes over to it, at the latest with the next session.
std::optional<crypto::SuiteId> SweepRunner::suiteToResume() const
{
    return m_isCurrent && m_link.isRestored(*m_snapshot) ? std::nullopt : m_link.firstSuite();
}

void SweepRunner::end()
{
    if (!m_tick.isActive())
        return; // it has ended already
    m_tick.stop();
    if (m_config.lab)
        m_config.lab->stop();
    m_stage.enterUnlimited(SweepStage::Idle);
    m_results.complete = m_problem.empty() && m_queue.atEnd();
    m_results.seconds = now();
    Q_EMIT finished(m_opened, m_problem);
}

} // namespace skyseal::experiment
