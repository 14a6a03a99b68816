// Sessions and the vehicles heard over them: the state of a vehicle when its session ends and when its agent returns.
#include "core/engine/station/vehicle_watches.h"

#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;

namespace {

constexpr channel::SessionId kOld{1}, kNew{2}, kThird{3};
constexpr TimePoint kBegin{std::chrono::seconds(100)};

channel::SessionUp up(channel::SessionId session, std::uint8_t key)
{
    channel::SessionUp out;
    out.session = session;
    out.peer[0] = key;
    out.peerName = "agent-" + std::to_string(key);
    return out;
}

channel::SessionDown down(channel::SessionId session)
{
    channel::SessionDown out;
    out.session = session;
    out.reason = channel::DownReason::TimedOut;
    return out;
}

/// Both kinds of watches, wired as the station does it.
struct Watches
{
    void begin(const channel::SessionUp &event)
    {
        sessions.sessionUp(event);
        vehicles.sessionUp(event);
    }
    void end(channel::SessionId session)
    {
        if (const auto ended = sessions.sessionDown(kBegin, down(session)))
            vehicles.sessionDown(session, *ended);
    }
    VehicleSnapshot vehicle(std::uint8_t systemId) const
    {
        VehicleSnapshot out;
        vehicles.describe(kBegin + std::chrono::seconds(2), systemId, out);
        return out;
    }

    SessionWatches sessions;
    VehicleWatches vehicles;
};

} // namespace

class WatchesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void endedSessionIsShown();
    void vehicleMovesToTheSuccessor();
    void returningAgentTakesItsVehicleBack();
    void attackersRecordsOfTheLastMinute();
    void lostAndBack();
};

void WatchesTest::endedSessionIsShown()
{
    Watches watches;
    watches.begin(up(kOld, 1));
    watches.vehicles.heard(5, {LinkId{1}, {}}, kOld);
    watches.vehicles.heard(6, {LinkId{1}, {}}, std::nullopt);
    QVERIFY(watches.vehicles.isOrWasSealed(5) && !watches.vehicles.isOrWasSealed(6));
    watches.end(kOld);
    const VehicleSnapshot shown = watches.vehicle(5);
    QVERIFY(shown.ended && shown.session == kOld);
    QCOMPARE(shown.ended->peerName, std::string("agent-1"));
    QCOMPARE(int(shown.ended->reason), int(channel::DownReason::TimedOut));
    QCOMPARE(shown.ended->age, 2.0);
    QVERIFY(watches.vehicles.isEnded(5) && watches.vehicles.isOrWasSealed(5));
    QVERIFY(!watches.vehicle(6).ended);
    watches.vehicles.heard(5, {LinkId{2}, {}}, std::nullopt);
    QVERIFY(!watches.vehicles.isEnded(5) && !watches.vehicles.isOrWasSealed(5));
}

void WatchesTest::vehicleMovesToTheSuccessor()
{
    Watches watches;
    watches.begin(up(kOld, 1));
    watches.begin(up(kThird, 2));
    watches.vehicles.heard(5, {LinkId{1}, {}}, kOld);
    watches.begin(up(kNew, 1));
    watches.end(kOld);
    QVERIFY(watches.vehicle(5).session == kNew && !watches.vehicle(5).ended);
}

void WatchesTest::returningAgentTakesItsVehicleBack()
{
    Watches watches;
    watches.begin(up(kOld, 1));
    watches.vehicles.heard(5, {LinkId{1}, {}}, kOld);
    watches.end(kOld);
    watches.begin(up(kThird, 2));
    QVERIFY(watches.vehicles.isEnded(5)); // another agent
    watches.begin(up(kNew, 1));
    QVERIFY(!watches.vehicles.isEnded(5));
    QVERIFY(watches.vehicle(5).session == kNew);
}

void WatchesTest::attackersRecordsOfTheLastMinute()
{
    Watches watches;
    watches.begin(up(kOld, 1));
    channel::SessionStats stats;
    for (int second = 0; second <= 10; ++second) {
        stats.rx.good += 20;
        stats.rx.forged += second == 5 ? 3 : 0;
        watches.sessions.noteSecond(kOld, stats);
    }
    SessionSnapshot shown;
    watches.sessions.describe(kOld, shown);
    QCOMPARE(shown.forgedLastMinute, std::uint64_t(3));
    QCOMPARE(shown.goodLastMinute, std::uint64_t(200));
    QVERIFY(isAttacked(shown));
    for (int second = 0; second < 60; ++second)
        watches.sessions.noteSecond(kOld, stats);
    watches.sessions.describe(kOld, shown);
    QVERIFY(!isAttacked(shown));
}

void WatchesTest::lostAndBack()
{
    Watches watches;
    watches.vehicles.heard(5, {LinkId{1}, {}}, std::nullopt);
    metrics::SequenceCounts counts;
    QCOMPARE(int(watches.vehicles.sample(5, counts, false)), int(Presence::Unchanged));
    counts.received = 30;
    counts.lost = 10;
    QCOMPARE(int(watches.vehicles.sample(5, counts, true)), int(Presence::Lost));
    QCOMPARE(int(watches.vehicles.sample(5, counts, true)), int(Presence::Unchanged));
    QCOMPARE(int(watches.vehicles.sample(5, counts, false)), int(Presence::Back));
    QCOMPARE(watches.vehicle(5).lossPercent, 25.0);
    QCOMPARE(watches.vehicle(5).framesPerSecond, 30.0);
}

SKYSEAL_TEST(WatchesTest)
#include "watches_test.moc"
