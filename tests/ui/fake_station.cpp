#include "fake_station.h"

#include "scripted_snapshots.h"

namespace skyseal::ui {

void FakeStation::show(const engine::Snapshot &snapshot)
{
    Q_EMIT snapshotReady(std::make_shared<const engine::Snapshot>(snapshot));
}

void FakeStation::showSealed(double time)
{
    show(sealedSnapshot(time));
}

void FakeStation::showPlain(double time)
{
    show(plainSnapshot(time));
}

void FakeStation::showWaiting()
{
    show(waitingSnapshot());
}

void FakeStation::showReplay(const engine::Snapshot &snapshot)
{
    Q_EMIT replaySnapshotReady(std::make_shared<const engine::Snapshot>(snapshot));
}

} // namespace skyseal::ui
