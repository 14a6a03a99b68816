// Planes and rovers: their modes, parameters and missions, and the way they move: a plane takes off along the ground, circles
// and never stands still; a rover stays on the ground and stops.
#include "tests/sim/some_items.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::sim;
using namespace skyseal::mavlink;

class SimKindsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void identifiesItself_data();
    void identifiesItself();
    void hasParametersOfItsKind();
    void planeTakesOffAndCircles();
    void planeFliesItsMissionAndLands();
    void planeReturnsAndCirclesHome();
    void planeGoesWhereItIsSent();
    void planeGlidesToTheGroundWithoutItsMotor();
    void planeTakesNoTakeOffCommand();
    void returnModeIsNotArmed();
    void roverDrivesItsMission();
    void roverIsArmedAndDisarmedWhereItStands();
    void roverRefusesToFly();
    void stationLossStopsARover();
    void missionsHoldTheCommandsOfTheirKind_data();
    void missionsHoldTheCommandsOfTheirKind();
};

namespace {

SimulatedVehicleConfig of(CraftKind kind)
{
    SimulatedVehicleConfig config;
    config.autopilot.type.kind = kind;
    return config;
}

const BodyState &truth(const TestStation &station)
{
    return station.vehicle.autopilot().truth();
}
double height(const TestStation &station)
{
    return station.vehicle.autopilot().heightAboveHome();
}

/// Armed and in a mode by its number.
bool armIn(TestStation &station, std::uint32_t mode)
{
    station.run(6);
    return station.command(MAV_CMD_DO_SET_MODE, {1, static_cast<float>(mode)}) == MAV_RESULT_ACCEPTED
        && station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}) == MAV_RESULT_ACCEPTED;
}

/// A plane that circles at TKOFF_ALT.
bool circling(TestStation &station)
{
    return armIn(station, PLANE_MODE_TAKEOFF) && station.until([&] { return height(station) > 48; }, 90);
}

/// Least and greatest value while `seconds` pass.
std::pair<double, double> spread(TestStation &station, double seconds, const std::function<double()> &value)
{
    std::pair out{value(), value()};
    for (double t = 0; t < seconds; t += 0.2) {
        station.run(0.2);
        out = {std::min(out.first, value()), std::max(out.second, value())};
    }
    return out;
}

} // namespace

void SimKindsTest::identifiesItself_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("type");
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("copter") << int(CraftKind::Copter) << int(MAV_TYPE_QUADROTOR) << QByteArray("ArduCopter");
    QTest::newRow("plane") << int(CraftKind::Plane) << int(MAV_TYPE_FIXED_WING) << QByteArray("ArduPlane");
    QTest::newRow("rover") << int(CraftKind::Rover) << int(MAV_TYPE_GROUND_ROVER) << QByteArray("ArduRover");
}

void SimKindsTest::identifiesItself()
{
    QFETCH(int, kind);
    QFETCH(int, type);
    QFETCH(QByteArray, text);
    TestStation station(of(static_cast<CraftKind>(kind)));
    station.run(2);
    const auto heartbeat = station.last<mavlink::Heartbeat>();
    QCOMPARE(int(heartbeat.type), type);
    QCOMPARE(int(heartbeat.autopilot), int(MAV_AUTOPILOT_ARDUPILOTMEGA));
    QCOMPARE(int(heartbeat.custom_mode), 0); // STABILIZE, or MANUAL
    QVERIFY(station.said(text.constData()));
    // Every mode of the table can be named; no other.
    const ModeTable &table = station.vehicle.autopilot().modes().table();
    for (const ModeRow &row : table.rows())
        QCOMPARE(table.withNumber(row.number), &row);
    QCOMPARE(station.command(MAV_CMD_DO_SET_MODE, {1, 77}), int(MAV_RESULT_FAILED));
}

