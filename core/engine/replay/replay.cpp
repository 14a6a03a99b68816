#include "core/engine/replay/replay.h"

#include "core/engine/replay/replay_worker.h"

#include <QtCore/QThread>

namespace skyseal::engine {

struct Replay::Private
{
    QThread thread;
    std::unique_ptr<ReplayWorker> worker; ///< used on its own thread until that has ended
};

Replay::Replay(const link::LinkUrl &recording) : d(std::make_unique<Private>())
{
    qRegisterMetaType<std::shared_ptr<const Snapshot>>();
    qRegisterMetaType<Event>();
    d->worker = std::make_unique<ReplayWorker>(recording);
    ReplayWorker *worker = d->worker.get();
    worker->moveToThread(&d->thread);
    connect(worker, &ReplayWorker::outputReady, this, [this, worker] {
        for (const OutputQueue::Item &item : worker->takeOutput()) {
            if (const auto *snapshot = std::get_if<SnapshotPtr>(&item))
                Q_EMIT snapshotReady(*snapshot);
            else if (const auto *event = std::get_if<Event>(&item))
                Q_EMIT eventOccurred(*event);
        }
    });
    connect(&d->thread, &QThread::started, worker, &ReplayWorker::begin);
    d->thread.setObjectName(QStringLiteral("skyseal-replay"));
    d->thread.start();
}

Replay::~Replay()
{
    d->worker->stop();
    d->worker->post(ReplayWorker::End{});
    d->thread.wait();
    d->worker->takeOutput();
}

void Replay::perform(const ReplayCommand &command)
{
    d->worker->post(command);
}

void Replay::setInspecting(bool inspecting)
{
    d->worker->post(ReplayWorker::Inspecting{inspecting});
}

void Replay::chooseFields(std::vector<FieldChoice> choices)
{
    d->worker->post(ReplayWorker::ChosenFields{std::move(choices)});
}

} // namespace skyseal::engine

#include "moc_replay.cpp"
