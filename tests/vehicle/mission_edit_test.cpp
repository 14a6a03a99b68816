// A further waypoint of a mission: where it is put, at which altitude, and what becomes of the items after it.
#include "core/vehicle/mission_edit.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::vehicle;

namespace {

MissionItem item(std::uint16_t command, float altitude = 0, std::uint8_t frame = mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT)
{
    return {.command = command, .frame = frame, .altitude = altitude};
}

std::vector<std::uint16_t> commandsOf(const std::vector<MissionItem> &items)
{
    std::vector<std::uint16_t> out;
    for (const MissionItem &each : items)
        out.push_back(each.command);
    return out;
}

constexpr std::uint16_t kWaypoint = mavlink::MAV_CMD_NAV_WAYPOINT, kReturn = mavlink::MAV_CMD_NAV_RETURN_TO_LAUNCH,
                        kTakeOff = mavlink::MAV_CMD_NAV_TAKEOFF, kJump = mavlink::MAV_CMD_DO_JUMP;

} // namespace

class MissionEditTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void waypointIsPutBeforeTheEnd_data()
    {
        using Commands = std::vector<std::uint16_t>;
        QTest::addColumn<Commands>("before");
        QTest::addColumn<Commands>("after");
        QTest::newRow("no item") << Commands{} << Commands{kWaypoint};
        QTest::newRow("home alone") << Commands{kWaypoint} << Commands{kWaypoint, kWaypoint};
        QTest::newRow("no end") << Commands{kWaypoint, kTakeOff} << Commands{kWaypoint, kTakeOff, kWaypoint};
        QTest::newRow("return") << Commands{kTakeOff, kReturn} << Commands{kTakeOff, kWaypoint, kReturn};
        QTest::newRow("landing") << Commands{kTakeOff, mavlink::MAV_CMD_NAV_LAND}
                                 << Commands{kTakeOff, kWaypoint, mavlink::MAV_CMD_NAV_LAND};
        QTest::newRow("return in between") << Commands{kReturn, kTakeOff} << Commands{kReturn, kTakeOff, kWaypoint};
    }

    void waypointIsPutBeforeTheEnd()
    {
        QFETCH(std::vector<std::uint16_t>, before);
        QFETCH(std::vector<std::uint16_t>, after);
        std::vector<MissionItem> items;
        for (const std::uint16_t command : before)
            items.push_back(item(command));
        const std::size_t place = placeOfNextWaypoint(items);
        const std::vector<MissionItem> made = withWaypoint(items, 47.5, 8.5, 25, std::nullopt);
        QCOMPARE(commandsOf(made), after);
        QCOMPARE(made[place].latitude, 47.5);
        QCOMPARE(made[place].longitude, 8.5);
        QCOMPARE(made[place].altitude, 25.0f);
        QCOMPARE(made[place].frame, std::uint8_t(mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT));
        for (std::size_t i = 0; i < made.size(); ++i)
            QCOMPARE(made[i].sequence, std::uint16_t(i));
    }

    /// ArduPilot overwrites item 0: a mission of one item would be lost.
    void homeComesFirst()
    {
        const MissionItem home = item(kWaypoint, 408, mavlink::MAV_FRAME_GLOBAL);
        const std::vector<MissionItem> made = withWaypoint({}, 47.5, 8.5, 25, home);
        QCOMPARE(made.size(), std::size_t(2));
        QCOMPARE(made[0], home);
        QCOMPARE(made[1].altitude, 25.0f);
        QCOMPARE(withWaypoint({home}, 47.5, 8.5, 25, home).size(), std::size_t(2)); // it is there already
    }

    void jumpsLeadToTheSameItems()
    {
        std::vector<MissionItem> items{item(kWaypoint), item(kTakeOff), item(kJump), item(kJump), item(kReturn)};
        items[2].parameters[0] = 1;
        items[3].parameters[0] = 4;
        const std::vector<MissionItem> made = withWaypoint(items, 47.5, 8.5, 25, std::nullopt);
        QCOMPARE(made[2].parameters[0], 1.0f);
        QCOMPARE(made[3].parameters[0], 5.0f);
        QCOMPARE(made[5].command, kReturn);
    }

    void altitudeIsThatOfTheItemsBefore()
    {
        QVERIFY(!altitudeBeforeNextWaypoint({}));
        QVERIFY(!altitudeBeforeNextWaypoint({item(kWaypoint, 408, mavlink::MAV_FRAME_GLOBAL)}));
        const std::vector<MissionItem> items{item(kTakeOff, 20), item(kWaypoint, 35),
                                             item(kWaypoint, 600, mavlink::MAV_FRAME_GLOBAL), item(kReturn, 50)};
        QCOMPARE(altitudeBeforeNextWaypoint(items), std::optional(35.0f));
    }
};

SKYSEAL_TEST(MissionEditTest)
#include "mission_edit_test.moc"
