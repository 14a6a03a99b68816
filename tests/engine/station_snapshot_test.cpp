// The building of a station's snapshot from its parts, each made here and fed by hand.
#include "core/engine/station/snapshot.h"
#include "core/engine/station/station_snapshot.h"
#include "core/mavlink/dialect.h"
#include "core/mavlink/frame_scanner.h"
#include "tests/support/addresses.h"
#include "tests/support/heartbeat.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;
using namespace skyseal::test;

namespace {

constexpr TimePoint kShownAt{std::chrono::seconds(100)};
constexpr LinkId kLink{1};
const Path kOtherPlace{kLink, {{9}, 9}};

struct Parts : private link::LinkListener
{
    SnapshotSources sources() { return {links, nullptr, datagrams, gate, fleet, sampler, nullptr}; }
    void heartbeat(std::uint8_t systemId)
    {
        const QByteArray bytes = clearHeartbeat(systemId, 1, false);
        const Bytes frame(bytes.begin(), bytes.end());
        mavlink::FrameScanner scanner(frame, mavlink::Dialect::builtin());
        fleet.take(kShownAt, {}, {kLink, {}}, *scanner.next()->frame, std::nullopt);
    }

    LinkPool links{*this, [](link::Link &) {}};
    DatagramCounters datagrams;
    FrameGate gate{SecureMode::Preferred};
    Fleet fleet{{}};
    MetricsSampler sampler;

private:
    void linkReceived(link::Link &, std::span<const link::ReceivedBlock>) override {}
};

} // namespace

class StationSnapshotTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void withoutAnythingItIsEmpty();
    void vehiclesAndTheirFramesAreCounted();
    void badFramesOfLinksAreThoseOfMavlink();
    void refusalsAreShown();
    void probeIsOnRequestOnly();
};

void StationSnapshotTest::withoutAnythingItIsEmpty()
{
    Parts parts;
    const auto snapshot = buildSnapshot(parts.sources(), kShownAt, false);
    QVERIFY(snapshot->links.empty() && snapshot->vehicles.empty() && snapshot->sessions.empty() && snapshot->samples.empty());
    QCOMPARE(snapshot->mavlink.frames, std::uint64_t(0));
    QVERIFY(!snapshot->channel.up && !snapshot->probe);
    QCOMPARE(int(snapshot->security), int(Security::Nothing));
}

void StationSnapshotTest::vehiclesAndTheirFramesAreCounted()
{
    Parts parts;
    for (const std::uint8_t systemId : {1, 2, 1})
        parts.heartbeat(systemId);
    const auto snapshot = buildSnapshot(parts.sources(), kShownAt, false);
    QCOMPARE(snapshot->vehicles.size(), std::size_t(2));
    QCOMPARE(snapshot->vehicles[1].state.systemId, std::uint8_t(2));
    QCOMPARE(snapshot->mavlink.frames, std::uint64_t(3));
    QCOMPARE(snapshot->clear.frames, std::uint64_t(3));
}

void StationSnapshotTest::badFramesOfLinksAreThoseOfMavlink()
{
    Parts parts;
    parts.links.open(kLink, urlOf("udpin:127.0.0.1:0"));
    parts.links.countBadFrame(kLink, 7);
    const auto snapshot = buildSnapshot(parts.sources(), kShownAt, false);
    QCOMPARE(snapshot->links.size(), std::size_t(1));
    QCOMPARE(snapshot->mavlink.badCrc, std::uint64_t(7));
    parts.links.remove(kLink); // its count stays
    QCOMPARE(mavlinkTotals(parts.sources()).badCrc, std::uint64_t(7));
}

void StationSnapshotTest::refusalsAreShown()
{
    Parts parts;
    parts.datagrams.garbage = 5;
    parts.gate.refuseClear(kOtherPlace, 1);
    parts.gate.refuseClear(kOtherPlace, 1);
    const auto snapshot = buildSnapshot(parts.sources(), kShownAt, false);
    QCOMPARE(snapshot->plaintextRefused, std::uint64_t(2));
    QCOMPARE(snapshot->channel.rx.plaintextDropped, std::uint64_t(2));
    QCOMPARE(snapshot->channel.rx.malformed, std::uint64_t(5));
}

void StationSnapshotTest::probeIsOnRequestOnly()
{
    Parts parts;
    parts.datagrams.waitingBytes = 300;
    parts.datagrams.waitingCount = 3;
    const auto snapshot = buildSnapshot(parts.sources(), kShownAt, true);
    QVERIFY(snapshot->probe);
    QCOMPARE(snapshot->probe->waitingBytes, std::uint64_t(300));
    QCOMPARE(snapshot->probe->waitingDatagrams, std::uint64_t(3));
    QVERIFY(snapshot->probe->residentBytes > 0);
}

SKYSEAL_TEST(StationSnapshotTest)
#include "station_snapshot_test.moc"
