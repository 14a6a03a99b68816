// Fence and rally points: transfers that do not disturb the flight plan, the refusals, what a station is told about the fence,
// and what the vehicle does when it crosses it.
#include "tests/sim/item_exchange.h"
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
    void transfersOfAllTypes_data();
    void transfersOfAllTypes();
    void transfersAtTheSameTime();
    void fenceErrors_data();
    void fenceErrors();
    void rallyErrors();
    void clears();
    void listsSurviveAReboot();
    void oldProtocolInFloats();
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

constexpr std::int32_t kLatitude = -353632610, kLongitude = 1491652300; // where the vehicle stands
constexpr double kMetre = 1e7 / 111318.845;                             // of latitude, in 1e-7 degrees

mavlink::MissionItemInt itemAt(std::uint16_t command, float size, double north, double east)
{
    mavlink::MissionItemInt item;
    item.target_system = 1;
    item.target_component = 1;
    item.frame = command == MAV_CMD_NAV_RALLY_POINT ? MAV_FRAME_GLOBAL_RELATIVE_ALT : MAV_FRAME_GLOBAL;
    item.command = command;
    item.autocontinue = 1;
    item.param1 = size;
    item.x = kLatitude + static_cast<std::int32_t>(north * kMetre);
    item.y = kLongitude + static_cast<std::int32_t>(east * kMetre / std::cos(0.6172));
    return item;
}

std::vector<mavlink::MissionItemInt> numbered(std::vector<mavlink::MissionItemInt> items, std::uint8_t type)
{
    for (std::size_t i = 0; i < items.size(); ++i) {
        items[i].seq = static_cast<std::uint16_t>(i);
        items[i].mission_type = type;
    }
    return items;
}

std::vector<mavlink::MissionItemInt> polygon(std::uint16_t command, double north, double east, double half)
{
    return {itemAt(command, 4, north + half, east - half), itemAt(command, 4, north + half, east + half),
            itemAt(command, 4, north - half, east + half), itemAt(command, 4, north - half, east - half)};
}

/// A square to stay in, a circle to stay out of, and a return point.
std::vector<mavlink::MissionItemInt> someFence()
{
    auto items = polygon(MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION, 0, 0, 200);
    items.push_back(itemAt(MAV_CMD_NAV_FENCE_CIRCLE_EXCLUSION, 20, 100, 0));
    items.push_back(itemAt(MAV_CMD_NAV_FENCE_RETURN_POINT, 0, 0, 0));
    return numbered(items, MAV_MISSION_TYPE_FENCE);
}

std::vector<mavlink::MissionItemInt> someRallyPoints(double height = 30)
{
    std::vector<mavlink::MissionItemInt> items{itemAt(MAV_CMD_NAV_RALLY_POINT, 0, 60, 0),
                                               itemAt(MAV_CMD_NAV_RALLY_POINT, 0, -150, 80)};
    for (auto &item : items)
        item.z = static_cast<float>(height);
    return numbered(items, MAV_MISSION_TYPE_RALLY);
}

std::vector<mavlink::MissionItemInt> somePlan()
{
    std::vector<mavlink::MissionItemInt> items;
    for (int i = 0; i < 5; ++i)
        items.push_back(itemAt(i == 1 ? MAV_CMD_NAV_TAKEOFF : MAV_CMD_NAV_WAYPOINT, 0, i * 10, 0));
    return numbered(items, 0);
}

std::vector<mavlink::MissionItemInt> some(std::uint8_t type)
{
    return type == MAV_MISSION_TYPE_FENCE ? someFence() : type == MAV_MISSION_TYPE_RALLY ? someRallyPoints() : somePlan();
}

void setParameter(TestStation &station, const char *name, float value)
{
    ParamSet set;
    set.target_system = 1;
    std::copy_n(name, std::strlen(name), set.param_id.begin());
    set.param_value = value;
    station.send(set);
}

