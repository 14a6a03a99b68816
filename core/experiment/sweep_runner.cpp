#include "core/experiment/sweep_runner.h"

#include "core/engine/station/snapshot.h"
#include "core/engine/station/vehicle_snapshot.h"
#include "core/experiment/statistics.h"
#include "core/link/steady_now.h"

#include <utility>

namespace skyseal::experiment {

namespace {

using std::chrono::milliseconds;

constexpr Duration kConnectPatience = std::chrono::seconds(20);
constexpr Duration kClearPatience = std::chrono::seconds(5);   ///< a heartbeat in clear follows the order, and one a second
constexpr Duration kRestorePatience = std::chrono::seconds(6); ///< a switch is confirmed or rolled back within five

std::function<ProgramUsage()> programsOf(Lab *lab)
{
    return [lab] {
        ProgramUsage out;
        out.at = steadyNow();
        return lab ? lab->usage() : out;
    };
}

/// Description of the vehicle, for Results::source.
std::string sourceText(const SweepConfig &config, const engine::Snapshot &snapshot)
{
    std::string out = "the vehicle of the connected station";
    if (config.lab)
        out = config.lab->sourceText();
    else if (config.link)
        out = "the vehicle on " + config.link->toText();
    if (config.lab && !config.lab->vehicle())
        return out; // it only claims to be of a firmware
    for (const engine::VehicleSnapshot &one : snapshot.vehicles) {
        if (!one.state.lost && !one.state.firmware.empty())
            out += "; system " + std::to_string(one.state.systemId) + " is " + one.state.firmware;
    }
    return out;
}

} // namespace

SweepRunner::SweepRunner(SweepConfig config)
    : m_config(std::move(config)), m_queue(m_config.plan),
      m_link(m_config.station, m_config.link, m_config.borrowed,
             m_config.lab ? m_config.lab->placement().station : std::nullopt, m_config.bareKey),
      m_run(m_link, m_config.plan, programsOf(m_config.lab)),
      m_flight(m_link, m_config.lab, m_config.flight, m_config.plan.seed)
{
    m_results.plan = m_config.plan;
    if (m_config.lab)
        m_results.placement = m_config.lab->placement().text();
    listen();
}

void SweepRunner::listen()
{
    const SweepStation *station = &m_link.station();
    connect(station, &SweepStation::snapshotReady, this, &SweepRunner::handleSnapshot);
    connect(station, &SweepStation::probeTaken, this, &SweepRunner::handleProbe);
    connect(station, &SweepStation::eventOccurred, this, &SweepRunner::handleEvent);
    connect(station, &SweepStation::closed, this, &SweepRunner::handleClosed);
    connect(station, &SweepStation::lost, this, [this] {
        if (m_problem.empty())
            m_problem = sentence("Reason", "the station ended");
        end();
    });
    connect(&m_run, &RunDriver::measuring, this, [this] { m_results.source = sourceText(m_config, *m_link.snapshot()); });
    connect(&m_run, &RunDriver::ended, this, qOverload<Sample>(&SweepRunner::endRun));
    connect(&m_flight, &FlightDriver::legEnded, this, [this](const std::string &problem) {
        if (problem.empty())
            prepareLink();
        else
            failFlight(problem);
    });
    connect(&m_flight, &FlightDriver::landingFailed, this, &SweepRunner::addProblem);
    connect(&m_flight, &FlightDriver::down, this, [this] {
        if (isEnding())
            restoreLink();
        else
            beginNextRun();
    });
    connect(&m_tick, &QTimer::timeout, this, &SweepRunner::handleTimeout);
    if (m_config.lab) {
        connect(m_config.lab, &Lab::ended, this, [this](const Reason &problem) {
            m_opened = true; // a program failed, not a link
            m_link.forgetSnapshot();
            giveUp(problem);
        });
    }
}

void SweepRunner::start()
{
    m_clock.start();
    m_tick.start(milliseconds(100));
    beginNextRun();
}

void SweepRunner::cancel()
{
    if (!m_stage.is(Stage::Restoring))
        giveUp(sentence("Reason", "cancelled"));
}

void SweepRunner::enter(Stage stage, Duration patience)
{
    m_stage.enter(stage, patience, now(), m_link.snapshotTime());
    m_link.setSnapshotsPerSecond(LinkDriver::kWatching);
}

void SweepRunner::beginNextRun()
{
    const SweepFlight &flight = m_flight.flight();
    if (flight.isUp() && (m_queue.atEnd() || m_queue.atBlockStart() || flight.endsBefore(m_queue.current().repeat))) {
        m_stage.enterUnlimited(Stage::Landing);
        return m_flight.beginLanding();
    }
    if (isEnding())
        return restoreLink();
    const Run &run = m_queue.current();
    if (m_queue.atBlockStart()) {
        if (m_link.station().isOpen())
            return closeStation();
        if (m_config.lab)
            m_config.lab->start(m_config.plan.loads[run.load], m_config.plan.conditions[run.condition], m_config.plan.seed);
    }
    m_runStart = now();
    m_fresh = !m_link.station().isOpen();
    m_attempts.beginRun(m_queue.atBlockStart());
    Q_EMIT runBegan(run);
    if (m_fresh)
        openStation();
    else
        prepareLink();
}

void SweepRunner::openStation()
{
    if (const auto opened = m_link.open(protectionOf(arm())); !opened)
        return giveUp(opened.error().reason());
    enter(Stage::Connecting, kConnectPatience);
}

void SweepRunner::handleEvent(const engine::Event &event)
{
    if (const auto *changed = std::get_if<engine::LinkChanged>(&event)) {
        handleLink(changed->link);
    } else if (const auto *up = std::get_if<channel::SessionUp>(&event)) {
        m_link.measured().sessionUp(*up);
        m_run.handleSessionUp(*up);
    } else if (const auto *done = std::get_if<channel::SwitchDone>(&event)) {
        m_run.handleSwitch(*done);
    } else if (const auto *result = std::get_if<vehicle::CommandResult>(&event)) {
        m_flight.handleResult(*result);
    } else if (const auto *written = std::get_if<vehicle::ParameterResult>(&event)) {
        m_flight.handleResult(*written);
    }
}

void SweepRunner::handleLink(const engine::LinkSnapshot &link)
{
    m_opened = m_opened || link.phase == engine::LinkPhase::Listening || link.phase == engine::LinkPhase::Connected;
    if (!m_opened && (link.phase == engine::LinkPhase::Failed || link.hostUnknown))
        giveUp(sentence("Reason", "%1: %2")(link.url, link.problem));
}

void SweepRunner::handleSnapshot(const LinkDriver::Snapshot &snapshot)
{
    m_link.take(snapshot);
    m_opened = m_opened || m_link.session();
    switch (m_stage.stage()) {
    case Stage::Clearing:
        if (m_link.hasUnreadable())
            changeLink();
        break;
    case Stage::Connecting:
        if (isConnected())
            enter(Stage::Settling, kConnectPatience);
        break;
    case Stage::Settling:
        if (m_link.isSettled(m_stage.age(snapshot->time), m_fresh))
            prepareLink();
        break;
    case Stage::Running: m_run.handleSnapshot(); break;
    case Stage::Flying:
    case Stage::Landing: m_flight.handleSnapshot(); break;
    case Stage::Restoring: continueRestoring(); break;
    case Stage::Idle:
    case Stage::Closing: break;
    }
}

/// The position matters only for a simulator that has just started.
bool SweepRunner::isConnected() const
{
    const engine::Snapshot &snapshot = *m_link.snapshot();
    const bool isOwnSimulator = m_config.lab && !m_config.lab->vehicle();
    return m_link.measured().hasReadableVehicle(snapshot) && (!isOwnSimulator || m_link.measured().hasSettledVehicle(snapshot));
}

void SweepRunner::handleProbe(const LinkDriver::Snapshot &snapshot)
{
    if (m_stage.is(Stage::Running))
        return m_run.handleProbe(snapshot);
    if (!m_stage.is(Stage::Restoring) || m_stage.age(snapshot->time) < 0)
        return; // of a run that was given up meanwhile
    m_link.takeAfterOrders(snapshot);
    continueRestoring();
}

void SweepRunner::handleClosed()
{
    if (m_stage.is(Stage::Landing))
        m_flight.handleClosed();
    else if (isEnding())
        end();
    else
        beginNextRun();
}

void SweepRunner::handleTimeout()
{
    switch (m_stage.stage()) {
    case Stage::Running: return m_run.handleTimeout();
    case Stage::Flying:
    case Stage::Landing: return m_flight.handleTimeout();
    default: break;
    }
    if (!m_stage.isOverdue(now()))
        return;
    if (m_stage.is(Stage::Restoring))
        return closeStation();
    if (m_stage.is(Stage::Clearing))
        return changeLink();
    if (m_link.measured().bareCipher()) {
        m_link.measured().bareSilent();
        return endRun(MeasuredLink::kUnreadable);
    }
    // Without a link each further run would only wait as long.
    if (!m_link.measured().isPlain())
        return giveUp(sentence("Reason", "no sealed session with a vehicle came up"));
    m_link.measured().plainSilent();
    endRun(sentence("Reason", "no vehicle was heard in plain MAVLink; do both ends allow it?"));
}

/// On a link that works: flies to the phase of the run, changes how the link carries MAVLink if the run needs another mode, and
/// begins the run otherwise.
void SweepRunner::prepareLink()
{
    const unsigned block = m_queue.current().repeat;
    if (m_flight.flight().needsLeg(block)) {
        m_stage.enterUnlimited(Stage::Flying);
        return m_flight.beginLeg(block);
    }
    m_link.measured().learnConsent(*m_link.snapshot());
    if (const Reason refusal = m_link.measured().refusal(arm()); !refusal.empty())
        return refuseRun(refusal);
    if (bareCipherOf(arm()) && (!m_config.lab || m_config.lab->vehicle() || m_config.borrowed))
        return refuseRun(sentence("Reason", "only the sweep's own simulator encrypts payloads with a bare cipher"));
    if (m_link.measured().isCarriedAs(arm())) {
        m_stage.enterUnlimited(Stage::Running);
        return m_run.begin(sampleOfRun(), m_fresh && !m_link.station().isBorrowed());
    }
    if (!m_link.measured().bareCipher())
        return changeLink();
    // The vehicle comes first, and the station follows what it hears, so that nothing encrypted is taken for telemetry.
    m_config.lab->setBareCipher(std::nullopt);
    m_link.forgetUnreadable();
    enter(Stage::Clearing, kClearPatience);
}

/// The vehicle, which is in clear, comes last, for the same reason.
void SweepRunner::changeLink()
{
    if (!m_link.measured().isCarriedAs(protectionOf(arm())))
        m_link.setProtection(protectionOf(arm()));
    if (const auto cipher = bareCipherOf(arm())) {
        if (const auto set = m_link.setBareCipher(cipher); !set)
            return refuseRun(set.error().reason());
        m_config.lab->setBareCipher(cipher);
    }
    enter(Stage::Connecting, kConnectPatience);
}

void SweepRunner::endRun(const Reason &problem)
{
    Sample sample = sampleOfRun();
    sample.problem = problem;
    endRun(std::move(sample));
}

void SweepRunner::endRun(Sample sample)
{
    sample.attempts = m_attempts.count();
    if (const std::string over = m_flight.endOfPhase(); !over.empty())
        return failFlight(over);
    if (!sample.invalid.empty() && m_attempts.mayRepeat()) {
        m_attempts.repeat();
        return m_run.repeat();
    }
    if (sample.problem.empty()) {
        addSessionMemory(sample);
        m_attempts.runMeasured(sample.invalid.empty());
        if (m_link.measured().isPlain())
            m_link.measured().plainSucceeded();
    } else {
        m_attempts.runFailed();
    }
    record(sample);
    if (m_attempts.isLinkLost())
        return giveUp(sentence("Reason", "given up after %1 runs in a row that failed; the last one: %2")(
            RunAttempts::kMostFailedRuns, sample.problem));
    beginNextRun();
}

/// Measured once for each suite, so one sample of each cell has it, however often the suite is run.
void SweepRunner::addSessionMemory(Sample &sample)
{
    const Cell cell{sample.run.condition, sample.run.load, sample.run.arm};
    if (!m_config.heap || arm().again || !m_link.measured().isCarriedAs(engine::Protection::Sealed)
        || summarise(valuesOf(m_results, cell, Metric::SessionMemory)).count > 0)
        return;
    if (const auto bytes = m_config.heap->session(arm().suite))
        sample.values[Metric::SessionMemory] = *bytes;
}

/// A run that the far end does not consent to is no sign of a lost link.
void SweepRunner::refuseRun(const Reason &problem)
{
    Sample sample = sampleOfRun();
    sample.problem = problem;
    record(sample);
    QTimer::singleShot(0, this, [this] { // hundreds of refused runs must not nest
        if (m_stage.is(Stage::Idle))
            beginNextRun();
    });
}

/// The run for which the vehicle flew is listed with the reason.
void SweepRunner::failFlight(const Reason &problem)
{
    Sample sample = sampleOfRun();
    sample.problem = problem;
    record(sample);
    giveUp(problem);
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
    m_stage.enterUnlimited(Stage::Idle);
    m_queue.finishRun(now());
    m_results.samples.push_back(sample);
    Q_EMIT sampleTaken(sample);
}

void SweepRunner::addProblem(const Reason &problem)
{
    if (m_problem.text().find(problem.text()) == std::string::npos)
        m_problem = m_problem.empty() ? problem : sentence("Reason", "%1; %2")(m_problem, problem);
}

void SweepRunner::giveUp(const Reason &problem)
{
    if (!m_problem.empty())
        return;
    m_problem = problem;
    m_run.abort();
    if (m_flight.flight().isUp()) {
        m_stage.enterUnlimited(Stage::Landing);
        m_flight.bringDown();
    } else if (!m_stage.is(Stage::Closing)) {
        restoreLink();
    }
}

/// Puts the link back on the suite that it had first. A station of the sweep's own is closed at once where that cannot be done.
void SweepRunner::restoreLink()
{
    if (!m_link.station().isOpen())
        return end();
    if (!m_link.beginRestoring())
        return closeStation();
    enter(Stage::Restoring, kRestorePatience);
    m_link.station().requestProbe(); // behind every order so far
}

void SweepRunner::continueRestoring()
{
    if (m_link.isRestoringOver())
        closeStation();
    else
        m_link.orderSwitch(now());
}

void SweepRunner::closeStation()
{
    m_stage.enterUnlimited(Stage::Closing);
    m_link.close();
}

void SweepRunner::end()
{
    if (!m_tick.isActive())
        return; // it has ended already
    m_tick.stop();
    m_run.abort();
    if (m_config.lab)
        m_config.lab->stop();
    m_stage.enterUnlimited(Stage::Idle);
    m_results.complete = m_problem.empty() && m_queue.atEnd();
    m_results.seconds = now();
    Q_EMIT finished(m_opened, m_problem);
}

} // namespace skyseal::experiment

#include "moc_sweep_runner.cpp"
