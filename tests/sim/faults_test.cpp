// Faults on command: each SIM_ parameter breaks one thing, the station is told, and the vehicle does what its failsafe says.
#include "tests/sim/test_station.h"
#include "tests/support/test_runner.h"

#include "core/mavlink/enums.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::sim;
using namespace skyseal::mavlink;

class SimFaultsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void gpsLossLandsAndComesBack();
    void smallGlitchIsFollowed();
    void glitchIsRefusedThenFollowed();
    void compassFailureIsTold();
    void variancesTogetherAreAFailsafe_data();
    void variancesTogetherAreAFailsafe();
    void pressureFailureIsTold();
    void batteryFailsafe_data();
    void batteryFailsafe();
    void batteryRecharges();
    void radioFailsafe_data();
    void radioFailsafe();
    void radioComesBack();
    void overridesReplaceTheRadio();
    void radioLossPreventsArming();
    void motorFailureCrashes();
    void weakMotorIsFlown();
    void nothingIsBrokenByDefault();
};

namespace {

bool healthy(TestStation &station, std::uint32_t sensor)
{
    station.forget();
    station.run(0.6);
    return (station.last<SysStatus>().onboard_control_sensors_health & sensor) != 0;
}

} // namespace

void SimFaultsTest::gpsLossLandsAndComesBack()
{
    TestStation station;
    QVERIFY(station.loiter(10));
    station.setParameter("SIM_GPS_DISABLE", 1);
    QVERIFY(station.until([&] { return station.mode() == FlightMode::Land; }, 10));
    station.run(0.5);
    QVERIFY(station.said("EKF Failsafe - LAND"));
    QVERIFY(!healthy(station, MAV_SYS_STATUS_SENSOR_GPS));
    QCOMPARE(int(station.last<GpsRawInt>().fix_type), int(GPS_FIX_TYPE_NO_FIX));
    station.setParameter("SIM_GPS_DISABLE", 0);
    QVERIFY(station.until([&] { return station.vehicle.autopilot().estimate().positionOk; }, 20));
    QVERIFY(healthy(station, MAV_SYS_STATUS_SENSOR_GPS));
    QCOMPARE(station.command(MAV_CMD_DO_SET_MODE, {1, 5}), int(MAV_RESULT_ACCEPTED));
}

void SimFaultsTest::smallGlitchIsFollowed()
{
    TestStation station;
    QVERIFY(station.loiter(10));
    station.run(3);
    const double before = station.vehicle.autopilot().truth().position.x;
    station.setParameter("SIM_GPS_GLITCH_X", 0.0001f); // 11 m
    station.run(12);
    const double moved = station.vehicle.autopilot().truth().position.x - before; // it holds what it believes
    QVERIFY2(std::abs(moved + 11.1) < 2, qPrintable(QString::number(moved)));
    QVERIFY(!station.said("GPS Glitch"));
    QVERIFY(station.mode() == FlightMode::Loiter);
}

void SimFaultsTest::glitchIsRefusedThenFollowed()
{
    TestStation station;
    QVERIFY(station.loiter(10));
    station.run(3);
    const Vector3 before = station.vehicle.autopilot().truth().position;
    station.setParameter("SIM_GPS_GLITCH_Y", 0.0005f); // 45 m at this latitude
    station.run(5);
    QVERIFY(station.said("GPS Glitch or Compass error"));
    QVERIFY(station.last<EkfStatusReport>().flags & EKF_GPS_GLITCHING);
    QVERIFY(station.last<EkfStatusReport>().pos_horiz_variance > 1);
    QVERIFY((station.vehicle.autopilot().truth().position - before).horizontal() < 2);
    QVERIFY(station.mode() == FlightMode::Loiter); // the position alone is no failsafe
    station.run(25);
    QVERIFY(station.said("Glitch cleared"));
    const double moved = station.vehicle.autopilot().truth().position.y - before.y;
    QVERIFY2(std::abs(moved + 45.4) < 3, qPrintable(QString::number(moved)));
}

void SimFaultsTest::compassFailureIsTold()
{
    TestStation station;
    station.run(6);
    QVERIFY(healthy(station, MAV_SYS_STATUS_SENSOR_3D_MAG));
    station.setParameter("SIM_MAG1_FAIL", 1);
    QVERIFY(!healthy(station, MAV_SYS_STATUS_SENSOR_3D_MAG));
    QCOMPARE(station.last<RawImu>().xmag, std::int16_t(0));
    QVERIFY(station.last<EkfStatusReport>().compass_variance >= 1);
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}), int(MAV_RESULT_FAILED));
    QVERIFY(station.said("PreArm: Compass not healthy"));
    station.setParameter("SIM_MAG1_FAIL", 0);
    QVERIFY(healthy(station, MAV_SYS_STATUS_SENSOR_3D_MAG));
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}), int(MAV_RESULT_ACCEPTED));
}