void SimKindsTest::hasParametersOfItsKind()
{
    const Parameters copter({CraftKind::Copter}), plane({CraftKind::Plane}), rover({CraftKind::Rover});
    for (const Parameters *all : {&copter, &plane, &rover}) {
        QVERIFY(all->find("SYSID_THISMAV") && all->find("SIM_SPEEDUP") && all->find("SR0_EXTRA1")
                && all->find("BATT_CAPACITY"));
        for (std::size_t i = 0; i < all->count(); ++i) {
            const ParameterInfo &info = all->info(i);
            QVERIFY2(info.name.size() <= 16 && info.standard >= info.minimum && info.standard <= info.maximum,
                     info.name.c_str());
            QVERIFY2(i == 0 || all->info(i - 1).name < info.name, info.name.c_str());
        }
    }
    QVERIFY(copter.find("WPNAV_SPEED") && !plane.find("WPNAV_SPEED") && !rover.find("WPNAV_SPEED"));
    QVERIFY(plane.find("WP_LOITER_RAD") && !copter.find("WP_LOITER_RAD") && !rover.find("WP_LOITER_RAD"));
    QVERIFY(rover.find("CRUISE_SPEED") && !copter.find("CRUISE_SPEED") && !plane.find("CRUISE_SPEED"));
}

void SimKindsTest::planeTakesOffAndCircles()
{
    TestStation station(of(CraftKind::Plane));
    QVERIFY(armIn(station, PLANE_MODE_TAKEOFF));
    QVERIFY(station.until([&] { return !truth(station).onGround; }, 20));
    QVERIFY(truth(station).position.horizontal() > 10); // along the ground
    QVERIFY(station.until([&] { return height(station) > 48; }, 60));
    station.run(20);
    const auto speed = spread(station, 60, [&] { return truth(station).velocity.horizontal(); });
    QVERIFY2(speed.first > 15, qPrintable(QString::number(speed.first)));
    const auto distance = spread(station, 60, [&] { return truth(station).position.horizontal(); });
    QVERIFY2(distance.first > 40 && distance.second < 85, // WP_LOITER_RAD is 60
             qPrintable(QStringLiteral("%1 %2").arg(distance.first).arg(distance.second)));
    const auto roll = spread(station, 5, [&] { return truth(station).attitude.euler().roll; });
    QVERIFY(roll.first > radians(10) && roll.second < radians(46)); // it banks, clockwise
    QVERIFY(std::abs(height(station) - 50) < 3);
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {0}), int(MAV_RESULT_FAILED));
}

void SimKindsTest::planeFliesItsMissionAndLands()
{
    TestStation station(of(CraftKind::Plane));
    station.run(6);
    std::vector<mavlink::MissionItemInt> items{
        itemAt(MAV_CMD_NAV_WAYPOINT, 0, 0, 0), itemAt(MAV_CMD_NAV_TAKEOFF, 0, 0, 0), itemAt(MAV_CMD_NAV_WAYPOINT, 0, 500, 0),
        itemAt(MAV_CMD_NAV_LOITER_TURNS, 1, 400, 300), itemAt(MAV_CMD_NAV_LAND, 0, 100, 0)};
    for (auto &item : items)
        item.frame = MAV_FRAME_GLOBAL_RELATIVE_ALT;
    for (std::size_t i = 1; i + 1 < items.size(); ++i)
        items[i].z = 40;
    QCOMPARE(Uploader(station, numbered(items, 0), 0).run(5), int(MAV_MISSION_ACCEPTED));
    QVERIFY(armIn(station, PLANE_MODE_AUTO)); // it starts at once
    QVERIFY(station.until([&] { return station.count<MissionItemReached>() == 3; }, 200));
    QVERIFY(height(station) > 30);
    station.forget();
    QVERIFY(station.until([&] { return station.vehicle.autopilot().landed(); }, 200));
    QVERIFY(!station.said("Hit ground")); // softly
    QVERIFY2((truth(station).position - Vector3{100, 0, 0}).horizontal() < 250,
             qPrintable(QString::number(truth(station).position.horizontal())));
    QVERIFY(station.until([&] { return !station.vehicle.autopilot().armed(); }, 60)); // LAND_DISARMDELAY
    QVERIFY(truth(station).velocity.length() < 0.1);
}

void SimKindsTest::planeReturnsAndCirclesHome()
{
    TestStation station(of(CraftKind::Plane));
    QVERIFY(circling(station));
    QCOMPARE(station.command(MAV_CMD_NAV_RETURN_TO_LAUNCH), int(MAV_RESULT_ACCEPTED));
    QCOMPARE(station.vehicle.autopilot().modes().row().number, std::uint32_t(PLANE_MODE_RTL));
    QVERIFY(station.until([&] { return height(station) > 95; }, 60)); // RTL_ALTITUDE
    station.run(120);
    QVERIFY(station.vehicle.autopilot().armed() && height(station) > 95);
    QVERIFY(truth(station).position.horizontal() < 100);
}

