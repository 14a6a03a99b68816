#include "core/experiment/sweep_runner.h"

#include "core/experiment/cipher_bench.h"
#include "core/experiment/statistics.h"
#include "core/metrics/process_usage.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace skyseal::experiment {

namespace {

using std::chrono::milliseconds;

constexpr Duration kSettle = milliseconds(500); ///< a station that just connected asks for much that it never asks again
constexpr Duration kSettleAgain = milliseconds(200);
constexpr Duration kSettleMost = std::chrono::seconds(2); ///< for a vehicle that does not answer TIMESYNC
constexpr double kPaceTrips = 6;
constexpr Duration kMostWarmUp = std::chrono::seconds(12);
constexpr unsigned kMostFailures = 3; ///< runs in a row; the link is gone then
constexpr Duration kLatencyEvery = milliseconds(200);
constexpr int kSnapshotsPerSecond = 20;
const std::string kNothingClear = "no vehicle was heard in clear; do both ends consent to it?";

} // namespace

SweepRunner::SweepRunner(SweepConfig config)
    : m_config(std::move(config)), m_schedule(schedule(m_config.plan)),
      m_timeLeft(seconds(m_config.plan.measure + m_config.plan.warmUp) + 0.2)
{
    m_results.plan = m_config.plan;
    connect(&m_tick, &QTimer::timeout, this, [this] { tick(); });
    if (m_config.lab) {
        connect(m_config.lab, &Lab::ended, this, [this](const QString &problem) {
            m_opened = true; // it is a program that failed, not a link
            giveUp(problem.toStdString());
        });
    }
}

SweepRunner::~SweepRunner()
{
    if (m_station && !m_own)
        giveBack();
}

/// Answers to TIMESYNC, of all vehicles.
double SweepRunner::tripsOf(const engine::Snapshot &snapshot)
{
    double out = 0;
    for (const engine::VehicleSnapshot &vehicle : snapshot.vehicles)
        out += static_cast<double>(vehicle.state.trips);
    return out;
}

/// The session that is alive, other than one that is about to end.
const engine::SessionSnapshot *SweepRunner::session(const engine::Snapshot &snapshot) const
{
    const auto found = std::find_if(
        snapshot.sessions.begin(), snapshot.sessions.end(),
        [this](const engine::SessionSnapshot &session) { return !session.info.silent && session.info.session != m_ended; });
    return found == snapshot.sessions.end() ? nullptr : &*found;
}

/// In the way that is wanted.
bool SweepRunner::speaks(const engine::Snapshot &snapshot, const engine::VehicleSnapshot &vehicle) const
{
    const engine::SessionSnapshot *up = session(snapshot);
    const auto way = isPlain() || !up ? std::nullopt : std::optional(up->info.session);
    return (isPlain() || way) && !vehicle.state.lost && vehicle.session == way;
}

bool SweepRunner::vehicleSpeaks(const engine::Snapshot &snapshot) const
{
    return std::any_of(snapshot.vehicles.begin(), snapshot.vehicles.end(),
                       [&](const engine::VehicleSnapshot &vehicle) { return speaks(snapshot, vehicle); });
}

/// One that speaks; one of our own also knows where it is: while it starts it says more, and is asked for more, than later.
bool SweepRunner::vehicleReady(const engine::Snapshot &snapshot) const
{
    return std::any_of(snapshot.vehicles.begin(), snapshot.vehicles.end(), [&](const engine::VehicleSnapshot &vehicle) {
        const bool settled = vehicle.state.ekfOk.value_or(false) && vehicle.state.home.known();
        return speaks(snapshot, vehicle) && (settled || !m_config.lab);
    });
}

void SweepRunner::start()
{
    m_clock.start();
    m_tick.start(milliseconds(100));
    next();
}

void SweepRunner::cancel()
{
    if (m_cancelled || m_stage == Stage::Restoring)
        return;
    m_cancelled = true;
    m_problem = "cancelled";
    if (m_stage != Stage::Closing)
        restore();
}

