#include "core/engine/replay/replay_worker.h"

#include "core/engine/station/snapshot.h"
#include "core/link/link_error.h"
#include "core/link/steady_now.h"
#include "core/log/open_log.h"

#include <QtCore/QThread>

#include <algorithm>
#include <utility>

namespace skyseal::engine {

namespace {

/// Entries that are taken before commands are looked at again: a few milliseconds.
constexpr std::size_t kPortion = 4000;
constexpr std::chrono::milliseconds kPlayEvery{34}; // a little more than the least interval of snapshots

} // namespace

ReplayWorker::ReplayWorker(const link::LinkUrl &recording) : m_recording(recording)
{
    m_link.id = LinkId{1};
    m_link.url = m_recording.toText();
    m_link.localAddress = m_recording.path();
    m_link.recording = true;
    connect(this, &ReplayWorker::tasksPosted, this, &ReplayWorker::runTasks, Qt::QueuedConnection);
}

void ReplayWorker::post(const Task &task)
{
    if (m_tasks.put(task))
        Q_EMIT tasksPosted();
}

void ReplayWorker::begin()
{
    m_timer = new QTimer(this);
    m_timer->setSingleShot(true);
    m_timer->setTimerType(Qt::PreciseTimer);
    connect(m_timer, &QTimer::timeout, this, &ReplayWorker::wake);
    m_start = steadyNow();
    if (open()) {
        startOver();
        m_clock.setPlaying(m_start, true);
        m_link.phase = LinkPhase::Connected;
    }
    publish(LinkChanged{m_link});
    wake();
}

bool ReplayWorker::open()
{
    const std::string &path = m_recording.path();
    auto file = tlog::openLog(path);
    auto indexed = tlog::openLog(path);
    if (!file || !indexed) {
        fail(file ? indexed.error() : file.error());
        return false;
    }
    m_file = std::move(*file);
    m_indexFile = std::move(*indexed);
    m_indexer = std::make_unique<tlog::LogIndexer>(m_indexFile, tlog::linkEventsOf(path));
    m_indexer->endWhen(m_stopped);
    return true;
}

void ReplayWorker::fail(const Reason &why)
{
    m_link.phase = LinkPhase::Failed;
    m_link.problem = link::LinkError{link::LinkErrorCode::FileUnreadable, m_recording.path(), why}.reason();
}

void ReplayWorker::startOver()
{
    m_file.clear();
    m_file.seekg(0);
    m_flight = std::make_unique<ReplayedFlight>(m_file, [this](Event event) {
        if (!m_seek)
            publish(std::move(event));
    });
    m_flight->endWhen(m_stopped);
    m_flight->setInspecting(m_inspecting);
    m_flight->chooseFields(m_fields);
}

void ReplayWorker::runTasks()
{
    for (const Task &task : m_tasks.takeAll()) {
        if (std::holds_alternative<End>(task)) {
            delete std::exchange(m_timer, nullptr);
            m_output.put(Stopped{}); // synchronizes with the destructor of Replay in a way that ThreadSanitizer sees
            QThread::currentThread()->quit();
            return;
        }
        if (const auto *inspecting = std::get_if<Inspecting>(&task)) {
            m_inspecting = inspecting->on;
            if (m_flight)
                m_flight->setInspecting(m_inspecting);
        } else if (const auto *fields = std::get_if<ChosenFields>(&task)) {
            m_fields = fields->choices;
            if (m_flight)
                m_flight->chooseFields(m_fields);
        } else if (m_flight) {
            std::visit([this](const auto &command) { perform(command); }, std::get<ReplayCommand>(task));
        }
    }
    m_pace.markChanged();
    wake();
}

void ReplayWorker::perform(const PlayReplay &)
{
    m_clock.setPlaying(steadyNow(), !m_flight->isOver());
}

void ReplayWorker::perform(const PauseReplay &)
{
    m_clock.setPlaying(steadyNow(), false);
}

void ReplayWorker::perform(const SetReplaySpeed &command)
{
    m_clock.setSpeed(steadyNow(), command.factor);
}

void ReplayWorker::perform(const SeekReplay &command)
{
    m_seek = std::max(command.to, Duration::zero());
    ++m_seeks;
    if (*m_seek < m_flight->position())
        startOver();
    m_link.phase = LinkPhase::Connected;
}

void ReplayWorker::wake()
{
    if (!m_timer)
        return;
    const TimePoint now = steadyNow();
    bool arrived = true;
    if (m_clock.isPlaying() || m_seek)
        m_pace.markChanged();
    if (m_flight) {
        arrived = m_flight->advance(m_seek.value_or(m_clock.position(now)), kPortion);
        followFlight(now, arrived);
        readIndex();
    }
    if (m_pace.takeIfDue(now))
        publishSnapshot(now);
    if (!arrived || m_indexer)
        m_timer->start(0);
    else
        m_timer->start(std::chrono::ceil<std::chrono::milliseconds>(nextWake(now) - now));
}

/// Pictures are due as those of a station: two a second while the replay stands still.
TimePoint ReplayWorker::nextWake(TimePoint now) const
{
    const TimePoint next = now + (m_clock.isPlaying() ? kPlayEvery : SnapshotPace::kIdlePeriod);
    return std::max(now, std::min(next, m_pace.nextDeadline()));
}

/// Lets the clock follow a flight that did not arrive where the clock is, or is over.
void ReplayWorker::followFlight(TimePoint now, bool arrived)
{
    if (m_seek && !arrived)
        return;
    const bool sought = m_seek.has_value();
    m_seek.reset();
    if (sought)
        m_flown = std::make_shared<const FlownTracks>(m_flight->flown());
    if (sought || !arrived || m_flight->isOver())
        m_clock.setPosition(now, m_flight->position());
    if (const auto next = m_flight->afterSilence(); next && m_clock.isPlaying())
        m_clock.setPosition(now, *next);
    if (!m_flight->isOver() || m_link.phase == LinkPhase::Finished || m_link.phase == LinkPhase::Failed)
        return;
    m_clock.setPlaying(now, false);
    if (m_flight->isEmpty())
        fail(tlog::kNoFrame);
    else
        m_link.phase = LinkPhase::Finished;
    if (!sought)
        publish(LinkChanged{m_link});
}

void ReplayWorker::readIndex()
{
    if (!m_indexer || !m_indexer->read(kPortion))
        return;
    m_index = std::make_shared<const tlog::LogIndex>(m_indexer->take());
    m_indexer.reset();
    m_indexFile.close();
    m_pace.markChanged();
}

void ReplayWorker::publish(OutputQueue::Item item)
{
    if (m_output.put(std::move(item)))
        Q_EMIT outputReady();
}

ReplayStatus ReplayWorker::status(TimePoint now) const
{
    ReplayStatus out;
    out.position = m_seek.value_or(m_clock.position(now));
    out.speed = m_clock.speed();
    out.playing = m_clock.isPlaying();
    out.seeking = m_seek.has_value();
    out.ended = m_link.phase == LinkPhase::Finished;
    out.seeks = m_seeks;
    out.index = m_index;
    if (!m_seek)
        out.flown = m_flown;
    if (m_flight)
        out.time = m_flight->time();
    return out;
}

/// During a seek it shows the picture of before.
void ReplayWorker::publishSnapshot(TimePoint now)
{
    const bool waits = m_seek && m_last;
    const auto out = waits ? std::make_shared<Snapshot>(*m_last) : std::make_shared<Snapshot>();
    if (waits || !m_flight)
        out->links.assign(1, m_link);
    else
        m_flight->describe(*out, m_link);
    out->number = m_pace.takeNumber();
    out->time = seconds(now - m_start);
    out->replay = status(now);
    m_last = out;
    publish(SnapshotPtr(out));
}

} // namespace skyseal::engine

#include "moc_replay_worker.cpp"
