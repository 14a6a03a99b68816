// Probes of a station: one for each request, none otherwise, never dropped; a station that publishes nothing else; and what
// watching costs the one that does.
#include "core/engine/station/output_queue.h"
#include "core/engine/station/snapshot.h"
#include "core/engine/station/snapshot_pace.h"
#include "tests/engine/ground.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;
using engine::SnapshotPace;
using engine::SnapshotPtr;

class ProbeTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void paceIsKept();
    void noSnapshotIsDueWithoutAPace();
    void readerThatIsBusyGetsEveryProbe();
    void oneProbeForEachRequest();
    void stationPublishesRequestedProbesOnly();
    void withoutDiagnosticsThereAreNoTimeLines();
    void costOfWatchingIsKnown();

private:
    static engine::StationConfig config(const FlightRig &rig) { return rig.stationConfig(); }
};

void ProbeTest::paceIsKept()
{
    SnapshotPace pace(10);
    TimePoint now{};
    int taken = 0;
    for (; now < TimePoint() + 10s; now += 1ms) {
        pace.markChanged();
        taken += pace.takeIfDue(now);
    }
    QCOMPARE(taken, 100);
    QVERIFY(pace.takeIfDue(now));
    QCOMPARE(pace.nextDeadline(), kNever); // nothing has changed since
    pace.markChanged();
    QVERIFY(pace.nextDeadline() == now + 100ms);
}

void ProbeTest::noSnapshotIsDueWithoutAPace()
{
    SnapshotPace pace(0);
    TimePoint now{};
    for (; now < TimePoint() + 10s; now += 1ms) {
        pace.markChanged();
        QVERIFY(!pace.takeIfDue(now));
        QCOMPARE(pace.nextDeadline(), kNever);
    }
    pace.setPerSecond(1);
    QVERIFY(pace.takeIfDue(now));
    pace.markChanged();
    QVERIFY(!pace.takeIfDue(now + 999ms));
    QVERIFY(pace.takeIfDue(now + 1s));
}

void ProbeTest::readerThatIsBusyGetsEveryProbe()
{
    engine::OutputQueue queue;
    for (int i = 0; i < 3; ++i) {
        queue.put(std::make_shared<engine::Snapshot>());
        queue.put(engine::Probed{std::make_shared<engine::Snapshot>()});
    }
    queue.put(std::make_shared<engine::Snapshot>());
    int probes = 0, snapshots = 0;
    for (const engine::OutputQueue::Item &item : queue.takeAll()) {
        probes += std::holds_alternative<engine::Probed>(item);
        snapshots += std::holds_alternative<SnapshotPtr>(item);
    }
    QCOMPARE(probes, 3);
    QCOMPARE(snapshots, 1);
}

void ProbeTest::oneProbeForEachRequest()
{
    FlightRig rig;
    Ground ground(config(rig));
    rig.startAgent(ground.ears->listening());
    VehicleOnUdp vehicle(rig.vehicleAddress());
    std::vector<SnapshotPtr> probes;
    connect(ground.station.get(), &engine::Station::probeTaken, this,
            [&](const SnapshotPtr &probe) { probes.push_back(probe); });
    EVENTUALLY(ground.up() && !ground.ears->snapshot->vehicles.empty());
    ground.station->setMeasuring(true);
    ground.station->requestProbe();
    EVENTUALLY_EQUAL(probes.size(), std::size_t(1));
    const std::uint64_t frames = probes[0]->mavlink.frames;
    EVENTUALLY(ground.ears->snapshot->mavlink.frames > frames + 20);
    QVERIFY(!ground.ears->snapshot->probe); // the window's snapshots go on without one
    ground.station->requestProbe();
    EVENTUALLY_EQUAL(probes.size(), std::size_t(2));
    const engine::Probe &begin = *probes[0]->probe, &end = *probes[1]->probe;
    QVERIFY(probes[1]->time > probes[0]->time && probes[1]->mavlink.frames > frames);
    QVERIFY(end.ioThreadCpu > begin.ioThreadCpu && end.processCpu > begin.processCpu);
    QVERIFY(end.open.count() > begin.open.count());
    QVERIFY(end.wakeUps > begin.wakeUps);
    QVERIFY(begin.residentBytes > 0);
    // The snapshots between the two, and the first probe itself, are known to have cost something, and not everything.
    QVERIFY(end.watchingCpu > begin.watchingCpu);
    QVERIFY(end.watchingCpu - begin.watchingCpu < end.ioThreadCpu - begin.ioThreadCpu);
}