bool SweepRunner::beginsBlock(std::size_t run) const
{
    const auto blockOf = [](const Run &one) { return std::pair(one.condition, one.load); };
    return run == 0 || blockOf(m_schedule[run]) != blockOf(m_schedule[run - 1]);
}

double SweepRunner::remaining() const
{
    std::size_t blocks = 0;
    for (std::size_t i = m_next; i < m_schedule.size(); ++i)
        blocks += beginsBlock(i);
    return m_timeLeft.of(m_schedule.size() - m_next, blocks);
}

void SweepRunner::enter(Stage stage, Duration patience)
{
    m_stage = stage;
    m_patience = patience;
    m_stageClock.start();
    m_stageStart = m_snapshot ? m_snapshot->time : 0;
}

void SweepRunner::next()
{
    if (m_cancelled || m_next == m_schedule.size())
        return restore();
    const std::pair block{run().condition, run().load};
    const bool newBlock = m_block != block;
    if (m_own && newBlock)
        return closeStation();
    if (newBlock) {
        m_block = block;
        enterBlock(run());
    }
    m_runStart = static_cast<double>(m_clock.elapsed()) / 1000;
    m_switchTook = std::numeric_limits<double>::quiet_NaN();
    m_switchOrdered.reset();
    m_orders = 0;
    m_switchesFailed = 0;
    m_fresh = !m_station;
    Q_EMIT runBegan(run());
    if (!m_station)
        return openStation();
    connectUp(*m_snapshot);
}

void SweepRunner::enterBlock(const Run &run)
{
    if (m_config.lab)
        m_config.lab->start(m_config.plan.loads[run.load], m_config.plan.conditions[run.condition], m_config.plan.seed);
}

void SweepRunner::openStation()
{
    m_snapshot.reset();
    m_session.reset();
    m_protection.reset();
    m_ended.reset();
    m_tripsBefore = 0;
    if (m_config.borrowed) {
        m_station = m_config.borrowed;
        listen();
        connect(m_station, &QObject::destroyed, this, [this] {
            m_station = nullptr;
            m_cancelled = true;
            if (m_problem.empty())
                m_problem = "the station ended";
            end();
        });
        return enter(Stage::Connecting, kConnectPatience);
    }
    engine::StationConfig config = m_config.station;
    config.secure = engine::SecureMode::Required;
    config.record = false;
    config.timeSyncEvery = kLatencyEvery;
    config.snapshotsPerSecond = kSnapshotsPerSecond;
    auto station = engine::Station::create(config);
    if (!station)
        return giveUp(station.error().text());
    m_own = std::move(*station);
    m_station = m_own.get();
    listen();
    connect(m_station, &engine::Station::stopped, this, [this] {
        // It is the sender of this signal.
        m_own.release()->deleteLater();
        m_station = nullptr;
        QTimer::singleShot(0, this,
                           [this] { m_cancelled || !m_problem.empty() || m_next == m_schedule.size() ? end() : next(); });
    });
    protect(wantedProtection());
    m_station->addLink(*m_config.link);
    enter(Stage::Connecting, kConnectPatience);
}

void SweepRunner::listen()
{
    connect(m_station, &engine::Station::snapshotReady, this,
            [this](const std::shared_ptr<const engine::Snapshot> &snapshot) { take(snapshot); });
    connect(m_station, &engine::Station::eventOccurred, this, [this](const engine::Event &event) { hear(event); });
    m_station->setMeasuring(true);
}

void SweepRunner::closeStation()
{
    m_stage = Stage::Closing;
    if (m_own)
        return m_station->stop();
    giveBack();
    QTimer::singleShot(0, this, [this] { end(); });
}

void SweepRunner::hear(const engine::Event &event)
{
    if (const auto *changed = std::get_if<engine::LinkChanged>(&event)) {
        const engine::LinkSnapshot &link = changed->link;
        m_opened = m_opened || link.phase == engine::LinkPhase::Listening || link.phase == engine::LinkPhase::Connected;
        if (!m_opened && (link.phase == engine::LinkPhase::Failed || link.hostUnknown))
            giveUp(link.url + ": " + link.problem);
    } else if (const auto *up = std::get_if<channel::SessionUp>(&event)) {
        m_framing = up->framing;
    } else if (const auto *done = std::get_if<channel::SwitchDone>(&event)) {
        hearSwitch(*done);
    }
}