float parameter(const TestStation &station, const char *name)
{
    return station.vehicle.autopilot().parameters().value(name);
}

/// In LOITER at a height, which flies where the stick points: GUIDED would refuse to leave the fence.
bool airborne(TestStation &station, float height)
{
    return station.takeOff(height) && station.command(MAV_CMD_DO_SET_MODE, {1, 5}) == MAV_RESULT_ACCEPTED;
}

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

void SimFenceTest::transfersOfAllTypes_data()
{
    QTest::addColumn<int>("type");
    QTest::addColumn<double>("loss");
    for (const double loss : {0.0, 0.33}) {
        for (int type = 0; type < 3; ++type)
            QTest::addRow("type %d, loss %g", type, loss) << type << loss;
    }
}

void SimFenceTest::transfersOfAllTypes()
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

void SimFenceTest::transfersAtTheSameTime()
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

void SimFenceTest::fenceErrors_data()
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

void SimFenceTest::fenceErrors()
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
    QCOMPARE(station.vehicle.autopilot().fence().areas().items().size(), taken ? items.size() : before.size());
    QCOMPARE(parameter(station, "FENCE_TOTAL"), taken ? 6.f : 1.f);
}

void SimFenceTest::rallyErrors()
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

void SimFenceTest::clears()
{
    TestStation station;
    station.run(6);
    const auto sizes = [&] {
        const Autopilot &a = station.vehicle.autopilot();
        return std::array{a.modes().mission().mission().size(), a.fence().areas().items().size(),
                          a.rallyPoints().items().size()};
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

void SimFenceTest::listsSurviveAReboot()
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

void SimFenceTest::oldProtocolInFloats()
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
    QVERIFY(std::abs(station.vehicle.autopilot().rallyPoints().items()[0].x - someRallyPoints()[1].x) < 100);
}

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

    setParameter(station, "FENCE_TYPE", 4); // polygons, and there are none
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
    setParameter(station, "FENCE_ACTION", 0); // only reported: not "enabled" for a station
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
    QVERIFY(airborne(station, 10));
    setParameter(station, "FENCE_RADIUS", 40);
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {1}), int(MAV_RESULT_ACCEPTED));
    station.run(1);
    QVERIFY(station.last<mavlink::Heartbeat>().custom_mode == 5);
    double furthest = 0;
    const bool returned = station.until(
        [&] {
            flyNorth(station);
            furthest = std::max(furthest, station.vehicle.autopilot().truth().position.horizontal());
            return station.vehicle.autopilot().modes().current() == FlightMode::Rtl;
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
    QVERIFY(airborne(station, 10));
    setParameter(station, "FENCE_ACTION", static_cast<float>(action));
    if (radius > 0)
        setParameter(station, "FENCE_RADIUS", radius);
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {1}), int(MAV_RESULT_ACCEPTED));
    const auto north = [&](double distance) {
        return station.until(
            [&] {
                flyNorth(station);
                return station.vehicle.autopilot().truth().position.horizontal() > distance
                    || station.vehicle.autopilot().fence().breaches() != 0;
            },
            60);
    };
    QVERIFY(north(radius > 0 ? 100 : 180));
    if (radius == 0)
        setParameter(station, "FENCE_RADIUS", 50);
    station.run(0.2);
    QCOMPARE(int(station.vehicle.autopilot().fence().breachCount()), 1);
    QCOMPARE(int(station.vehicle.autopilot().modes().current()), mode);
}

void SimFenceTest::breachOfPolygonIsReported()
{
    TestStation station;
    QVERIFY(airborne(station, 8));
    auto items = polygon(MAV_CMD_NAV_FENCE_POLYGON_VERTEX_EXCLUSION, 60, 0, 30);
    QCOMPARE(Uploader(station, numbered(items, 1), 1).run(5), int(MAV_MISSION_ACCEPTED));
    setParameter(station, "FENCE_TYPE", 4);
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {1}), int(MAV_RESULT_ACCEPTED));
    QVERIFY(station.until(
        [&] {
            flyNorth(station);
            return station.vehicle.autopilot().modes().current() == FlightMode::Rtl;
        },
        40));
    const double where = station.vehicle.autopilot().truth().position.x;
    QVERIFY2(where > 29 && where < 33, qPrintable(QString::number(where)));
    QCOMPARE(int(station.last<FenceStatus>().breach_type), int(FENCE_BREACH_BOUNDARY));
}

