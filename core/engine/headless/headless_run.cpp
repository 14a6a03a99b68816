#include "core/engine/headless/headless_run.h"

#include "core/crypto/mavsec_cipher.h"
#include "core/channel/timing.h"
#include "core/engine/station/snapshot.h"
#include "core/engine/station/vehicle_snapshot.h"
#include "core/link/steady_now.h"

#include <algorithm>

namespace skyseal::engine {

namespace {

constexpr std::chrono::milliseconds kTick{50};

std::string listOf(const std::vector<crypto::SuiteId> &suites)
{
    std::string out;
    for (const crypto::SuiteId suite : suites)
        out.append(out.empty() ? "" : ", ").append(crypto::suiteInfo(suite).name);
    return out;
}

} // namespace

HeadlessRun::HeadlessRun(Station &station, RunListener &listener, RunPlan plan, std::vector<link::LinkUrl> links)
    : m_station(station), m_listener(listener), m_plan(std::move(plan)), m_urls(std::move(links)), m_script(m_plan.script),
      m_switching(m_plan.switchTo, m_plan.switchEvery)
{
    connect(&m_station, &Station::snapshotReady, this,
            [this](const std::shared_ptr<const Snapshot> &snapshot) { take(snapshot); });
    connect(&m_station, &Station::eventOccurred, this, [this](const Event &event) { handleEvent(event); });
    connect(&m_station, &Station::stopped, this, [this](const std::shared_ptr<const Snapshot> &last) { settle(*last); });
    m_tick.setTimerType(Qt::PreciseTimer);
    connect(&m_tick, &QTimer::timeout, this, [this] { tick(); });
}

void HeadlessRun::start()
{
    m_clock.start();
    if (!m_plan.serve.empty())
        m_station.serve(m_plan.serve);
    for (const link::LinkUrl &url : m_urls) {
        const LinkId id = addLink(url);
        m_links[id] = false;
        if (url.traits().isRecording)
            m_played[id] = false;
    }
    m_tick.start(kTick);
}

LinkId HeadlessRun::addLink(const link::LinkUrl &url)
{
    return m_plan.mavsec ? m_station.addMavsecLink(url, m_plan.mavsec->clone()) : m_station.addLink(url);
}

void HeadlessRun::stop()
{
    if (m_stopping)
        return;
    m_stopping = true;
    m_tick.stop();
    m_station.stop();
}

void HeadlessRun::take(const std::shared_ptr<const Snapshot> &snapshot)
{
    m_snapshot = snapshot;
}

void HeadlessRun::handleEvent(const Event &event)
{
    const TimePoint now = steadyNow();
    if (const auto *up = std::get_if<channel::SessionUp>(&event)) {
        m_sessionSeen = true;
        m_inlineSeen = m_inlineSeen || up->framing == channel::Framing::Inline;
        m_switching.sessionUp(now, up->session);
    } else if (const auto *down = std::get_if<channel::SessionDown>(&event)) {
        m_switching.sessionDown(down->session);
    } else if (const auto *done = std::get_if<channel::SwitchDone>(&event)) {
        m_switching.switchDone(*done);
    } else if (const auto *result = std::get_if<vehicle::CommandResult>(&event)) {
        m_script.handleResult(*result);
    } else if (const auto *written = std::get_if<vehicle::ParameterResult>(&event)) {
        m_script.handleResult(*written);
    }
    m_listener.eventOccurred(event);
    if (const auto *changed = std::get_if<LinkChanged>(&event))
        watchLinks(changed->link);
    else if (const auto *served = std::get_if<ServedLinkChanged>(&event))
        watchServed(served->link);
    drainScript();
    if (m_plan.task && !m_stopping) {
        m_plan.task->handle(event);
        drainTask();
    }
}

void HeadlessRun::watchLinks(const LinkSnapshot &link)
{
    const auto known = m_links.find(link.id);
    if (known == m_links.end())
        return;
    if (link.phase == LinkPhase::Listening || link.phase == LinkPhase::Connected)
        known->second = true;
    if (link.phase == LinkPhase::Finished && m_played.contains(link.id))
        m_played[link.id] = true;
    if (!known->second && !link.problem.empty())
        m_linkProblem = link.url + ": " + link.problem.text();
    const bool hopeless = link.phase == LinkPhase::Failed || (link.phase == LinkPhase::Waiting && link.hostUnknown);
    const bool hasWorked = known->second && !m_played.contains(link.id); // a recording without a frame fails at its end
    if (!hasWorked && hopeless && m_brokenLink.empty()) {
        m_brokenLink = link.url + ": " + link.problem.text();
        stop();
    }
}

/// The failure of a port of the gateway ends the run.
void HeadlessRun::watchServed(const LinkSnapshot &link)
{
    if (!link.addressInUse && link.phase != LinkPhase::Failed)
        return;
    m_brokenLink = link.url + ": " + link.problem.text();
    stop();
}

void HeadlessRun::tick()
{
    const TimePoint now = steadyNow();
    if (!isDue()) {
        for (const SwitchPlan::Order &order : m_switching.poll(now))
            m_station.switchSuite(order.session, order.suite);
    }
    fly(now);
    if (m_plan.task && m_snapshot) {
        m_plan.task->advance(now, *m_snapshot);
        drainTask();
    }
    if (const int second = static_cast<int>(m_clock.elapsed() / 1000); second > m_seconds && m_snapshot) {
        m_seconds = second;
        m_listener.secondPassed(*m_snapshot, elapsed());
    }
    endIfDue();
}

void HeadlessRun::fly(TimePoint now)
{
    if (m_script.finished() || !m_snapshot)
        return;
    std::vector<const vehicle::VehicleState *> states;
    for (const VehicleSnapshot &vehicle : m_snapshot->vehicles)
        states.push_back(&vehicle.state);
    m_script.advance(now, states);
    drainScript();
}

void HeadlessRun::drainScript()
{
    while (auto next = m_script.pollRequest())
        m_script.requestSent(m_station.perform(next->systemId, std::move(next->request)));
    while (const auto report = m_script.pollReport())
        m_listener.stepEnded(*report);
}

void HeadlessRun::drainTask()
{
    while (auto next = m_plan.task->pollRequest())
        m_plan.task->requestSent(m_station.perform(next->systemId, std::move(next->request)));
    if (m_plan.task->isFinished())
        stop();
}

bool HeadlessRun::isDue() const
{
    const bool timeUp = m_plan.duration && elapsed() >= seconds(*m_plan.duration);
    const bool flown = !m_plan.script.empty() && m_script.finished() && (!m_plan.duration || m_script.failed());
    const bool played = !m_played.empty() && m_played.size() == m_links.size() && !m_plan.duration
        && std::all_of(m_played.begin(), m_played.end(), [](const auto &log) { return log.second; });
    return timeUp || flown || (played && !m_plan.task);
}

void HeadlessRun::endIfDue()
{
    if (!isDue())
        return;
    if (!m_due)
        m_due = elapsed();
    // A pending switch may complete: otherwise it would be reported as rolled back although nothing failed.
    const double grace = m_switching.isPending() ? seconds(channel::Timing().switchConfirm) + 1 : 0;
    if (elapsed() >= *m_due + grace)
        stop();
}

void HeadlessRun::settle(const Snapshot &last)
{
    m_listener.ended(last, elapsed());
    const auto end = [this](RunOutcome outcome, std::string problem = {}) { Q_EMIT finished(outcome, std::move(problem)); };
    if (!m_brokenLink.empty())
        return end(RunOutcome::CannotOpen, m_brokenLink);
    // Each link kept retrying, but the run is over and no link ever worked.
    const bool anyWorked = std::any_of(m_links.begin(), m_links.end(), [](const auto &link) { return link.second; });
    if (!anyWorked && !m_linkProblem.empty())
        return end(RunOutcome::CannotOpen, m_linkProblem);
    if (m_script.failed())
        return end(RunOutcome::ScriptFailed, "a step of the flight script failed");
    if (!m_script.finished())
        return end(RunOutcome::ScriptUnfinished, "the run ended before the flight script did");
    if (m_plan.task && (!m_plan.task->isFinished() || !m_plan.task->problem().empty())) {
        if (m_plan.sessionRequired && !m_sessionSeen)
            return end(RunOutcome::NoSession, "no sealed session was established");
        if (!m_plan.task->isFinished())
            return end(RunOutcome::TaskFailed, "interrupted before the end");
        return end(m_plan.task->isFileProblem() ? RunOutcome::CannotOpen : RunOutcome::TaskFailed, m_plan.task->problem());
    }
    if (m_plan.sessionRequired && !m_sessionSeen)
        return end(RunOutcome::NoSession, "no sealed session was established");
    if (m_plan.inlineRequired && !m_inlineSeen)
        return end(RunOutcome::InlineNotReached, "the other end does not allow inline framing (skyseal-air --allow-inline)");
    if (const auto missed = m_switching.notReached(); !missed.empty())
        return end(RunOutcome::SuiteNotReached, "never came into use: " + listOf(missed));
    end(RunOutcome::Reached);
}

} // namespace skyseal::engine

#include "moc_headless_run.cpp"
