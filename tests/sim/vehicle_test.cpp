// The simulated vehicle as a station flies it: a whole flight by messages, refusals with the right results, failsafe,
// sticks.
#include "tests/sim/test_station.h"
#include "tests/support/test_runner.h"

#include "core/mavlink/enums.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::sim;
using namespace skyseal::mavlink;
using namespace std::chrono_literals;

class SimVehicleTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void heartbeatSaysWhatItIs();
    void wholeFlight();
    void refusalsHaveTheRightResults();
    void ignoresWhatIsForOthers();
    void commandIntAndReposition();
    void noseTurnsToARegionOfInterest();
    void homeIsSetInTheFrameOfTheCommand();
    void stationLossReturns();
    void sticksFly();
};

void SimVehicleTest::heartbeatSaysWhatItIs()
{
    TestStation station;
    station.run(6);
    const auto heartbeat = station.last<mavlink::Heartbeat>();
    QCOMPARE(int(heartbeat.type), int(MAV_TYPE_QUADROTOR));
    QCOMPARE(int(heartbeat.autopilot), int(MAV_AUTOPILOT_ARDUPILOTMEGA));
    QCOMPARE(int(heartbeat.base_mode), 81); // custom mode, manual input, stabilize
    QCOMPARE(heartbeat.custom_mode, 0u);
    QCOMPARE(int(heartbeat.system_status), int(MAV_STATE_STANDBY));
    QCOMPARE(int(heartbeat.mavlink_version), 3);
    QVERIFY(station.count<mavlink::Heartbeat>() >= 6);
    QVERIFY(station.said("EKF3 IMU0 is using GPS"));
    const auto gps = station.last<GpsRawInt>();
    QCOMPARE(int(gps.fix_type), int(GPS_FIX_TYPE_3D_FIX));
    QVERIFY(gps.satellites_visible >= 6);
    QVERIFY(std::abs(gps.lat + 353632610) < 500);
    QCOMPARE(int(station.last<EkfStatusReport>().flags), 831);
    QVERIFY(station.last<SysStatus>().onboard_control_sensors_health & MAV_SYS_STATUS_PREARM_CHECK);
    QVERIFY(std::abs(int(station.last<RawImu>().zacc) + 1000) < 30);
    QVERIFY(std::abs(station.last<mavlink::ScaledPressure>().press_abs - 945) < 3); // 584 m
}

void SimVehicleTest::wholeFlight()
{
    TestStation station;
    QVERIFY(station.takeOff(10));
    station.run(6);
    const auto hover = station.last<GlobalPositionInt>();
    QVERIFY(std::abs(hover.relative_alt - 10000) < 400);
    std::int32_t highest = 0;
    for (const auto &position : station.all<GlobalPositionInt>())
        highest = std::max(highest, position.relative_alt);
    QVERIFY2(highest < 10500, qPrintable(QString::number(highest)));
    const auto heartbeat = station.last<mavlink::Heartbeat>();
    QCOMPARE(heartbeat.custom_mode, 4u);
    QVERIFY(heartbeat.base_mode & MAV_MODE_FLAG_SAFETY_ARMED);
    QCOMPARE(int(heartbeat.system_status), int(MAV_STATE_ACTIVE));
    QVERIFY(station.last<mavlink::VfrHud>().throttle > 25 && station.last<mavlink::VfrHud>().throttle < 50);
    QVERIFY(station.last<ServoOutputRaw>().servo1_raw > 1300);

    SetPositionTargetGlobalInt target;
    target.target_system = 1;
    target.coordinate_frame = MAV_FRAME_GLOBAL_RELATIVE_ALT_INT;
    target.type_mask = 0x0df8;
    target.lat_int = hover.lat + 4492; // 50 m
    target.lon_int = hover.lon;
    target.alt = 10;
    station.send(target);
    const TimePoint begin = station.now;
    QVERIFY(station.until([&] { return std::abs(station.last<GlobalPositionInt>().lat - target.lat_int) < 10; }, 25));
    QVERIFY(station.now - begin > 9s);
    QVERIFY(station.last<NavControllerOutput>().wp_dist <= 2);

    station.forget();
    QCOMPARE(station.command(MAV_CMD_NAV_RETURN_TO_LAUNCH), int(MAV_RESULT_ACCEPTED));
    QVERIFY(station.until([&] { return !station.vehicle.autopilot().armed(); }, 100));
    station.run(2);
    QCOMPARE(station.last<mavlink::Heartbeat>().custom_mode, 6u);
    QVERIFY(!(station.last<mavlink::Heartbeat>().base_mode & MAV_MODE_FLAG_SAFETY_ARMED));
    QVERIFY(std::abs(station.last<GlobalPositionInt>().relative_alt) < 500);
    QVERIFY(station.said("Disarming motors"));
    QCOMPARE(int(station.last<ServoOutputRaw>().servo1_raw), 1000);
}