void SimFaultsTest::variancesTogetherAreAFailsafe_data()
{
    QTest::addColumn<int>("action");
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("to");
    QTest::newRow("land") << 1 << int(FlightMode::Loiter) << int(FlightMode::Land);
    QTest::newRow("hold altitude") << 2 << int(FlightMode::Loiter) << int(FlightMode::AltHold);
    QTest::newRow("without position nothing") << 1 << int(FlightMode::AltHold) << int(FlightMode::AltHold);
    QTest::newRow("land always") << 3 << int(FlightMode::AltHold) << int(FlightMode::Land);
}

void SimFaultsTest::variancesTogetherAreAFailsafe()
{
    QFETCH(int, action);
    QFETCH(int, from);
    QFETCH(int, to);
    TestStation station;
    QVERIFY(station.loiter(10));
    QCOMPARE(station.command(MAV_CMD_DO_SET_MODE, {1, static_cast<float>(from)}), int(MAV_RESULT_ACCEPTED));
    station.setParameter("FS_EKF_ACTION", static_cast<float>(action));
    station.setParameter("SIM_MAG1_FAIL", 1);
    station.run(3);
    QCOMPARE(int(station.mode()), from); // the compass alone is none
    station.setParameter("SIM_GPS_GLITCH_X", 0.001f);
    station.run(0.7);
    QCOMPARE(int(station.mode()), from); // not at once
    station.run(1);
    QCOMPARE(int(station.mode()), to);
    QVERIFY(station.said("EKF variance"));
    QCOMPARE(station.vehicle.autopilot().failsafes().active(), from != to || action == 3);
    station.setParameter("SIM_MAG1_FAIL", 0);
    station.run(1);
    QVERIFY(!station.vehicle.autopilot().failsafes().active());
    QCOMPARE(station.said("EKF Failsafe Cleared"), from != to);
}

void SimFaultsTest::pressureFailureIsTold()
{
    TestStation station;
    station.run(6);
    station.setParameter("SIM_BARO_DISABLE", 1);
    QVERIFY(!healthy(station, MAV_SYS_STATUS_SENSOR_ABSOLUTE_PRESSURE));
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}), int(MAV_RESULT_FAILED));
    QVERIFY(station.said("PreArm: Barometer not healthy"));
}

void SimFaultsTest::batteryFailsafe_data()
{
    QTest::addColumn<float>("voltage");
    QTest::addColumn<int>("mode");
    QTest::newRow("low") << 10.6f << int(FlightMode::Rtl);
    QTest::newRow("critical") << 9.7f << int(FlightMode::Land);
}

void SimFaultsTest::batteryFailsafe()
{
    QFETCH(float, voltage);
    QFETCH(int, mode);
    TestStation station;
    station.setParameter("BATT_FS_LOW_ACT", 2);
    station.setParameter("BATT_CRT_VOLT", 9.8f);
    station.setParameter("BATT_FS_CRT_ACT", 1);
    QVERIFY(station.loiter(10));
    station.setParameter("SIM_BATT_VOLTAGE", voltage);
    station.run(2);
    QVERIFY(std::abs(station.last<SysStatus>().voltage_battery / 1000.0 - static_cast<double>(voltage)) < 0.5);
    QVERIFY(station.last<SysStatus>().battery_remaining < 6);
    QVERIFY(station.mode() == FlightMode::Loiter); // BATT_LOW_TIMER
    QVERIFY(station.until([&] { return int(station.mode()) == mode; }, 20));
    station.run(0.2);
    QVERIFY(station.said("Battery Failsafe"));
    QVERIFY(!healthy(station, MAV_SYS_STATUS_SENSOR_BATTERY));
}

void SimFaultsTest::batteryRecharges()
{
    Battery battery(3300);
    for (const double voltage : {11.0, 12.6, 9.6, 11.3, 12.0}) {
        battery.setRestVoltage(voltage);
        for (int i = 0; i < 400; ++i)
            battery.step(0.01, 0, false);
        QVERIFY2(std::abs(battery.voltage() - voltage) < 0.05, qPrintable(QString::number(battery.voltage())));
    }
    battery.setRestVoltage(0);
    QCOMPARE(battery.percent(), 0.0);
    battery.setRestVoltage(99);
    QCOMPARE(battery.percent(), 100.0);
}

void SimFaultsTest::radioFailsafe_data()
{
    QTest::addColumn<int>("fault");
    QTest::addColumn<int>("action");
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("options");
    QTest::addColumn<int>("to");
    const int loiter = int(FlightMode::Loiter), guided = int(FlightMode::Guided), rtl = int(FlightMode::Rtl),
              land = int(FlightMode::Land);
    QTest::newRow("silent, return") << 1 << 1 << loiter << 16 << rtl;
    QTest::newRow("low throttle, return") << 2 << 1 << loiter << 16 << rtl;
    QTest::newRow("silent, land") << 1 << 3 << loiter << 16 << land;
    QTest::newRow("silent, smart or land") << 1 << 5 << loiter << 16 << land;
    QTest::newRow("silent, ignored") << 1 << 0 << loiter << 16 << loiter;
    QTest::newRow("guided returns") << 1 << 1 << guided << 16 << rtl;
    QTest::newRow("guided goes on") << 1 << 1 << guided << 4 << guided;
}