void SimKindsTest::planeGoesWhereItIsSent()
{
    TestStation station(of(CraftKind::Plane));
    QVERIFY(circling(station));
    QCOMPARE(station.command(MAV_CMD_DO_SET_MODE, {1, PLANE_MODE_GUIDED}), int(MAV_RESULT_ACCEPTED));
    QVERIFY(!station.vehicle.autopilot().requests().goTo({600, 200, -80}));
    const auto away = [&] { return (truth(station).position - Vector3{600, 200, 0}).horizontal(); };
    QVERIFY(station.until([&] { return away() < 90; }, 90));
    station.run(10);
    const auto distance = spread(station, 40, away);
    QVERIFY2(distance.first > 35 && distance.second < 100,
             qPrintable(QStringLiteral("%1 %2").arg(distance.first).arg(distance.second)));
    QVERIFY(std::abs(height(station) - 80) < 5);
}

void SimKindsTest::planeGlidesToTheGroundWithoutItsMotor()
{
    TestStation station(of(CraftKind::Plane));
    QVERIFY(circling(station));
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {0, 21196}), int(MAV_RESULT_ACCEPTED));
    station.run(5);
    QVERIFY(height(station) < 48 && height(station) > 20); // not like a stone
    QVERIFY(station.until([&] { return truth(station).onGround; }, 60));
    station.run(10);
    QVERIFY(truth(station).velocity.length() < 0.1);
}

void SimKindsTest::planeTakesNoTakeOffCommand()
{
    TestStation station(of(CraftKind::Plane));
    QVERIFY(armIn(station, PLANE_MODE_GUIDED));
    QCOMPARE(station.command(MAV_CMD_NAV_TAKEOFF, {0, 0, 0, 0, 0, 0, 30}), int(MAV_RESULT_FAILED));
    QCOMPARE(station.command(MAV_CMD_NAV_LAND), int(MAV_RESULT_UNSUPPORTED)); // by a mission
    station.run(5);
    QVERIFY(truth(station).onGround);
}

void SimKindsTest::returnModeIsNotArmed()
{
    for (const CraftKind kind : {CraftKind::Plane, CraftKind::Rover}) {
        TestStation station(of(kind));
        station.run(6);
        QCOMPARE(station.command(MAV_CMD_DO_SET_MODE, {1, 11}), int(MAV_RESULT_ACCEPTED)); // RTL of both
        QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}), int(MAV_RESULT_FAILED));
        station.run(0.2);
        QVERIFY(station.said("RTL mode not armable"));
    }
}

void SimKindsTest::roverDrivesItsMission()
{
    TestStation station(of(CraftKind::Rover));
    station.run(6);
    const auto items = numbered({itemAt(MAV_CMD_NAV_WAYPOINT, 0, 0, 0), itemAt(MAV_CMD_NAV_WAYPOINT, 0, 30, 0),
                                 itemAt(MAV_CMD_NAV_WAYPOINT, 0, 30, 20), itemAt(MAV_CMD_NAV_RETURN_TO_LAUNCH, 0, 0, 0)},
                                0);
    QCOMPARE(Uploader(station, items, 0).run(5), int(MAV_MISSION_ACCEPTED));
    QVERIFY(armIn(station, ROVER_MODE_AUTO));
    double highest = 0, fastest = 0;
    QVERIFY(station.until(
        [&] {
            highest = std::max(highest, std::abs(truth(station).position.z));
            fastest = std::max(fastest, truth(station).velocity.horizontal());
            return station.count<MissionItemReached>() == 2;
        },
        90));
    QVERIFY((truth(station).position - Vector3{30, 20, 0}).horizontal() < 3);
    station.run(60);
    QVERIFY2(truth(station).position.horizontal() < 3, qPrintable(QString::number(truth(station).position.horizontal())));
    QVERIFY(truth(station).velocity.horizontal() < 0.1); // it stops at home
    QCOMPARE(highest, 0.0);
    QVERIFY2(fastest > 1.7 && fastest < 2.3, qPrintable(QString::number(fastest))); // WP_SPEED
}