void SimVehicleTest::refusalsHaveTheRightResults()
{
    TestStation station;
    station.run(0.1);
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}), int(MAV_RESULT_FAILED));
    QVERIFY(station.said("PreArm: "));
    QCOMPARE(station.command(MAV_CMD_DO_SET_MODE, {1, 4}), int(MAV_RESULT_FAILED));
    QVERIFY(station.said("requires position"));
    QCOMPARE(station.command(MAV_CMD_DO_SET_MODE, {1, 99}), int(MAV_RESULT_FAILED));
    QVERIFY(station.said("No such mode 99"));
    QCOMPARE(station.command(MAV_CMD_DO_SET_MODE, {0, 4}), int(MAV_RESULT_DENIED));
    QCOMPARE(station.command(MAV_CMD_DO_DIGICAM_CONTROL), int(MAV_RESULT_UNSUPPORTED));
    QCOMPARE(station.command(59999), int(MAV_RESULT_UNSUPPORTED));
    QCOMPARE(station.command(MAV_CMD_NAV_TAKEOFF, {0, 0, 0, 0, 0, 0, 10}), int(MAV_RESULT_FAILED));
    QCOMPARE(station.command(MAV_CMD_MISSION_START), int(MAV_RESULT_FAILED));
    QCOMPARE(station.command(MAV_CMD_DO_SET_MISSION_CURRENT, {7}), int(MAV_RESULT_FAILED));
    QCOMPARE(station.command(MAV_CMD_REQUEST_MESSAGE, {9999}), int(MAV_RESULT_FAILED));

    QVERIFY(station.takeOff(5));
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {0}), int(MAV_RESULT_FAILED));
    QVERIFY(station.vehicle.autopilot().armed());
    QCOMPARE(station.command(MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, {1}), int(MAV_RESULT_FAILED));
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {0, 21196}), int(MAV_RESULT_ACCEPTED));
    QVERIFY(!station.vehicle.autopilot().armed());
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}), int(MAV_RESULT_FAILED)); // it falls
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1, 21196}), int(MAV_RESULT_ACCEPTED));
}

void SimVehicleTest::ignoresWhatIsForOthers()
{
    TestStation station;
    station.run(6);
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}, 7), -1);
    QVERIFY(!station.vehicle.autopilot().armed());
    CommandLong gimbal;
    gimbal.target_system = 1;
    gimbal.target_component = 154;
    gimbal.command = MAV_CMD_COMPONENT_ARM_DISARM;
    gimbal.param1 = 1;
    station.send(gimbal);
    QCOMPARE(station.count<CommandAck>(), std::size_t(0));
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}, 0), int(MAV_RESULT_ACCEPTED)); // to everybody
}

