// Transfer of the three lists of items (flight plan, fence, rally points): over a link that loses frames, at the same
// time, with damaged items, and over a reboot.
#include "tests/sim/some_items.h"
#include "tests/support/test_runner.h"

#include "core/mavlink/enums.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::sim;
using namespace skyseal::mavlink;

class SimItemListsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void transfersOfAllTypes_data();
    void transfersOfAllTypes();
    void transfersAtTheSameTime();
    void fenceErrors_data();
    void fenceErrors();
    void rallyErrors();
    void clears();
    void listsSurviveAReboot();
    void oldProtocolInFloats();
};

void SimItemListsTest::transfersOfAllTypes_data()
{
    QTest::addColumn<int>("type");
    QTest::addColumn<double>("loss");
    for (const double loss : {0.0, 0.33}) {
        for (int type = 0; type < 3; ++type)
            QTest::addRow("type %d, loss %g", type, loss) << type << loss;
    }
}

void SimItemListsTest::transfersOfAllTypes()
{
    QFETCH(int, type);
    QFETCH(double, loss);
    TestStation station({}, loss, 5);
    station.run(6);
    for (std::uint8_t other = 0; other < 3; ++other) { // what the others have must stay
        if (other != type)
            QCOMPARE(Uploader(station, some(other), other).run(60), int(MAV_MISSION_ACCEPTED));
    }
    const auto wanted = static_cast<std::uint8_t>(type);
    const auto items = some(wanted);
    QCOMPARE(Uploader(station, items, wanted).run(60), int(MAV_MISSION_ACCEPTED));
    const auto back = download(station, wanted);
    QCOMPARE(back.size(), items.size());
    for (std::size_t i = type == 0 ? 1 : 0; i < items.size(); ++i) {
        QCOMPARE(back[i].command, items[i].command);
        QCOMPARE(back[i].x, items[i].x);
        QCOMPARE(back[i].y, items[i].y);
        QCOMPARE(back[i].z, items[i].z);
        QCOMPARE(back[i].param1, items[i].param1);
        QCOMPARE(back[i].frame, items[i].frame);
        QCOMPARE(int(back[i].mission_type), type);
        QCOMPARE(int(back[i].current), 0);
    }
    QCOMPARE(parameter(station, "MIS_TOTAL"), 5.f);
    QCOMPARE(parameter(station, "FENCE_TOTAL"), 6.f);
    QCOMPARE(parameter(station, "RALLY_TOTAL"), 2.f);
    QCOMPARE(download(station, 0).size(), std::size_t(5));
}

void SimItemListsTest::transfersAtTheSameTime()
{
    TestStation station;
    station.run(6);
    MissionCount count;
    count.target_system = 1;
    for (std::uint8_t type = 0; type < 3; ++type) {
        count.mission_type = type;
        count.count = static_cast<std::uint16_t>(some(type).size());
        station.send(count);
        QCOMPARE(int(station.last<MissionRequestInt>().mission_type), int(type));
    }
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::uint8_t type = 0; type < 3; ++type) {
            if (i < some(type).size())
                station.send(some(type)[i]);
        }
    }
    const auto acks = station.all<MissionAck>();
    QCOMPARE(acks.size(), std::size_t(3));
    for (const auto &ack : acks)
        QCOMPARE(int(ack.type), int(MAV_MISSION_ACCEPTED));
    QVERIFY(acks[0].mission_type == 2 && acks[1].mission_type == 0 && acks[2].mission_type == 1); // the shortest first
    QVERIFY(station.said("Flight plan received"));
    QVERIFY(station.said("Rally points received"));
}