void ProbeTest::stationPublishesRequestedProbesOnly()
{
    FlightRig rig;
    Ground ground(config(rig));
    rig.startAgent(ground.ears->listening());
    VehicleOnUdp vehicle(rig.vehicleAddress());
    EVENTUALLY(ground.up() && !ground.ears->snapshot->vehicles.empty());
    int snapshots = 0;
    SnapshotPtr probe;
    ground.station->setSnapshotsPerSecond(0);
    ground.station->requestProbe(); // behind it, nothing else is on its way
    connect(ground.station.get(), &engine::Station::probeTaken, this, [&](const SnapshotPtr &taken) { probe = taken; });
    EVENTUALLY(probe != nullptr);
    connect(ground.station.get(), &engine::Station::snapshotReady, this, [&] { ++snapshots; });
    const std::uint64_t number = probe->number, frames = probe->mavlink.frames;
    while (probe->mavlink.frames < frames + 100) {
        const SnapshotPtr before = probe;
        ground.station->requestProbe();
        EVENTUALLY(probe != before);
        QCOMPARE(probe->number, before->number + 1);
    }
    QVERIFY(probe->number > number);
    QCOMPARE(snapshots, 0);
    ground.station->setSnapshotsPerSecond(30);
    EVENTUALLY(snapshots > 0);
}

void ProbeTest::withoutDiagnosticsThereAreNoTimeLines()
{
    FlightRig rig;
    engine::StationConfig quiet = config(rig);
    quiet.diagnostics = false;
    Ground ground(quiet), usual(config(rig));
    // Both have lived for a second and more.
    EVENTUALLY(usual.ears->snapshot->samples.size() > 4);
    EVENTUALLY(ground.ears->snapshot->time > 1.5);
    QVERIFY(ground.ears->snapshot->samples.empty());
    QCOMPARE(ground.ears->snapshot->residentBytes, std::uint64_t(0));
}

/// With nobody measuring: the diagnostics state what they and the window's snapshots cost, more than nothing and less than
/// all.
void ProbeTest::costOfWatchingIsKnown()
{
    FlightRig rig;
    Ground ground(config(rig));
    rig.startAgent(ground.ears->listening());
    VehicleOnUdp vehicle(rig.vehicleAddress());
    EVENTUALLY(ground.up() && !ground.ears->snapshot->vehicles.empty());
    const auto isKnown = [&] {
        const auto &samples = ground.ears->snapshot->samples;
        return !samples.empty() && samples.back().watchingCpuPercent > 0
            && samples.back().watchingCpuPercent < samples.back().ioCpuPercent;
    };
    EVENTUALLY(isKnown());
    std::vector<SnapshotPtr> probes;
    connect(ground.station.get(), &engine::Station::probeTaken, this,
            [&](const SnapshotPtr &probe) { probes.push_back(probe); });
    ground.station->requestProbe();
    EVENTUALLY_EQUAL(probes.size(), std::size_t(1));
    EVENTUALLY(ground.ears->snapshot->time > probes[0]->time + 1);
    ground.station->requestProbe();
    EVENTUALLY_EQUAL(probes.size(), std::size_t(2));
    const engine::Probe &begin = *probes[0]->probe, &end = *probes[1]->probe;
    QVERIFY(end.watchingCpu > begin.watchingCpu);
    QVERIFY(end.watchingCpu - begin.watchingCpu < end.ioThreadCpu - begin.ioThreadCpu);
    // Each accepted frame is counted by its message.
    std::uint64_t frames = 0;
    for (const auto &[id, count] : end.messages)
        frames += count;
    QCOMPARE(frames, probes[1]->mavlink.frames);
    QVERIFY(end.messages.contains(0));
}

SKYSEAL_TEST(ProbeTest)
#include "probe_test.moc"