void SimFenceTest::floorIsWatchedUntilDisabled()
{
    TestStation station;
    QVERIFY(airborne(station, 20));
    setParameter(station, "FENCE_TYPE", 9);
    setParameter(station, "FENCE_ALT_MIN", 15);
    setParameter(station, "FENCE_ACTION", 0);
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {1}), int(MAV_RESULT_ACCEPTED));
    station.run(1);
    QCOMPARE(int(station.vehicle.autopilot().fence().breaches()), 0);
    QCOMPARE(station.command(MAV_CMD_NAV_LAND), int(MAV_RESULT_ACCEPTED));
    QVERIFY(station.until([&] { return station.vehicle.autopilot().heightAboveHome() < 14; }, 30));
    station.run(0.5);
    QCOMPARE(int(station.last<FenceStatus>().breach_type), int(FENCE_BREACH_MINALT));
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {2}), int(MAV_RESULT_ACCEPTED));
    station.run(1);
    QCOMPARE(int(station.last<FenceStatus>().breach_status), 0);
    setParameter(station, "FENCE_ALT_MAX", 10);
    station.run(0.5);
    QCOMPARE(int(station.last<FenceStatus>().breach_type), int(FENCE_BREACH_MAXALT));
    QCOMPARE(int(station.last<FenceStatus>().breach_count), 2);
}

void SimFenceTest::pilotMayComeBack()
{
    TestStation station;
    QVERIFY(airborne(station, 10));
    setParameter(station, "FENCE_RADIUS", 30);
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {1}), int(MAV_RESULT_ACCEPTED));
    const auto breached = [&](int times) {
        return station.until(
            [&] {
                flyNorth(station);
                return station.vehicle.autopilot().fence().breachCount() == times;
            },
            40);
    };
    QVERIFY(breached(1));
    QCOMPARE(station.command(MAV_CMD_DO_SET_MODE, {1, 5}), int(MAV_RESULT_ACCEPTED));
    const TimePoint taken = station.now;
    QVERIFY(breached(2)); // it did not come back but flew on: 20 m further, and not within ten seconds
    QVERIFY(station.now - taken > std::chrono::milliseconds(9900));
    QVERIFY(station.vehicle.autopilot().modes().current() == FlightMode::Rtl);
    QVERIFY(station.vehicle.autopilot().truth().position.horizontal() > 50);
}

void SimFenceTest::refusesDestinationsOutside()
{
    TestStation station;
    QVERIFY(station.takeOff(10));
    QCOMPARE(Uploader(station, someFence(), 1).run(5), int(MAV_MISSION_ACCEPTED));
    Autopilot &a = station.vehicle.autopilot();
    QVERIFY(!a.goTo({100, 0, -10})); // no fence is enabled
    QCOMPARE(station.command(MAV_CMD_DO_FENCE_ENABLE, {1}), int(MAV_RESULT_ACCEPTED));
    QVERIFY(a.goTo({100, 0, -10})); // in the circle
    QVERIFY(a.goTo({201, 0, -10})); // out of the polygon
    QVERIFY(a.goTo({10, 0, -101})); // too high
    QVERIFY(!a.goTo({150, 150, -50}));
    setParameter(station, "FENCE_RADIUS", 50);
    QVERIFY(a.goTo({0, 51, -10}));
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
    setParameter(station, "FENCE_TYPE", 0);
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
    QVERIFY(!a.goTo({90, 0, -10}));
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
