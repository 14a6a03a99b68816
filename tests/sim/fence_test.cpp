// Fence and rally points in flight: which places they allow, what a station is told about the fence, and what the vehicle does
// when it crosses it.
#include "tests/sim/some_items.h"
#include "tests/support/test_runner.h"

#include "core/mavlink/enums.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::sim;
using namespace skyseal::mavlink;

class SimFenceTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void areas();
    void tellsThatThereIsNoBreach();
    void tellsCapabilities();
    void breachOfRadiusReturns();
    void breachActions_data();
    void breachActions();
    void breachOfPolygonIsReported();
    void floorIsWatchedUntilDisabled();
    void pilotMayComeBack();
    void refusesDestinationsOutside();
    void outsideIsNotArmed();
    void returnsToARallyPoint();
    void farRallyPointIsNotUsed();
};

namespace {

/// Holds the stick forward, the nose in the north.
void flyNorth(TestStation &station)
{
    ManualControl sticks;
    sticks.target = 1;
    sticks.x = 700;
    sticks.z = 500;
    station.send(sticks);
}

} // namespace

void SimFenceTest::areas()
{
    const GeoFrame world({kLatitude * 1e-7, kLongitude * 1e-7, 584});
    const auto stored = [](const std::vector<mavlink::MissionItemInt> &items) {
        std::vector<StoredItem> out;
        for (const auto &item : items)
            out.push_back({item.frame, item.command, true, {item.param1, 0, 0, 0}, item.x, item.y, item.z});
        return out;
    };
    FenceAreas areas;
    QVERIFY(areas.allow({1e6, 0, 0})); // nothing forbids
    QVERIFY(!areas.load(stored(someFence()), world));
    QVERIFY(areas.allow({0, 0, 0}));
    QVERIFY(areas.allow({199, -199, 0}));
    QVERIFY(!areas.allow({201, 0, 0}));
    QVERIFY(!areas.allow({0, -201, 0}));
    QVERIFY(!areas.allow({100, 19, 0}));
    QVERIFY(areas.allow({100, 21, 0}));

    // A notch makes a polygon concave: within its hull and yet outside.
    const std::uint16_t in = MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION;
    const std::vector<mavlink::MissionItemInt> notched{itemAt(in, 5, 100, -100), itemAt(in, 5, 0, 0), itemAt(in, 5, 100, 100),
                                                       itemAt(in, 5, -100, 100), itemAt(in, 5, -100, -100)};
    QVERIFY(!areas.load(stored(notched), world));
    QVERIFY(!areas.allow({50, 0, 0}));
    QVERIFY(areas.allow({-50, 0, 0}));
    QVERIFY(areas.allow({50, 80, 0}));

    auto cut = notched;
    cut.pop_back();
    QCOMPARE(areas.load(stored(cut), world), std::optional<std::string>("Fence: the last polygon misses 1 vertices"));
    QCOMPARE(areas.items().size(), notched.size());
}

void SimFenceTest::tellsThatThereIsNoBreach()
{
    TestStation station;
    station.run(6);
    auto status = station.last<SysStatus>();
    QVERIFY(status.onboard_control_sensors_present & MAV_SYS_STATUS_GEOFENCE); // FENCE_TYPE has limits that need no upload
    QVERIFY(!(status.onboard_control_sensors_enabled & MAV_SYS_STATUS_GEOFENCE));
    for (const auto &each : station.all<SysStatus>())
        QVERIFY(each.onboard_control_sensors_health & MAV_SYS_STATUS_GEOFENCE);
    QCOMPARE(station.count<FenceStatus>(), std::size_t(0));

    station.setParameter("FENCE_TYPE", 4); // polygons, and there are none
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {1}), int(MAV_RESULT_FAILED));
    station.run(1);
    QVERIFY(!(station.last<SysStatus>().onboard_control_sensors_present & MAV_SYS_STATUS_GEOFENCE));
    QVERIFY(station.last<SysStatus>().onboard_control_sensors_health & MAV_SYS_STATUS_GEOFENCE);
    QCOMPARE(Uploader(station, someFence(), 1).run(5), int(MAV_MISSION_ACCEPTED));
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {1}), int(MAV_RESULT_ACCEPTED));
    QCOMPARE(parameter(station, "FENCE_ENABLE"), 1.f);
    station.run(1);
    status = station.last<SysStatus>();
    QVERIFY(status.onboard_control_sensors_enabled & status.onboard_control_sensors_health & MAV_SYS_STATUS_GEOFENCE);
    QVERIFY(station.count<FenceStatus>() >= 3);
    QCOMPARE(int(station.last<FenceStatus>().breach_status), 0);
    QCOMPARE(int(station.last<FenceStatus>().breach_type), int(FENCE_BREACH_NONE));
    station.setParameter("FENCE_ACTION", 0); // only reported: not "enabled" for a station
    station.run(1);
    QVERIFY(!(station.last<SysStatus>().onboard_control_sensors_enabled & MAV_SYS_STATUS_GEOFENCE));
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {0}), int(MAV_RESULT_ACCEPTED));
    QCOMPARE(parameter(station, "FENCE_ENABLE"), 0.f);
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {9}), int(MAV_RESULT_FAILED));
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {std::nanf("")}), int(MAV_RESULT_FAILED));
}