void SimItemListsTest::fenceErrors_data()
{
    QTest::addColumn<int>("index");
    QTest::addColumn<int>("command");
    QTest::addColumn<float>("size");
    QTest::addColumn<int>("frame");
    QTest::addColumn<int>("latitude");
    QTest::addColumn<int>("result");
    const int same = -1, fine = kLatitude, global = MAV_FRAME_GLOBAL;
    const float four = 4;
    QTest::newRow("as it is") << 0 << same << four << global << kLatitude << int(MAV_MISSION_ACCEPTED);
    QTest::newRow("no fence") << 0 << int(MAV_CMD_NAV_WAYPOINT) << four << global << fine << int(MAV_MISSION_UNSUPPORTED);
    QTest::newRow("rally") << 2 << int(MAV_CMD_NAV_RALLY_POINT) << four << global << fine << int(MAV_MISSION_UNSUPPORTED);
    QTest::newRow("frame") << 1 << same << four << int(MAV_FRAME_BODY_NED) << fine << int(MAV_MISSION_UNSUPPORTED_FRAME);
    QTest::newRow("two corners") << 0 << same << 2.f << global << fine << int(MAV_MISSION_ERROR);
    QTest::newRow("another count") << 2 << same << 5.f << global << fine << int(MAV_MISSION_ERROR);
    QTest::newRow("count is not a number") << 0 << same << std::nanf("") << global << fine << int(MAV_MISSION_ERROR);
    QTest::newRow("too many corners") << 0 << same << 1e9f << global << fine << int(MAV_MISSION_ERROR);
    QTest::newRow("other kind within") << 1 << int(MAV_CMD_NAV_FENCE_POLYGON_VERTEX_EXCLUSION) << four << global << fine
                                       << int(MAV_MISSION_ERROR);
    QTest::newRow("circle within") << 3 << int(MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION) << four << global << fine
                                   << int(MAV_MISSION_ERROR);
    QTest::newRow("no radius") << 4 << same << 0.f << global << fine << int(MAV_MISSION_ERROR);
    QTest::newRow("infinite radius") << 4 << same << std::numeric_limits<float>::infinity() << global << fine
                                     << int(MAV_MISSION_ERROR);
    QTest::newRow("cut polygon") << 5 << int(MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION) << four << global << fine
                                 << int(MAV_MISSION_ERROR);
    QTest::newRow("two return points") << 4 << int(MAV_CMD_NAV_FENCE_RETURN_POINT) << 0.f << global << fine
                                       << int(MAV_MISSION_ERROR);
    QTest::newRow("beyond the pole") << 4 << same << 20.f << global << 910000000 << int(MAV_MISSION_ERROR);
}

void SimItemListsTest::fenceErrors()
{
    QFETCH(int, index);
    QFETCH(int, command);
    QFETCH(float, size);
    QFETCH(int, frame);
    QFETCH(int, latitude);
    QFETCH(int, result);
    TestStation station;
    station.run(6);
    const auto before = numbered({itemAt(MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION, 70, 0, 0)}, MAV_MISSION_TYPE_FENCE);
    QCOMPARE(Uploader(station, before, 1).run(5), int(MAV_MISSION_ACCEPTED));
    auto items = someFence();
    auto &item = items[static_cast<std::size_t>(index)];
    if (command >= 0)
        item.command = static_cast<std::uint16_t>(command);
    item.param1 = size;
    item.frame = static_cast<std::uint8_t>(frame);
    item.x = latitude;
    QCOMPARE(Uploader(station, items, 1).run(5), result);
    const bool taken = result == MAV_MISSION_ACCEPTED;
    QCOMPARE(station.vehicle.autopilot().flight().fence.areas().items().size(), taken ? items.size() : before.size());
    QCOMPARE(parameter(station, "FENCE_TOTAL"), taken ? 6.f : 1.f);
}

void SimItemListsTest::rallyErrors()
{
    TestStation station;
    station.run(6);
    const auto upload = [&](const std::function<void(mavlink::MissionItemInt &)> &change) {
        auto items = someRallyPoints();
        change(items[1]);
        return Uploader(station, items, 2).run(5);
    };
    QCOMPARE(upload([](auto &) {}), int(MAV_MISSION_ACCEPTED));
    QCOMPARE(upload([](auto &item) { item.command = MAV_CMD_NAV_WAYPOINT; }), int(MAV_MISSION_UNSUPPORTED));
    QCOMPARE(upload([](auto &item) { item.frame = MAV_FRAME_GLOBAL; }), int(MAV_MISSION_UNSUPPORTED_FRAME));
    QCOMPARE(upload([](auto &item) { item.x = 910000000; }), int(MAV_MISSION_INVALID_PARAM5_X));
    QCOMPARE(upload([](auto &item) { item.y = -1810000000; }), int(MAV_MISSION_INVALID_PARAM6_Y));
    QCOMPARE(upload([](auto &item) { item.z = std::nanf(""); }), int(MAV_MISSION_INVALID_PARAM7));
    QCOMPARE(parameter(station, "RALLY_TOTAL"), 2.f);
    MissionCount count;
    count.target_system = 1;
    count.mission_type = MAV_MISSION_TYPE_RALLY;
    count.count = RallyPoints::kMostItems + 1;
    station.send(count);
    QCOMPARE(int(station.last<MissionAck>().type), int(MAV_MISSION_NO_SPACE));
    QVERIFY(station.said("Only 50 items are supported"));
}