void SweepRunner::take(const std::shared_ptr<const engine::Snapshot> &snapshot)
{
    if (!snapshot->probe)
        return;
    m_snapshot = snapshot;
    const engine::SessionSnapshot *up = session(*snapshot);
    if (up && !m_firstSuite)
        m_firstSuite = up->info.suite;
    m_opened = m_opened || up;
    advance(*snapshot);
}

void SweepRunner::advance(const engine::Snapshot &snapshot)
{
    const double since = snapshot.time - m_stageStart;
    switch (m_stage) {
    case Stage::Connecting:
        if (vehicleReady(snapshot))
            enter(Stage::Settling, kConnectPatience);
        break;
    case Stage::Settling:
        // An answer to TIMESYNC shows that the way there is known, too; in clear the next heartbeat tells it.
        if (since >= seconds(kSettleMost)
            || (since >= seconds(m_fresh ? kSettle : kSettleAgain) && tripsOf(snapshot) > m_tripsBefore))
            connectUp(snapshot);
        break;
    case Stage::Switching: switchSuite(snapshot); break;
    case Stage::WarmingUp:
        if (!isUnderWantedSuite(snapshot))
            beginSwitching(snapshot); // the link was lost, and nothing was measured yet
        else if (since >= warmUpOf(snapshot))
            beginRun();
        break;
    case Stage::Measuring:
        noteReport(snapshot);
        if (isAnotherSession(snapshot) || since >= seconds(m_config.plan.measure))
            endRun();
        break;
    case Stage::Restoring: putBack(snapshot); break;
    case Stage::Idle:
    case Stage::Closing: break;
    }
}

/// Seconds. A load that follows the answers of the other end takes several trips to find its pace.
double SweepRunner::warmUpOf(const engine::Snapshot &snapshot) const
{
    double out = seconds(m_config.plan.warmUp);
    if (m_config.plan.loads[run().load] != Load::Saturated)
        return out;
    for (const engine::VehicleSnapshot &vehicle : snapshot.vehicles) {
        if (!vehicle.state.lost && !std::isnan(vehicle.state.latency))
            out = std::max(out, std::min(kPaceTrips * vehicle.state.latency, seconds(kMostWarmUp)));
    }
    return out;
}

Reading SweepRunner::readingOf(const std::shared_ptr<const engine::Snapshot> &snapshot)
{
    Reading out;
    out.station = snapshot;
    if (const engine::SessionSnapshot *up = session(*snapshot))
        out.agent = agentReport(*up);
    out.microjoules = m_energy.microjoules();
    if (m_config.lab) {
        out.agentCpu = metrics::processCpuTime(m_config.lab->agentProcess());
        out.agentMemory = metrics::residentBytes(m_config.lab->agentProcess());
    }
    return out;
}

void SweepRunner::beginRun()
{
    const engine::SessionSnapshot *up = session(*m_snapshot);
    m_session = up ? std::optional(up->info.session) : std::nullopt;
    m_begin = readingOf(m_snapshot);
    m_reportBefore = m_begin.agent ? std::optional(m_begin.agent->stamp) : std::nullopt;
    m_begin.agent.reset();
    enter(Stage::Measuring, m_config.plan.measure + kConnectPatience);
}

/// The agent's costs are counted from its first report of the run on: the one before it may be of another suite's time.
void SweepRunner::noteReport(const engine::Snapshot &snapshot)
{
    const engine::SessionSnapshot *up = session(snapshot);
    const auto report = up ? agentReport(*up) : std::nullopt;
    if (!m_begin.agent && report && report->stamp != m_reportBefore)
        m_begin.agent = report;
}