void SimVehicleTest::commandIntAndReposition()
{
    TestStation station;
    QVERIFY(station.takeOff(8));
    QCOMPARE(station.command(MAV_CMD_DO_SET_MODE, {1, 5}), int(MAV_RESULT_ACCEPTED));
    const auto here = station.last<GlobalPositionInt>();
    CommandInt go = TestStation::commandAt(MAV_CMD_DO_REPOSITION, MAV_FRAME_GLOBAL_RELATIVE_ALT_INT, here.lat, here.lon + 2200,
                                           12); // 20 m
    go.target_component = 1;
    go.param1 = -1;
    go.param4 = std::nanf("");
    QCOMPARE(station.resultOf(go), int(MAV_RESULT_DENIED)); // not in GUIDED, and not asked to change
    go.param2 = 1;
    QCOMPARE(station.resultOf(go), int(MAV_RESULT_ACCEPTED));
    QVERIFY(station.until(
        [&] {
            const auto p = station.last<GlobalPositionInt>();
            return std::abs(p.lon - go.y) < 15 && std::abs(p.relative_alt - 12000) < 500;
        },
        30));
    QCOMPARE(station.command(MAV_CMD_CONDITION_YAW, {180, 30, 1, 0}), int(MAV_RESULT_ACCEPTED));
    station.run(8);
    QVERIFY(std::abs(int(station.last<mavlink::VfrHud>().heading) - 180) < 5);
    QCOMPARE(station.command(MAV_CMD_DO_CHANGE_SPEED, {1, 2, -1}), int(MAV_RESULT_ACCEPTED));
    go.y = here.lon;
    station.send(go);
    station.run(4);
    QVERIFY(station.last<mavlink::VfrHud>().groundspeed < 2.6f && station.last<mavlink::VfrHud>().groundspeed > 1.3f);
    go.x = 2000000000;
    QCOMPARE(station.resultOf(go), int(MAV_RESULT_DENIED));

    mavlink::MissionItemInt guided; // the older way to say the same
    guided.target_system = 1;
    guided.frame = MAV_FRAME_GLOBAL_RELATIVE_ALT_INT;
    guided.command = MAV_CMD_NAV_WAYPOINT;
    guided.current = 2;
    guided.x = here.lat + 900;
    guided.y = here.lon;
    guided.z = 8;
    station.send(guided);
    QCOMPARE(int(station.last<MissionAck>().type), int(MAV_MISSION_ACCEPTED));
    QVERIFY(station.until([&] { return std::abs(station.last<GlobalPositionInt>().lat - guided.x) < 15; }, 30));
}

/// Until another request, or the mode changes; in LOITER the pilot turns the vehicle.
void SimVehicleTest::noseTurnsToARegionOfInterest()
{
    TestStation station;
    QVERIFY(station.takeOff(8));
    const auto here = station.last<GlobalPositionInt>();
    const auto faces = [&](int degrees) { return std::abs(int(station.last<mavlink::VfrHud>().heading) - degrees) < 5; };
    CommandInt point = TestStation::commandAt(MAV_CMD_DO_SET_ROI_LOCATION, MAV_FRAME_GLOBAL_RELATIVE_ALT, here.lat,
                                              here.lon + 10000); // 90 m to the east
    QCOMPARE(station.resultOf(point), int(MAV_RESULT_ACCEPTED));
    station.run(8);
    QVERIFY(faces(90));
    CommandInt go = point; // to the north-east of it
    go.command = MAV_CMD_DO_REPOSITION;
    go.x = here.lat + 8085; // 90 m
    go.y = point.y;
    go.z = 8;
    QCOMPARE(station.resultOf(go), int(MAV_RESULT_ACCEPTED));
    QVERIFY(station.until([&] { return std::abs(station.last<GlobalPositionInt>().lat - go.x) < 15; }, 60));
    QVERIFY(faces(180));
    QCOMPARE(station.command(MAV_CMD_DO_SET_ROI_NONE), int(MAV_RESULT_ACCEPTED));
    go.y -= 8000;
    station.send(go);
    station.run(6);
    QVERIFY(faces(270));
    point.frame = MAV_FRAME_LOCAL_NED;
    QCOMPARE(station.resultOf(point), int(MAV_RESULT_DENIED));
    QCOMPARE(station.command(MAV_CMD_DO_SET_MODE, {1, 5}), int(MAV_RESULT_ACCEPTED));
    const int before = station.last<mavlink::VfrHud>().heading;
    point.frame = MAV_FRAME_GLOBAL_RELATIVE_ALT;
    QCOMPARE(station.resultOf(point), int(MAV_RESULT_ACCEPTED));
    station.run(5);
    QVERIFY(faces(before));
}