void SimItemListsTest::clears()
{
    TestStation station;
    station.run(6);
    const auto sizes = [&] {
        const Autopilot &a = station.vehicle.autopilot();
        return std::array{a.modes().mission().mission().size(), a.flight().fence.areas().items().size(),
                          a.flight().rallyPoints.items().size()};
    };
    for (std::uint8_t type = 0; type < 3; ++type)
        QCOMPARE(Uploader(station, some(type), type).run(5), int(MAV_MISSION_ACCEPTED));
    const auto clear = [&](std::uint8_t type) {
        MissionClearAll all;
        all.target_system = 1;
        all.mission_type = type;
        station.send(all);
        return station.last<MissionAck>().mission_type == type ? int(station.last<MissionAck>().type) : -1;
    };
    QCOMPARE(clear(MAV_MISSION_TYPE_FENCE), int(MAV_MISSION_ACCEPTED));
    QVERIFY((sizes() == std::array<std::size_t, 3>{5, 0, 2}));
    QCOMPARE(clear(77), int(MAV_MISSION_UNSUPPORTED));
    MissionCount none; // a count of nothing clears, too
    none.target_system = 1;
    none.mission_type = MAV_MISSION_TYPE_RALLY;
    station.send(none);
    QVERIFY((sizes() == std::array<std::size_t, 3>{5, 0, 0}));
    QCOMPARE(Uploader(station, some(1), 1).run(5), int(MAV_MISSION_ACCEPTED));
    QCOMPARE(clear(MAV_MISSION_TYPE_ALL), int(MAV_MISSION_ACCEPTED));
    QVERIFY((sizes() == std::array<std::size_t, 3>{0, 0, 0}));
    QCOMPARE(parameter(station, "FENCE_TOTAL"), 0.f);
    QCOMPARE(download(station, 1).size(), std::size_t(0));
    QCOMPARE(station.count<MissionCount>(), std::size_t(1)); // it says that there is nothing
    MissionRequestInt request;
    request.target_system = 1;
    request.mission_type = MAV_MISSION_TYPE_FENCE;
    station.send(request);
    QCOMPARE(int(station.last<MissionAck>().type), int(MAV_MISSION_INVALID_SEQUENCE));
    QCOMPARE(int(station.last<MissionAck>().mission_type), int(MAV_MISSION_TYPE_FENCE));
}

void SimItemListsTest::listsSurviveAReboot()
{
    TestStation station;
    station.run(6);
    for (std::uint8_t type = 0; type < 3; ++type)
        QCOMPARE(Uploader(station, some(type), type).run(5), int(MAV_MISSION_ACCEPTED));
    QCOMPARE(station.command(MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, {1}), int(MAV_RESULT_ACCEPTED));
    station.run(2);
    QVERIFY(station.vehicle.autopilot().time() < 3'000'000);
    for (std::uint8_t type = 0; type < 3; ++type)
        QCOMPARE(download(station, type).size(), some(type).size());
    QCOMPARE(parameter(station, "FENCE_TOTAL"), 6.f);
}

void SimItemListsTest::oldProtocolInFloats()
{
    TestStation station;
    station.run(6);
    QCOMPARE(Uploader(station, someRallyPoints(), 2).run(5), int(MAV_MISSION_ACCEPTED));
    MissionRequest request;
    request.target_system = 1;
    request.seq = 1;
    request.mission_type = MAV_MISSION_TYPE_RALLY;
    station.send(request);
    const auto item = station.last<mavlink::MissionItem>();
    QVERIFY(std::abs(item.x - static_cast<float>(someRallyPoints()[1].x * 1e-7)) < 1e-5f);
    mavlink::MissionItem again = item; // and in the other direction
    again.target_system = 1;
    again.target_component = 1;
    again.seq = 0;
    station.forget();
    MissionCount count;
    count.target_system = 1;
    count.count = 1;
    count.mission_type = MAV_MISSION_TYPE_RALLY;
    station.send(count);
    station.send(again);
    QCOMPARE(int(station.last<MissionAck>().type), int(MAV_MISSION_ACCEPTED));
    QVERIFY(std::abs(station.vehicle.autopilot().flight().rallyPoints.items()[0].x - someRallyPoints()[1].x) < 100);
}

SKYSEAL_TEST_APPLESS(SimItemListsTest)
#include "item_lists_test.moc"