void SweepRunner::endRun(std::string problem)
{
    Sample sample;
    sample.run = run();
    sample.order = static_cast<unsigned>(m_next);
    sample.start = m_runStart;
    if (problem.empty()) {
        const engine::SessionSnapshot *up = session(*m_snapshot);
        if (!isPlain() && (!up || up->info.session != m_session || up->info.suite != wantedSuite()))
            problem = "the session did not last through the run";
    }
    if (problem.empty()) {
        sample.values = valuesBetween(
            m_begin, readingOf(m_snapshot), !isPlain(),
            numbersTell(m_config.plan.conditions[run().condition].settings, m_config.plan.loads[run().load]));
        if (!vehicleSpeaks(*m_snapshot) || sample.values[Metric::Packets] == 0)
            problem = "the vehicle fell silent during the run";
    }
    if (problem.empty()) {
        sample.seconds = m_snapshot->time - m_begin.station->time;
        sample.values[Metric::Switch] = m_switchTook;
        // Measured once, so it is one sample and no more, however often the suite is run.
        const Cell cell{run().condition, run().load, run().arm};
        const bool again = m_config.plan.arms[run().arm].again;
        if (m_config.heap && !again && m_protection == engine::Protection::Sealed
            && summarise(valuesOf(m_results, cell, Metric::SessionMemory)).count == 0) {
            double &memory = sample.values[Metric::SessionMemory];
            memory = m_config.heap->session(wantedSuite()).value_or(memory);
        }
        sample.begin = countedBy(*m_begin.station);
        sample.end = countedBy(*m_snapshot);
        m_plainWorked = m_plainWorked || isPlain();
        m_failuresInARow = 0;
    } else {
        sample.values = {};
        sample.problem = std::move(problem);
        ++m_failuresInARow;
    }
    record(sample);
    if (m_failuresInARow >= kMostFailures)
        return giveUp("given up after " + std::to_string(kMostFailures)
                      + " runs in a row that failed; the last one: " + sample.problem);
    next();
}

/// What the other end does not consent to is no sign of a link that is gone.
void SweepRunner::refuseRun(const std::string &problem)
{
    Sample sample;
    sample.run = run();
    sample.order = static_cast<unsigned>(m_next);
    sample.start = m_runStart;
    sample.problem = problem;
    record(sample);
    QTimer::singleShot(0, this, [this] { // not one within the other for hundreds of runs
        if (m_stage == Stage::Idle)
            next();
    });
}

void SweepRunner::record(Sample sample)
{
    m_stage = Stage::Idle;
    const double now = static_cast<double>(m_clock.elapsed()) / 1000;
    m_timeLeft.runEnded(now - std::exchange(m_lastEnd, now), beginsBlock(m_next));
    ++m_next;
    m_results.samples.push_back(sample);
    Q_EMIT sampleTaken(sample);
}

void SweepRunner::giveUp(const std::string &problem)
{
    if (!m_problem.empty())
        return;
    m_problem = problem;
    m_cancelled = true;
    if (m_stage != Stage::Closing)
        restore();
}

void SweepRunner::tick()
{
    if (m_stage == Stage::Idle || m_stage == Stage::Closing || Duration(milliseconds(m_stageClock.elapsed())) < m_patience)
        return;
    switch (m_stage) {
    case Stage::Connecting:
    case Stage::Settling:
        // Without a link each further run would only wait as long.
        if (!isPlain())
            return giveUp("no sealed session with a vehicle came up");
        m_plainRefused = !m_plainWorked;
        endRun(kNothingClear);
        break;
    case Stage::Restoring: closeStation(); break;
    default: endRun("the link fell silent");
    }
}

void SweepRunner::end()
{
    if (!m_tick.isActive())
        return; // it was said
    m_tick.stop();
    if (m_config.lab)
        m_config.lab->stop();
    m_stage = Stage::Idle;
    m_results.complete = m_problem.empty() && m_next == m_schedule.size();
    m_results.seconds = static_cast<double>(m_clock.elapsed()) / 1000;
    Q_EMIT finished(m_opened, m_problem);
}

} // namespace skyseal::experiment
