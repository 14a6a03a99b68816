// The mission protocol with a vehicle: transfers over a link that loses a third of all frames, each error's result, and what
// a flown mission reports.
#include "tests/sim/item_exchange.h"
#include "tests/support/test_runner.h"

#include "core/mavlink/enums.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::sim;
using namespace skyseal::mavlink;
using namespace std::chrono_literals;

class SimMissionTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void uploadAndDownload_data();
    void uploadAndDownload();
    void oldProtocolInFloats();
    void errorsHaveTheirResults();
    void silentUploaderIsGivenUp();
    void lostAcknowledgementIsRepeated();
    void fliesAndReports();
};

namespace {

std::vector<mavlink::MissionItemInt> survey(int count)
{
    std::vector<mavlink::MissionItemInt> items;
    for (int i = 0; i < count; ++i) {
        mavlink::MissionItemInt item;
        item.target_system = 1;
        item.target_component = 1;
        item.seq = static_cast<std::uint16_t>(i);
        item.frame = MAV_FRAME_GLOBAL_RELATIVE_ALT_INT;
        item.command = i == 1 ? MAV_CMD_NAV_TAKEOFF : MAV_CMD_NAV_WAYPOINT;
        item.autocontinue = 1;
        item.param1 = static_cast<float>(i % 3);
        item.x = -353632610 + i * 1000;
        item.y = 1491652300 - i * 700;
        item.z = static_cast<float>(10 + i % 5);
        items.push_back(item);
    }
    return items;
}

} // namespace

void SimMissionTest::uploadAndDownload_data()
{
    QTest::addColumn<double>("loss");
    QTest::newRow("clean") << 0.0;
    QTest::newRow("a tenth lost") << 0.1;
    QTest::newRow("a third lost") << 0.33;
}

void SimMissionTest::uploadAndDownload()
{
    QFETCH(double, loss);
    TestStation station({}, loss, 11);
    station.run(6);
    const auto items = survey(40);
    QCOMPARE(Uploader(station, items).run(120), int(MAV_MISSION_ACCEPTED));
    const auto back = download(station);
    QCOMPARE(back.size(), items.size());
    for (std::size_t i = 1; i < items.size(); ++i) { // 0 is home
        QCOMPARE(back[i].x, items[i].x);
        QCOMPARE(back[i].y, items[i].y);
        QCOMPARE(back[i].z, items[i].z);
        QCOMPARE(back[i].command, items[i].command);
        QCOMPARE(back[i].param1, items[i].param1);
        QCOMPARE(int(back[i].target_system), 255);
    }
    QVERIFY(std::abs(back[0].x + 353632610) < 200);
}

void SimMissionTest::oldProtocolInFloats()
{
    TestStation station;
    station.writer.setVersion(1);
    station.run(6);
    MissionCount count;
    count.target_system = 1;
    count.count = 2;
    station.send(count);
    QCOMPARE(station.count<MissionRequest>(), std::size_t(1)); // asked in the old way
    mavlink::MissionItem item;
    item.target_system = 1;
    item.frame = MAV_FRAME_GLOBAL_RELATIVE_ALT;
    item.command = MAV_CMD_NAV_WAYPOINT;
    item.x = -35.36f;
    item.y = 149.16f;
    item.z = 20;
    station.send(item);
    QCOMPARE(int(station.last<MissionRequest>().seq), 1);
    item.seq = 1;
    station.send(item);
    QCOMPARE(int(station.last<MissionAck>().type), int(MAV_MISSION_ACCEPTED));
    MissionRequest request;
    request.target_system = 1;
    request.seq = 1;
    station.send(request);
    QCOMPARE(station.last<mavlink::MissionItem>().x, -35.36f);
    QCOMPARE(station.last<mavlink::MissionItem>().z, 20.f);
}