void SimFaultsTest::radioFailsafe()
{
    QFETCH(int, fault);
    QFETCH(int, action);
    QFETCH(int, from);
    QFETCH(int, options);
    QFETCH(int, to);
    TestStation station;
    QVERIFY(station.loiter(10));
    QCOMPARE(station.command(MAV_CMD_DO_SET_MODE, {1, static_cast<float>(from)}), int(MAV_RESULT_ACCEPTED));
    station.setParameter("FS_THR_ENABLE", static_cast<float>(action));
    station.setParameter("FS_OPTIONS", static_cast<float>(options));
    QVERIFY(healthy(station, MAV_SYS_STATUS_SENSOR_RC_RECEIVER));
    station.setParameter("SIM_RC_FAIL", static_cast<float>(fault));
    station.run(1.5);
    QCOMPARE(int(station.mode()), to);
    QCOMPARE(station.said("Radio Failsafe - "), action != 0);
    QVERIFY(!healthy(station, MAV_SYS_STATUS_SENSOR_RC_RECEIVER));
    if (fault == 2)
        QCOMPARE(int(station.last<RcChannels>().chan3_raw), 950);
}

void SimFaultsTest::radioComesBack()
{
    TestStation station;
    QVERIFY(station.loiter(10));
    station.setParameter("SIM_RC_FAIL", 1);
    station.run(2);
    QVERIFY(station.vehicle.autopilot().failsafes().active());
    QCOMPARE(int(station.last<mavlink::Heartbeat>().system_status), int(MAV_STATE_CRITICAL));
    station.setParameter("SIM_RC_FAIL", 0);
    station.run(1.2);
    QVERIFY(station.said("Radio Failsafe Cleared"));
    QCOMPARE(int(station.last<mavlink::Heartbeat>().system_status), int(MAV_STATE_ACTIVE));
    QVERIFY(station.mode() == FlightMode::Rtl); // it goes on with what it began
}

void SimFaultsTest::overridesReplaceTheRadio()
{
    TestStation station;
    QVERIFY(station.loiter(10));
    ManualControl sticks;
    sticks.target = 1;
    sticks.z = 500;
    station.send(sticks);
    station.setParameter("SIM_RC_FAIL", 1);
    for (int i = 0; i < 10; ++i) {
        station.send(sticks);
        station.run(0.5);
    }
    QVERIFY(station.mode() == FlightMode::Loiter);
    station.run(6); // the overrides end
    QVERIFY(station.mode() == FlightMode::Rtl);
}

void SimFaultsTest::radioLossPreventsArming()
{
    TestStation station;
    station.run(6);
    station.setParameter("SIM_RC_FAIL", 2);
    station.run(1);
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}), int(MAV_RESULT_FAILED));
    QVERIFY(station.said("PreArm: Radio failsafe on"));
    station.setParameter("SIM_RC_FAIL", 0);
    station.run(1);
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}), int(MAV_RESULT_ACCEPTED));
}

void SimFaultsTest::motorFailureCrashes()
{
    for (int rotor = 0; rotor < 4; ++rotor) {
        TestStation station;
        QVERIFY(station.loiter(10));
        station.setParameter("SIM_ENGINE_MUL", 0);
        station.setParameter("SIM_ENGINE_FAIL", static_cast<float>(1 << rotor));
        QVERIFY(station.until([&] { return !station.vehicle.autopilot().armed(); }, 20));
        station.run(0.2);
        QVERIFY(station.said("SIM Hit ground"));
        QVERIFY(station.said("Crash: Disarming"));
        QVERIFY(station.vehicle.autopilot().truth().position.finite());
    }
}

void SimFaultsTest::weakMotorIsFlown()
{
    TestStation station;
    QVERIFY(station.loiter(10));
    station.setParameter("SIM_ENGINE_FAIL", 1);
    station.run(1);
    QVERIFY(station.vehicle.autopilot().heightAboveHome() > 9); // the share is still 1
    station.setParameter("SIM_ENGINE_MUL", 0.85f);
    station.run(8);
    QVERIFY(station.vehicle.autopilot().armed());
    QVERIFY(station.vehicle.autopilot().heightAboveHome() > 8);
}

void SimFaultsTest::nothingIsBrokenByDefault()
{
    const Faults none = faults(Parameters(), GeoFrame({-35, 149, 584}));
    QVERIFY(!none.gpsDisabled && !none.compassFailed && !none.pressureFailed);
    QVERIFY(none.gpsGlitch.length() < 1e-6);
    QVERIFY(none.radio == RadioFault::None && none.weakRotors == 0 && none.rotorShare == 1);
    QCOMPARE(none.restVoltage, Faults{}.restVoltage);
}

SKYSEAL_TEST_APPLESS(SimFaultsTest)
#include "faults_test.moc"
