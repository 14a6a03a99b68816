// The reasons for which a vehicle would not arm: which texts count, for how long, and what drops them.
#include "tests/support/test_runner.h"
#include "vehicle_harness.h"

#include "core/vehicle/pre_arm_reasons.h"

using namespace skyseal;
using namespace skyseal::vehicle;

namespace {

using Reasons = std::vector<std::string>;

/// SYS_STATUS of an autopilot that reports the outcome of its checks.
mavlink::SysStatus checks(bool pass)
{
    mavlink::SysStatus out;
    out.onboard_control_sensors_present = mavlink::MAV_SYS_STATUS_PREARM_CHECK | mavlink::MAV_SYS_STATUS_SENSOR_GPS;
    out.onboard_control_sensors_enabled = out.onboard_control_sensors_present;
    if (pass)
        out.onboard_control_sensors_health = mavlink::MAV_SYS_STATUS_PREARM_CHECK;
    return out;
}

Reasons reasonsOf(const Harness &h)
{
    return h.vehicle.state(h.now).preArmReasons;
}

} // namespace

class PreArmTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void textsOfBothAutopilotsCount_data();
    void textsOfBothAutopilotsCount();
    void eachTextIsThereOnce();
    void goesWithoutRepetition();
    void boundedAndTheOldestGivesWay();
    void checksAreUnknownUntilTheVehicleSaysSo();
    void passedChecksDropTheReasons();
    void refusalAfterPassedChecksStays();
    void armingDropsTheReasons();
    void lateStatusChangesNothing();
    void otherComponentsDoNotCount();
    void longTextsAreWhole();
};

void PreArmTest::textsOfBothAutopilotsCount_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("reason");
    const auto row = [](const char *text, const char *reason) { QTest::newRow(text) << text << reason; };
    row("PreArm: Compass not healthy", "Compass not healthy");
    row("Arm: Throttle too high", "Throttle too high");
    row("Preflight Fail: No valid GPS", "No valid GPS");
    row("Arming denied: not landed", "not landed");
    row("Arming motors", "");
    row("PreArm: ", "");
    row("EKF3 IMU0 is using GPS", "");
    row("said PreArm: Compass", "");
}

void PreArmTest::textsOfBothAutopilotsCount()
{
    QFETCH(QString, text);
    QFETCH(QString, reason);
    PreArmReasons reasons;
    reasons.handleText(at(1), text.toStdString());
    QCOMPARE(reasons.at(at(1)), reason.isEmpty() ? Reasons{} : Reasons{reason.toStdString()});
}

void PreArmTest::eachTextIsThereOnce()
{
    PreArmReasons reasons;
    reasons.handleText(at(1), "PreArm: Compass not healthy");
    reasons.handleText(at(2), "PreArm: GPS 1: Bad fix");
    reasons.handleText(at(3), "Arm: Compass not healthy");
    QCOMPARE(reasons.at(at(3)), (Reasons{"Compass not healthy", "GPS 1: Bad fix"})); // in the order of their first time
}

void PreArmTest::goesWithoutRepetition()
{
    PreArmReasons reasons;
    reasons.handleText(at(0), "PreArm: Compass not healthy");
    reasons.handleText(at(10), "PreArm: GPS 1: Bad fix");
    reasons.handleText(at(30), "PreArm: Compass not healthy");
    QCOMPARE(reasons.at(at(49.9)).size(), std::size_t(2));
    QCOMPARE(reasons.at(at(50)), Reasons{"Compass not healthy"});
    QCOMPARE(reasons.at(at(70)), Reasons{});
}

