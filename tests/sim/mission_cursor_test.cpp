// The place in a mission: items one after the other, jumps, and the end.
#include "core/sim/mission_cursor.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::sim;

namespace {

StoredItem waypoint()
{
    StoredItem out;
    out.command = mavlink::MAV_CMD_NAV_WAYPOINT;
    return out;
}

StoredItem jump(float target, float times)
{
    StoredItem out;
    out.command = mavlink::MAV_CMD_DO_JUMP;
    out.parameters = {target, times};
    return out;
}

/// The items that are flown from item 1 to the end, at most `most`.
QList<int> flown(MissionCursor &cursor, int most = 20)
{
    QList<int> out;
    while (out.size() < most && cursor.moveToItem(1)) {
        if (cursor.item().command == mavlink::MAV_CMD_DO_JUMP) {
            cursor.jump();
            continue;
        }
        cursor.enter();
        out << cursor.current();
        cursor.complete();
    }
    return out;
}

} // namespace

class MissionCursorTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void itemsFollow();
    void jumpsAreCounted();
    void jumpsToNowhereArePassed();
    void missionStartsAnew();
};

void MissionCursorTest::itemsFollow()
{
    MissionCursor cursor;
    QVERIFY(!cursor.moveToItem(1));
    QVERIFY(cursor.isFinished());
    cursor.load({waypoint(), waypoint(), waypoint()});
    QVERIFY(!cursor.isFinished());
    QCOMPARE(flown(cursor), (QList<int>{1, 2}));
    QVERIFY(cursor.isFinished());
    QCOMPARE(int(cursor.current()), 2);
    QCOMPARE(cursor.takeReached(), std::optional<std::uint16_t>(2));
    QVERIFY(!cursor.takeReached());
}

void MissionCursorTest::jumpsAreCounted()
{
    MissionCursor cursor;
    cursor.load({waypoint(), waypoint(), jump(1, 2), waypoint()});
    QCOMPARE(flown(cursor), (QList<int>{1, 1, 1, 3}));
    cursor.load({waypoint(), waypoint(), jump(1, -1), waypoint()});
    QCOMPARE(flown(cursor), QList<int>(20, 1));
}

void MissionCursorTest::jumpsToNowhereArePassed()
{
    MissionCursor cursor;
    for (const float target : {0.f, -5.f, 4.f, 1e9f, std::numeric_limits<float>::quiet_NaN()}) {
        cursor.load({waypoint(), waypoint(), jump(target, 3), waypoint()});
        QCOMPARE(flown(cursor), (QList<int>{1, 3}));
    }
}

void MissionCursorTest::missionStartsAnew()
{
    MissionCursor cursor;
    cursor.load({waypoint(), waypoint(), waypoint()});
    QVERIFY(!cursor.setCurrent(3));
    QVERIFY(cursor.setCurrent(2));
    cursor.enter();
    cursor.resume(); // goes on with the same item
    QVERIFY(!cursor.isEntered());
    QCOMPARE(flown(cursor), (QList<int>{2}));
    cursor.resume();
    QCOMPARE(flown(cursor), (QList<int>{1, 2}));
}

SKYSEAL_TEST_APPLESS(MissionCursorTest)
#include "mission_cursor_test.moc"