void SimKindsTest::roverIsArmedAndDisarmedWhereItStands()
{
    TestStation station(of(CraftKind::Rover));
    QVERIFY(armIn(station, ROVER_MODE_GUIDED));
    QVERIFY(!station.vehicle.autopilot().requests().goTo({40, 0, 0}));
    QVERIFY(station.until([&] { return truth(station).velocity.horizontal() > 1.5; }, 20));
    QCOMPARE(station.command(MAV_CMD_DO_SET_MODE, {1, ROVER_MODE_HOLD}), int(MAV_RESULT_ACCEPTED));
    QVERIFY(station.until([&] { return truth(station).velocity.horizontal() < 0.05; }, 10));
    station.run(30);
    QVERIFY(station.vehicle.autopilot().armed()); // it waits
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {0}), int(MAV_RESULT_ACCEPTED));
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}), int(MAV_RESULT_ACCEPTED));
    station.command(MAV_CMD_REQUEST_MESSAGE, {float(ExtendedSysState::kId)});
    QCOMPARE(int(station.last<ExtendedSysState>().landed_state), int(MAV_LANDED_STATE_UNDEFINED));
}

void SimKindsTest::roverRefusesToFly()
{
    TestStation station(of(CraftKind::Rover));
    QVERIFY(armIn(station, ROVER_MODE_GUIDED));
    QCOMPARE(station.command(MAV_CMD_NAV_TAKEOFF, {0, 0, 0, 0, 0, 0, 10}), int(MAV_RESULT_UNSUPPORTED));
    QCOMPARE(station.command(MAV_CMD_NAV_LAND), int(MAV_RESULT_UNSUPPORTED));
    QVERIFY(!station.vehicle.autopilot().requests().goTo({10, 0, -20}));
    station.run(20);
    QCOMPARE(truth(station).position.z, 0.0);
    QVERIFY((truth(station).position - Vector3{10, 0, 0}).horizontal() < 2);
}

void SimKindsTest::stationLossStopsARover()
{
    TestStation station(of(CraftKind::Rover));
    station.setParameter("FS_GCS_ENABLE", 1);
    QVERIFY(armIn(station, ROVER_MODE_GUIDED));
    QVERIFY(!station.vehicle.autopilot().requests().goTo({200, 0, 0}));
    station.silent = true;
    station.run(4);
    QVERIFY(station.mode() == FlightMode::Guided);
    station.run(3);                              // FS_GCS_TIMEOUT
    QVERIFY(station.mode() == FlightMode::Hold); // FS_ACTION
    QVERIFY(station.said("GCS Failsafe - HOLD"));
}

void SimKindsTest::missionsHoldTheCommandsOfTheirKind_data()
{
    QTest::addColumn<int>("command");
    QTest::addColumn<bool>("copter");
    QTest::addColumn<bool>("plane");
    QTest::addColumn<bool>("rover");
    QTest::newRow("waypoint") << int(MAV_CMD_NAV_WAYPOINT) << true << true << true;
    QTest::newRow("take-off") << int(MAV_CMD_NAV_TAKEOFF) << true << true << false;
    QTest::newRow("land") << int(MAV_CMD_NAV_LAND) << true << true << false;
    QTest::newRow("turns") << int(MAV_CMD_NAV_LOITER_TURNS) << false << true << false;
    QTest::newRow("yaw") << int(MAV_CMD_CONDITION_YAW) << true << false << false;
    QTest::newRow("spline") << int(MAV_CMD_NAV_SPLINE_WAYPOINT) << false << false << false;
}

void SimKindsTest::missionsHoldTheCommandsOfTheirKind()
{
    QFETCH(int, command);
    const CraftKind kinds[] = {CraftKind::Copter, CraftKind::Plane, CraftKind::Rover};
    const char *const columns[] = {"copter", "plane", "rover"};
    for (std::size_t i = 0; i < 3; ++i) {
        const bool *wanted = static_cast<bool *>(QTest::qData(columns[i], qMetaTypeId<bool>()));
        StoredItem item;
        item.command = static_cast<std::uint16_t>(command);
        item.frame = MAV_FRAME_GLOBAL_RELATIVE_ALT;
        QCOMPARE(!checkItem(item, {kinds[i]}), *wanted);
    }
}

SKYSEAL_TEST_APPLESS(SimKindsTest)
#include "kinds_test.moc"