void SimMissionTest::errorsHaveTheirResults()
{
    TestStation station;
    station.run(6);
    const auto uploadOne = [&](const std::function<void(mavlink::MissionItemInt &)> &change) {
        auto items = survey(3);
        change(items[2]);
        return Uploader(station, items).run(3);
    };
    QCOMPARE(uploadOne([](auto &) {}), int(MAV_MISSION_ACCEPTED));
    QCOMPARE(uploadOne([](auto &item) { item.command = MAV_CMD_DO_DIGICAM_CONTROL; }), int(MAV_MISSION_UNSUPPORTED));
    QCOMPARE(uploadOne([](auto &item) { item.frame = MAV_FRAME_BODY_NED; }), int(MAV_MISSION_UNSUPPORTED_FRAME));
    QCOMPARE(uploadOne([](auto &item) { item.x = 950000000; }), int(MAV_MISSION_INVALID_PARAM5_X));
    QCOMPARE(uploadOne([](auto &item) { item.y = 1900000000; }), int(MAV_MISSION_INVALID_PARAM6_Y));
    QCOMPARE(uploadOne([](auto &item) { item.z = std::nanf(""); }), int(MAV_MISSION_INVALID_PARAM7));
    QCOMPARE(station.vehicle.autopilot().modes().mission().mission().size(), std::size_t(3)); // the good one stayed

    MissionCount count;
    count.target_system = 1;
    count.count = 60000;
    station.send(count);
    QCOMPARE(int(station.last<MissionAck>().type), int(MAV_MISSION_NO_SPACE));
    count.count = 3;
    count.mission_type = 3; // not a type that exists
    station.send(count);
    QCOMPARE(int(station.last<MissionAck>().type), int(MAV_MISSION_UNSUPPORTED));
    QCOMPARE(int(station.last<MissionAck>().mission_type), 3);

    count.mission_type = 0;
    station.send(count);
    auto items = survey(3);
    station.send(items[2]); // not the one that is wanted
    QCOMPARE(int(station.last<MissionAck>().type), int(MAV_MISSION_INVALID_SEQUENCE));
    TestStation *same = &station;
    same->writer = FrameWriter(200, 190); // a second station in between
    same->send(count);
    QCOMPARE(int(station.last<MissionAck>().type), int(MAV_MISSION_DENIED));
    QCOMPARE(int(station.last<MissionAck>().target_system), 200);
    same->writer = FrameWriter(255, 190);
    for (const auto &item : items)
        station.send(item);
    QCOMPARE(int(station.last<MissionAck>().type), int(MAV_MISSION_ACCEPTED));

    MissionRequestInt request;
    request.target_system = 1;
    request.seq = 3;
    station.send(request);
    QCOMPARE(int(station.last<MissionAck>().type), int(MAV_MISSION_INVALID_SEQUENCE));
    MissionClearAll clear;
    clear.target_system = 1;
    station.send(clear);
    QCOMPARE(int(station.last<MissionAck>().type), int(MAV_MISSION_ACCEPTED));
    QVERIFY(station.vehicle.autopilot().modes().mission().mission().empty());
}

void SimMissionTest::silentUploaderIsGivenUp()
{
    TestStation station;
    station.run(6);
    MissionCount count;
    count.target_system = 1;
    count.count = 5;
    station.send(count);
    station.run(7);
    QVERIFY(station.count<MissionRequestInt>() > 8); // asked again and again
    station.run(2);
    QCOMPARE(int(station.last<MissionAck>().type), int(MAV_MISSION_OPERATION_CANCELLED));
    QVERIFY(station.said("Mission upload timeout"));
    const auto asked = station.count<MissionRequestInt>();
    station.run(3);
    QCOMPARE(station.count<MissionRequestInt>(), asked);
}

void SimMissionTest::lostAcknowledgementIsRepeated()
{
    TestStation station;
    station.run(6);
    const auto items = survey(4);
    QCOMPARE(Uploader(station, items).run(5), int(MAV_MISSION_ACCEPTED));
    station.forget();
    station.send(items.back());
    QCOMPARE(int(station.last<MissionAck>().type), int(MAV_MISSION_ACCEPTED));
    QCOMPARE(station.vehicle.autopilot().modes().mission().mission().size(), std::size_t(4));
}

void SimMissionTest::fliesAndReports()
{
    SimulatedVehicleConfig config;
    config.rate = 4;
    TestStation station(config);
    station.run(3);
    auto items = survey(5);
    for (auto &item : items)
        item.param1 = 0;
    items[4].command = MAV_CMD_NAV_RETURN_TO_LAUNCH;
    QCOMPARE(Uploader(station, items).run(5), int(MAV_MISSION_ACCEPTED));
    QCOMPARE(station.command(MAV_CMD_DO_SET_MODE, {1, 4}), int(MAV_RESULT_ACCEPTED));
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}), int(MAV_RESULT_ACCEPTED));
    QCOMPARE(station.command(MAV_CMD_MISSION_START), int(MAV_RESULT_ACCEPTED));
    QVERIFY(station.until([&] { return station.vehicle.autopilot().armed() == false; }, 60));
    station.run(1);
    std::vector<int> reached;
    for (const auto &message : station.all<MissionItemReached>())
        reached.push_back(message.seq);
    QCOMPARE(reached, (std::vector<int>{1, 2, 3, 4}));
    QVERIFY(station.said("Reached command #2"));
    QCOMPARE(int(station.last<MissionCurrent>().total), 4);
    MissionSetCurrent again;
    again.target_system = 1;
    again.seq = 2;
    station.send(again);
    QCOMPARE(int(station.last<MissionCurrent>().seq), 2);
}

SKYSEAL_TEST_APPLESS(SimMissionTest)
#include "mission_test.moc"
