#include "fake_station.h"

#include "scripted_snapshots.h"

namespace skyseal::ui {

void FakeStation::show(const engine::Snapshot &snapshot)
{
    Q_EMIT snapshotReady(std::make_shared<const engine::Snapshot>(snapshot));
}

void FakeStation::showSealed(double time, const ChangeState &change)
{
    Q_EMIT snapshotReady(sealedView(time, change).snapshot);
}

void FakeStation::showTwoSealed(double time, const ChangeState &change, const ChangeState &changeSecond)
{
    engine::Snapshot snapshot = sealedSnapshot(time);
    snapshot.vehicles.push_back(snapshot.vehicles.front());
    vehicle::VehicleState &second = snapshot.vehicles.back().state;
    second.systemId = 2;
    if (change)
        change(snapshot.vehicles.front().state);
    if (changeSecond)
        changeSecond(second);
    show(snapshot);
}

void FakeStation::showPlain(double time)
{
    show(plainSnapshot(time));
}

void FakeStation::showWaiting()
{
    show(waitingSnapshot());
}

void FakeStation::showPendingApproval()
{
    show(pendingApprovalSnapshot());
}

void FakeStation::showReplay(const engine::Snapshot &snapshot)
{
    Q_EMIT replaySnapshotReady(std::make_shared<const engine::Snapshot>(snapshot));
}

} // namespace skyseal::ui

#include "moc_fake_station.cpp"
