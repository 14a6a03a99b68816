#include "core/experiment/sweep_runner.h"

#include "core/metrics/process_usage.h"

#include <algorithm>

namespace skyseal::experiment {

namespace {

using std::chrono::milliseconds;

constexpr Duration kConnectPatience = std::chrono::seconds(20);
constexpr Duration kSwitchPatience = std::chrono::seconds(15);
constexpr Duration kSettle = milliseconds(500); ///< a station that just connected asks for much that it never asks again
constexpr unsigned kMostFailures = 3;           ///< runs in a row; the link is gone then
constexpr Duration kLatencyEvery = milliseconds(200);
constexpr int kSnapshotsPerSecond = 20;

const engine::SessionSnapshot *liveSession(const engine::Snapshot &snapshot)
{
    const auto found = std::find_if(snapshot.sessions.begin(), snapshot.sessions.end(),
                                    [](const engine::SessionSnapshot &session) { return !session.info.silent; });
    return found == snapshot.sessions.end() ? nullptr : &*found;
}

/// `settled`: it also knows where it is; while it starts it says more, and is asked for more, than later.
bool vehicleSpeaks(const engine::Snapshot &snapshot, bool settled)
{
    return std::any_of(snapshot.vehicles.begin(), snapshot.vehicles.end(), [settled](const engine::VehicleSnapshot &vehicle) {
        return !vehicle.state.lost && (!settled || (vehicle.state.ekfOk.value_or(false) && vehicle.state.home.known()));
    });
}

} // namespace

SweepRunner::SweepRunner(SweepConfig config) : m_config(std::move(config)), m_schedule(schedule(m_config.plan))
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

SweepRunner::~SweepRunner() = default;

void SweepRunner::start()
{
    m_clock.start();
    m_tick.start(milliseconds(100));
    next();
}

void SweepRunner::cancel()
{
    if (m_cancelled)
        return;
    m_cancelled = true;
    m_problem = "cancelled";
    if (m_stage != Stage::Closing)
        restore();
}

double SweepRunner::remaining() const
{
    const Plan &plan = m_config.plan;
    const double planned = seconds(plan.measure + plan.warmUp) + 0.2;
    const auto done = static_cast<double>(m_next), left = static_cast<double>(m_schedule.size() - m_next);
    const double taken = done > 0 ? static_cast<double>(m_clock.elapsed()) / 1000 / done : planned;
    return left * std::max(planned, taken);
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
    if (m_station && (newBlock || m_plain != wantsPlain()))
        return closeStation();
    if (newBlock) {
        m_block = block;
        enterBlock(run());
    }
    m_runStart = static_cast<double>(m_clock.elapsed()) / 1000;
    m_switchTook = std::numeric_limits<double>::quiet_NaN();
    m_switchOrdered = false;
    if (!m_station)
        return openStation();
    enter(Stage::Switching, kSwitchPatience);
    switchSuite(*m_snapshot);
}

void SweepRunner::enterBlock(const Run &run)
{
    if (m_config.lab)
        m_config.lab->start(m_config.plan.loads[run.load], m_config.plan.conditions[run.condition], m_config.plan.seed);
}

void SweepRunner::openStation()
{
    engine::StationConfig config = m_config.station;
    m_plain = wantsPlain();
    config.secure = m_plain ? engine::SecureMode::Off : engine::SecureMode::Required;
    config.record = false;
    config.timeSyncEvery = kLatencyEvery;
    config.snapshotsPerSecond = kSnapshotsPerSecond;
    auto station = engine::Station::create(config);
    if (!station)
        return giveUp(station.error().text());
    m_station = std::move(*station);
    m_snapshot.reset();
    m_session.reset();
    connect(m_station.get(), &engine::Station::snapshotReady, this,
            [this](const std::shared_ptr<const engine::Snapshot> &snapshot) { take(snapshot); });
    connect(m_station.get(), &engine::Station::happened, this,
            [this](const engine::Happening &happening) { hear(happening); });
    connect(m_station.get(), &engine::Station::stopped, this, [this] {
        // It is the sender of this signal.
        m_station.release()->deleteLater();
        QTimer::singleShot(0, this, [this] { m_cancelled || !m_problem.empty() || m_next == m_schedule.size() ? end() : next(); });
    });
    m_station->setMeasuring(true);
    m_station->addLink(m_config.link);
    enter(Stage::Connecting, kConnectPatience);
}

void SweepRunner::closeStation()
{
    m_stage = Stage::Closing;
    m_station->stop();
}

void SweepRunner::hear(const engine::Happening &happening)
{
    if (const auto *changed = std::get_if<engine::LinkChanged>(&happening)) {
        const engine::LinkSnapshot &link = changed->link;
        m_opened = m_opened || link.phase == engine::LinkPhase::Listening || link.phase == engine::LinkPhase::Connected;
        if (!m_opened && (link.phase == engine::LinkPhase::Failed || link.hostUnknown))
            giveUp(link.url + ": " + link.problem);
    } else if (const auto *up = std::get_if<channel::SessionUp>(&happening)) {
        if (!m_firstSuite)
            m_firstSuite = up->suite;
    } else if (const auto *done = std::get_if<channel::SwitchDone>(&happening)) {
        if (done->rekey || m_stage != Stage::Switching || done->to != wantedSuite())
            return;
        if (done->failure == channel::SwitchFailure::None)
            m_switchTook = seconds(done->took) * 1000;
        else if (done->failure != channel::SwitchFailure::Superseded)
            endRun("the other end did not take this suite");
    }
}

void SweepRunner::take(const std::shared_ptr<const engine::Snapshot> &snapshot)
{
    if (!snapshot->probe)
        return;
    m_snapshot = snapshot;
    advance(*snapshot);
}

void SweepRunner::advance(const engine::Snapshot &snapshot)
{
    const double since = snapshot.time - m_stageStart;
    const engine::SessionSnapshot *session = liveSession(snapshot);
    switch (m_stage) {
    case Stage::Connecting:
        if (vehicleSpeaks(snapshot, m_config.lab != nullptr) && (m_plain || session))
            enter(Stage::Settling, kConnectPatience);
        break;
    case Stage::Settling:
        if (since >= seconds(kSettle)) {
            enter(Stage::Switching, kSwitchPatience);
            switchSuite(snapshot);
        }
        break;
    case Stage::Switching:
        switchSuite(snapshot);
        break;
    case Stage::WarmingUp:
        if (since >= seconds(m_config.plan.warmUp))
            beginRun();
        break;
    case Stage::Measuring:
        if (since >= seconds(m_config.plan.measure))
            endRun();
        break;
    case Stage::Restoring:
        if (!session || (session->info.suite == *m_firstSuite && !session->info.pending))
            closeStation();
        break;
    case Stage::Idle:
    case Stage::Closing:
        break;
    }
}

void SweepRunner::switchSuite(const engine::Snapshot &snapshot)
{
    const engine::SessionSnapshot *session = liveSession(snapshot);
    if (!m_plain && (!session || session->info.pending))
        return;
    if (m_plain || session->info.suite == wantedSuite()) {
        enter(Stage::WarmingUp, m_config.plan.warmUp + kConnectPatience);
    } else if (!m_switchOrdered) {
        m_switchOrdered = true;
        m_station->switchSuite(session->info.session, wantedSuite());
    }
}

Reading SweepRunner::readingOf(const std::shared_ptr<const engine::Snapshot> &snapshot) const
{
    Reading out;
    out.station = snapshot;
    if (m_config.lab) {
        out.agentCpu = metrics::processCpuTime(m_config.lab->agentProcess());
        out.agentMemory = metrics::residentBytes(m_config.lab->agentProcess());
    }
    return out;
}

void SweepRunner::beginRun()
{
    const engine::SessionSnapshot *session = liveSession(*m_snapshot);
    m_session = session ? std::optional(session->info.session) : std::nullopt;
    m_begin = readingOf(m_snapshot);
    enter(Stage::Measuring, m_config.plan.measure + kConnectPatience);
}

void SweepRunner::endRun(std::string problem)
{
    Sample sample;
    sample.run = run();
    sample.order = static_cast<unsigned>(m_next);
    sample.start = m_runStart;
    if (problem.empty()) {
        const engine::SessionSnapshot *session = liveSession(*m_snapshot);
        if (!m_plain && (!session || session->info.session != m_session || session->info.suite != wantedSuite()))
            problem = "the session did not last through the run";
    }
    if (problem.empty()) {
        sample.seconds = m_snapshot->time - m_begin.station->time;
        sample.values = valuesBetween(m_begin, readingOf(m_snapshot), !m_plain);
        sample.values[Metric::Switch] = m_switchTook;
        m_failuresInARow = 0;
    } else {
        sample.problem = std::move(problem);
        ++m_failuresInARow;
    }
    m_stage = Stage::Idle;
    ++m_next;
    m_results.samples.push_back(sample);
    Q_EMIT sampleTaken(sample);
    if (m_failuresInARow >= kMostFailures)
        return giveUp("given up after " + std::to_string(kMostFailures) + " runs in a row that failed; the last one: "
                      + sample.problem);
    next();
}

void SweepRunner::restore()
{
    if (!m_station)
        return end();
    const engine::SessionSnapshot *session = m_snapshot ? liveSession(*m_snapshot) : nullptr;
    if (m_plain || !session || !m_firstSuite || session->info.suite == *m_firstSuite)
        return closeStation();
    enter(Stage::Restoring, kSwitchPatience);
    m_station->switchSuite(session->info.session, *m_firstSuite);
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
        giveUp(m_plain ? "no vehicle was heard in clear; do both ends consent to it?" : "no sealed session with a vehicle came up");
        break;
    case Stage::Restoring:
        closeStation();
        break;
    default:
        endRun("the link fell silent");
    }
}

void SweepRunner::end()
{
    m_tick.stop();
    if (m_config.lab)
        m_config.lab->stop();
    m_stage = Stage::Idle;
    m_results.complete = m_problem.empty() && m_next == m_schedule.size();
    m_results.seconds = static_cast<double>(m_clock.elapsed()) / 1000;
    Q_EMIT finished(m_opened, m_problem);
}

} // namespace skyseal::experiment