void PreArmTest::boundedAndTheOldestGivesWay()
{
    PreArmReasons reasons;
    const auto say = [&](double time, int number) { reasons.handleText(at(time), "PreArm: check " + std::to_string(number)); };
    for (int i = 0; i < 16; ++i)
        say(i * 0.1, i);
    say(2, 0); // again: 1 is the oldest now
    say(3, 16);
    const Reasons now = reasons.at(at(3));
    QCOMPARE(now.size(), PreArmReasons::kMost);
    QCOMPARE(now.front(), std::string("check 0"));
    QCOMPARE(now[1], std::string("check 2"));
    QCOMPARE(now.back(), std::string("check 16"));
    for (int i = 0; i < 1000; ++i)
        say(4, 100 + i);
    QCOMPARE(reasons.at(at(4)).size(), PreArmReasons::kMost);
}

void PreArmTest::checksAreUnknownUntilTheVehicleSaysSo()
{
    Harness h = Harness::copter();
    h.feed(mavlink::SysStatus{}); // of firmware that has no such bit
    QVERIFY(!h.vehicle.state(h.now).preArmOk);
    h.feed(checks(false));
    QCOMPARE(h.vehicle.state(h.now).preArmOk, std::optional(false));
    h.feed(checks(true));
    QCOMPARE(h.vehicle.state(h.now).preArmOk, std::optional(true));
}

void PreArmTest::passedChecksDropTheReasons()
{
    Harness h = Harness::copter();
    h.feed(checks(false));
    h.feed(statusText("PreArm: Compass not healthy"));
    h.feed(checks(false));
    QCOMPARE(reasonsOf(h), Reasons{"Compass not healthy"});
    h.feed(checks(true));
    QCOMPARE(reasonsOf(h), Reasons{});
}

void PreArmTest::refusalAfterPassedChecksStays()
{
    Harness h = Harness::copter();
    h.feed(checks(true));
    h.feed(statusText("Arm: Throttle too high"));
    h.feed(checks(true));
    QCOMPARE(reasonsOf(h), Reasons{"Throttle too high"});
    h.now += PreArmReasons::kKept;
    QCOMPARE(reasonsOf(h), Reasons{});
}

void PreArmTest::armingDropsTheReasons()
{
    Harness h = Harness::copter();
    h.feed(statusText("PreArm: Compass not healthy"));
    h.feed(heartbeat());
    QCOMPARE(reasonsOf(h), Reasons{"Compass not healthy"});
    h.feed(heartbeat(0, true));
    QCOMPARE(reasonsOf(h), Reasons{});
    h.feed(statusText("PreArm: Compass not healthy")); // means nothing now
    h.feed(heartbeat());
    QCOMPARE(reasonsOf(h), Reasons{});
}

void PreArmTest::lateStatusChangesNothing()
{
    Harness h = Harness::copter();
    h.feed(checks(false));
    h.feed(statusText("PreArm: Compass not healthy"));
    h.vehicle.handleLateFrame(h.now, h.sender.frame(checks(true)));
    QCOMPARE(h.vehicle.state(h.now).preArmOk, std::optional(false));
    QCOMPARE(reasonsOf(h), Reasons{"Compass not healthy"});
}

void PreArmTest::otherComponentsDoNotCount()
{
    Harness h = Harness::copter();
    Sender gimbal(1, mavlink::MAV_COMP_ID_GIMBAL);
    h.vehicle.handleFrame(h.now, {}, gimbal.frame(statusText("Arm: extended")));
    QCOMPARE(h.vehicle.state(h.now).texts.size(), std::size_t(1));
    QCOMPARE(reasonsOf(h), Reasons{});
}

void PreArmTest::longTextsAreWhole()
{
    Harness h = Harness::copter();
    const std::string reason = "Battery 1 below minimum arming voltage, and below minimum arming capacity";
    const std::string text = "PreArm: " + reason;
    h.feed(statusText(text.substr(0, 50), 2, 9, 0));
    QCOMPARE(reasonsOf(h), Reasons{});
    h.feed(statusText(text.substr(50), 2, 9, 1));
    QCOMPARE(reasonsOf(h), Reasons{reason});
}

SKYSEAL_TEST_APPLESS(PreArmTest)
#include "pre_arm_test.moc"