void SimFenceTest::tellsCapabilities()
{
    TestStation station;
    station.run(1);
    const std::uint64_t wanted = MAV_PROTOCOL_CAPABILITY_MISSION_FENCE | MAV_PROTOCOL_CAPABILITY_MISSION_RALLY
        | MAV_PROTOCOL_CAPABILITY_MISSION_INT | MAV_PROTOCOL_CAPABILITY_COMMAND_INT | MAV_PROTOCOL_CAPABILITY_MAVLINK2
        | MAV_PROTOCOL_CAPABILITY_PARAM_FLOAT;
    QCOMPARE(station.command(MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES, {1}), int(MAV_RESULT_ACCEPTED));
    QCOMPARE(station.last<AutopilotVersion>().capabilities & wanted, wanted);
    station.forget();
    QCOMPARE(station.command(MAV_CMD_REQUEST_MESSAGE, {float(AutopilotVersion::kId)}), int(MAV_RESULT_ACCEPTED));
    QCOMPARE(station.last<AutopilotVersion>().capabilities & wanted, wanted);
}

void SimFenceTest::breachOfRadiusReturns()
{
    TestStation station;
    QVERIFY(station.loiter(10));
    station.setParameter("FENCE_RADIUS", 40);
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {1}), int(MAV_RESULT_ACCEPTED));
    station.run(1);
    QVERIFY(station.last<mavlink::Heartbeat>().custom_mode == 5);
    double furthest = 0;
    const bool returned = station.until(
        [&] {
            flyNorth(station);
            furthest = std::max(furthest, station.vehicle.autopilot().truth().position.horizontal());
            return station.mode() == FlightMode::Rtl;
        },
        40);
    QVERIFY(returned);
    QVERIFY2(furthest > 39 && furthest < 43, qPrintable(QString::number(furthest)));
    station.run(0.1);
    const auto status = station.last<FenceStatus>(); // at once, before the stream sends it
    QCOMPARE(int(status.breach_status), 1);
    QCOMPARE(int(status.breach_count), 1);
    QCOMPARE(int(status.breach_type), int(FENCE_BREACH_BOUNDARY));
    QVERIFY(std::abs(double(status.breach_time) - double(station.vehicle.autopilot().time()) / 1000) < 400);
    QVERIFY(station.said("Fence Breached"));
    station.run(1);
    QVERIFY(!(station.last<SysStatus>().onboard_control_sensors_health & MAV_SYS_STATUS_GEOFENCE));
    QVERIFY(station.until([&] { return !station.vehicle.autopilot().armed(); }, 120));
    station.run(1);
    QVERIFY(station.vehicle.autopilot().truth().position.horizontal() < 3);
    QVERIFY(station.last<SysStatus>().onboard_control_sensors_health & MAV_SYS_STATUS_GEOFENCE);
    QCOMPARE(int(station.last<FenceStatus>().breach_status), 0);
    QCOMPARE(int(station.last<FenceStatus>().breach_count), 1); // of the flight
}