void SimVehicleTest::homeIsSetInTheFrameOfTheCommand()
{
    TestStation station;
    station.run(6);
    const auto before = station.last<HomePosition>();
    CommandInt home = TestStation::commandAt(MAV_CMD_DO_SET_HOME, MAV_FRAME_GLOBAL, before.latitude + 1000, before.longitude,
                                             590);
    QCOMPARE(station.resultOf(home), int(MAV_RESULT_ACCEPTED));
    QVERIFY(std::abs(station.last<HomePosition>().latitude - home.x) < 10);
    QVERIFY(std::abs(station.last<HomePosition>().altitude - 590'000) < 20);
    home.frame = MAV_FRAME_GLOBAL_RELATIVE_ALT;
    home.z = -4;
    station.send(home);
    QVERIFY(std::abs(station.last<HomePosition>().altitude - 586'000) < 20);
    home.frame = MAV_FRAME_LOCAL_NED;
    QCOMPARE(station.resultOf(home), int(MAV_RESULT_FAILED));
}

void SimVehicleTest::stationLossReturns()
{
    TestStation station;
    QVERIFY(station.takeOff(10));
    station.silent = true;
    const TimePoint begin = station.now;
    QVERIFY(station.until([&] { return station.vehicle.autopilot().modes().current() == FlightMode::Rtl; }, 10));
    QVERIFY(station.now - begin > 3900ms && station.now - begin < 5300ms); // FS_GCS_TIMEOUT since the last heartbeat
    QVERIFY(station.said("GCS Failsafe - RTL"));
    station.run(1.5);
    QCOMPARE(int(station.last<mavlink::Heartbeat>().system_status), int(MAV_STATE_CRITICAL));
    station.silent = false;
    station.run(2);
    QVERIFY(station.said("GCS Failsafe Cleared"));
    QCOMPARE(station.last<mavlink::Heartbeat>().custom_mode, 6u); // it stays in RTL until told otherwise

    TestStation late; // silent before it armed: no reason to fly off without a station
    late.run(6);
    late.silent = true;
    late.run(7);
    QCOMPARE(late.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}), int(MAV_RESULT_ACCEPTED));
    late.run(1);
    QVERIFY(!late.vehicle.autopilot().armed());

    TestStation alone; // a vehicle that never heard a station has nothing to lose
    alone.silent = true;
    alone.run(6);
    QCOMPARE(alone.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}), int(MAV_RESULT_ACCEPTED));
    alone.run(8);
    QVERIFY(alone.vehicle.autopilot().armed());
}

void SimVehicleTest::sticksFly()
{
    TestStation station;
    station.run(6);
    QCOMPARE(station.command(MAV_CMD_DO_SET_MODE, {1, 2}), int(MAV_RESULT_ACCEPTED));
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}), int(MAV_RESULT_ACCEPTED));
    ManualControl sticks;
    sticks.target = 1;
    sticks.z = 800;
    for (int i = 0; i < 40; ++i) {
        station.send(sticks);
        station.run(0.1);
    }
    QVERIFY(station.last<GlobalPositionInt>().relative_alt > 1500);
    RcChannelsOverride channels;
    channels.target_system = 1;
    channels.chan1_raw = 1600;
    channels.chan2_raw = channels.chan4_raw = 1500;
    channels.chan3_raw = 1500;
    for (int i = 0; i < 15; ++i) {
        station.send(channels);
        station.run(0.1);
    }
    QVERIFY(station.last<mavlink::Attitude>().roll > 0.05f);
    QCOMPARE(int(station.last<mavlink::RcChannels>().chan1_raw), 1600);
    station.run(4); // nobody renews it
    QCOMPARE(int(station.last<mavlink::RcChannels>().chan1_raw), 1500);
    station.writer = FrameWriter(42, 190); // another station may not take the sticks
    station.send(channels);
    station.run(0.5);
    QCOMPARE(int(station.last<mavlink::RcChannels>().chan1_raw), 1500);
}

SKYSEAL_TEST_APPLESS(SimVehicleTest)
#include "vehicle_test.moc"