void SimFenceTest::breachActions_data()
{
    QTest::addColumn<int>("action");
    QTest::addColumn<float>("radius");
    QTest::addColumn<int>("mode");
    QTest::newRow("report") << 0 << 40.f << int(FlightMode::Loiter);
    QTest::newRow("return") << 1 << 40.f << int(FlightMode::Rtl);
    QTest::newRow("land") << 2 << 40.f << int(FlightMode::Land);
    QTest::newRow("brake") << 4 << 40.f << int(FlightMode::Brake);
    QTest::newRow("smart or land") << 5 << 40.f << int(FlightMode::Land);
    QTest::newRow("far outside") << 1 << 0.f << int(FlightMode::Land); // the fence is drawn behind the vehicle
}

void SimFenceTest::breachActions()
{
    QFETCH(int, action);
    QFETCH(float, radius);
    QFETCH(int, mode);
    TestStation station;
    QVERIFY(station.loiter(10));
    station.setParameter("FENCE_ACTION", static_cast<float>(action));
    if (radius > 0)
        station.setParameter("FENCE_RADIUS", radius);
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {1}), int(MAV_RESULT_ACCEPTED));
    const auto north = [&](double distance) {
        return station.until(
            [&] {
                flyNorth(station);
                return station.vehicle.autopilot().truth().position.horizontal() > distance
                    || station.vehicle.autopilot().flight().fence.breaches() != 0;
            },
            60);
    };
    QVERIFY(north(radius > 0 ? 100 : 180));
    if (radius == 0)
        station.setParameter("FENCE_RADIUS", 50);
    station.run(0.2);
    QCOMPARE(int(station.vehicle.autopilot().flight().fence.breachCount()), 1);
    QCOMPARE(int(station.mode()), mode);
}

void SimFenceTest::breachOfPolygonIsReported()
{
    TestStation station;
    QVERIFY(station.loiter(8));
    auto items = polygon(MAV_CMD_NAV_FENCE_POLYGON_VERTEX_EXCLUSION, 60, 0, 30);
    QCOMPARE(Uploader(station, numbered(items, 1), 1).run(5), int(MAV_MISSION_ACCEPTED));
    station.setParameter("FENCE_TYPE", 4);
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {1}), int(MAV_RESULT_ACCEPTED));
    QVERIFY(station.until(
        [&] {
            flyNorth(station);
            return station.mode() == FlightMode::Rtl;
        },
        40));
    const double where = station.vehicle.autopilot().truth().position.x;
    QVERIFY2(where > 29 && where < 33, qPrintable(QString::number(where)));
    QCOMPARE(int(station.last<FenceStatus>().breach_type), int(FENCE_BREACH_BOUNDARY));
}

void SimFenceTest::floorIsWatchedUntilDisabled()
{
    TestStation station;
    QVERIFY(station.loiter(20));
    station.setParameter("FENCE_TYPE", 9);
    station.setParameter("FENCE_ALT_MIN", 15);
    station.setParameter("FENCE_ACTION", 0);
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {1}), int(MAV_RESULT_ACCEPTED));
    station.run(1);
    QCOMPARE(int(station.vehicle.autopilot().flight().fence.breaches()), 0);
    QCOMPARE(station.command(MAV_CMD_NAV_LAND), int(MAV_RESULT_ACCEPTED));
    QVERIFY(station.until([&] { return station.vehicle.autopilot().heightAboveHome() < 14; }, 30));
    station.run(0.5);
    QCOMPARE(int(station.last<FenceStatus>().breach_type), int(FENCE_BREACH_MINALT));
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {2}), int(MAV_RESULT_ACCEPTED));
    station.run(1);
    QCOMPARE(int(station.last<FenceStatus>().breach_status), 0);
    station.setParameter("FENCE_ALT_MAX", 10);
    station.run(0.5);
    QCOMPARE(int(station.last<FenceStatus>().breach_type), int(FENCE_BREACH_MAXALT));
    QCOMPARE(int(station.last<FenceStatus>().breach_count), 2);
}

void SimFenceTest::pilotMayComeBack()
{
    TestStation station;
    QVERIFY(station.loiter(10));
    station.setParameter("FENCE_RADIUS", 30);
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {1}), int(MAV_RESULT_ACCEPTED));
    const auto breached = [&](int times) {
        return station.until(
            [&] {
                flyNorth(station);
                return station.vehicle.autopilot().flight().fence.breachCount() == times;
            },
            40);
    };
    QVERIFY(breached(1));
    QCOMPARE(station.command(MAV_CMD_DO_SET_MODE, {1, 5}), int(MAV_RESULT_ACCEPTED));
    const TimePoint taken = station.now;
    QVERIFY(breached(2)); // it did not come back but flew on: 20 m further, and not within ten seconds
    QVERIFY(station.now - taken > std::chrono::milliseconds(9900));
    QVERIFY(station.mode() == FlightMode::Rtl);
    QVERIFY(station.vehicle.autopilot().truth().position.horizontal() > 50);
}

void SimFenceTest::refusesDestinationsOutside()
{
    TestStation station;
    QVERIFY(station.takeOff(10));
    QCOMPARE(Uploader(station, someFence(), 1).run(5), int(MAV_MISSION_ACCEPTED));
    Autopilot &a = station.vehicle.autopilot();
    QVERIFY(!a.requests().goTo({100, 0, -10})); // no fence is enabled
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {1}), int(MAV_RESULT_ACCEPTED));
    QVERIFY(a.requests().goTo({100, 0, -10})); // in the circle
    QVERIFY(a.requests().goTo({201, 0, -10})); // out of the polygon
    QVERIFY(a.requests().goTo({10, 0, -101})); // too high
    QVERIFY(!a.requests().goTo({150, 150, -50}));
    station.setParameter("FENCE_RADIUS", 50);
    QVERIFY(a.requests().goTo({0, 51, -10}));
}

void SimFenceTest::outsideIsNotArmed()
{
    TestStation station;
    station.run(6);
    auto items = polygon(MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION, 500, 0, 100);
    QCOMPARE(Uploader(station, numbered(items, 1), 1).run(5), int(MAV_MISSION_ACCEPTED));
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {1}), int(MAV_RESULT_ACCEPTED));
    station.run(1);
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}), int(MAV_RESULT_FAILED));
    QVERIFY(station.said("PreArm: vehicle outside fence"));
    station.setParameter("FENCE_TYPE", 0);
    station.run(1);
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}), int(MAV_RESULT_FAILED));
    QVERIFY(station.said("PreArm: Fences enabled, but none selected"));
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {0}), int(MAV_RESULT_ACCEPTED));
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}), int(MAV_RESULT_ACCEPTED));
}

void SimFenceTest::returnsToARallyPoint()
{
    TestStation station;
    QVERIFY(station.takeOff(10));
    QCOMPARE(Uploader(station, someRallyPoints(25), 2).run(5), int(MAV_MISSION_ACCEPTED));
    Autopilot &a = station.vehicle.autopilot();
    QVERIFY(!a.requests().goTo({90, 0, -10}));
    QVERIFY(station.until([&] { return a.truth().position.x > 88; }, 60));
    station.command(MAV_CMD_NAV_RETURN_TO_LAUNCH);
    double highest = 0;
    QVERIFY(station.until(
        [&] {
            highest = std::max(highest, a.heightAboveHome());
            return !a.armed();
        },
        150));
    QVERIFY2(std::abs(a.truth().position.x - 60) < 2, qPrintable(QString::number(a.truth().position.x)));
    QVERIFY2(highest > 24 && highest < 26.5, qPrintable(QString::number(highest))); // the height of the point
}

void SimFenceTest::farRallyPointIsNotUsed()
{
    const GeoFrame world({kLatitude * 1e-7, kLongitude * 1e-7, 584});
    RallyPoints points;
    const auto item = itemAt(MAV_CMD_NAV_RALLY_POINT, 0, 400, 0);
    points.load({{item.frame, item.command, true, {}, item.x, item.y, 30}});
    const Vector3 home{0, 0, 0};
    QCOMPARE(points.bestFor({900, 0, -10}, home, world, 300, true), home);
    QVERIFY(points.bestFor({900, 0, -10}, home, world, 0, true).x > 390);
    QVERIFY(points.bestFor({600, 0, -10}, home, world, 300, true).x > 390);
    QCOMPARE(points.bestFor({180, 0, -10}, home, world, 300, true), home); // home is nearer
    QVERIFY(points.bestFor({180, 0, -10}, home, world, 300, false).x > 390);
}

SKYSEAL_TEST_APPLESS(SimFenceTest)
#include "fence_test.moc"
