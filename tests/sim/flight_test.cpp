// Whole flights in simulated time: times, heights and places that a pilot would find believable, and the refusals.
#include "tests/sim/test_flight.h"
#include "tests/support/test_runner.h"

#include "core/mavlink/enums.h"

#include <QtTest/QTest>

using namespace skyseal::sim;

class SimFlightTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void guidedFlightAndReturn();
    void landsAndDisarms();
    void holdsItsPlaceInWind();
    void manualModesFollowTheSticks();
    void refusesWhatIsNotSafe();
    void idleOnTheGroundDisarms();
    void forcedDisarmFalls();
    void batteryRunsLowAndReturns();
    void losesGpsAndLands();
    void fliesAMission();
    void missionNeedsATakeOff();
    void jumpsEnd();
};

void SimFlightTest::guidedFlightAndReturn()
{
    TestFlight flight;
    Autopilot &a = flight.autopilot;
    QVERIFY(flight.airborne(10));
    QVERIFY(flight.until([&] { return std::abs(a.estimate().climb()) < 0.1 && a.heightAboveHome() > 9.7; }, 10) >= 0);
    flight.run(5);
    QVERIFY2(flight.highest < 10.4, qPrintable(QString::number(flight.highest)));

    QVERIFY(!a.requests().goTo({50, 0, -10}));
    double fastest = 0, furthest = 0;
    const double taken = flight.until(
        [&] {
            fastest = std::max(fastest, a.estimate().velocity.horizontal());
            furthest = std::max(furthest, a.estimate().position.x);
            return std::abs(a.estimate().position.x - 50) < 0.5 && a.estimate().velocity.horizontal() < 0.3;
        },
        30);
    QVERIFY2(taken > 10 && taken < 18, qPrintable(QString::number(taken))); // 50 m at 5 m/s, and braking
    QVERIFY2(fastest > 4.7 && fastest < 5.5, qPrintable(QString::number(fastest)));
    QVERIFY(furthest < 51);
    QVERIFY(std::abs(degrees(a.estimate().attitude.euler().yaw)) < 6); // looks where it flew

    QVERIFY(!a.requests().enterMode(FlightMode::Rtl));
    QVERIFY(flight.until([&] { return a.heightAboveHome() > 14.5; }, 15) >= 0); // RTL_ALT
    QVERIFY(flight.until([&] { return !a.armed(); }, 90) >= 0);
    QVERIFY(a.landed());
    QVERIFY(std::hypot(a.truth().position.x, a.truth().position.y) < 1.5);
    QVERIFY(!flight.said("SIM Hit ground"));
    QVERIFY(flight.finite);
    QVERIFY(a.flight().physics.battery().percent() > 85 && a.flight().physics.battery().percent() < 96);
}

void SimFlightTest::landsAndDisarms()
{
    TestFlight flight;
    QVERIFY(flight.airborne(8));
    QVERIFY(!flight.autopilot.requests().enterMode(FlightMode::Land));
    const double taken = flight.until([&] { return !flight.autopilot.armed(); }, 60);
    QVERIFY2(taken > 12 && taken < 25,
             qPrintable(QString::number(taken))); // half a metre a second, and a second of certainty
    QVERIFY(flight.said("Disarming motors"));
}

void SimFlightTest::holdsItsPlaceInWind()
{
    TestFlight flight;
    flight.autopilot.parameters().set("SIM_WIND_SPD", 8);
    QVERIFY(flight.airborne(10));
    flight.run(10);
    double furthest = 0;
    for (int i = 0; i < 300; ++i) {
        flight.run(0.1);
        furthest = std::max(furthest, flight.autopilot.truth().position.horizontal());
    }
    QVERIFY2(furthest < 1.5, qPrintable(QString::number(furthest)));
    const double lean = degrees(std::acos(flight.autopilot.truth().attitude.cosTilt()));
    QVERIFY2(lean > 2 && lean < 20, qPrintable(QString::number(lean))); // it leans into the wind
}

void SimFlightTest::manualModesFollowTheSticks()
{
    TestFlight flight;
    Autopilot &a = flight.autopilot;
    flight.run(6);
    QVERIFY(!a.requests().enterMode(FlightMode::AltHold));
    QVERIFY(!a.arming().arm(false));
    const skyseal::TimePoint now{};
    a.flight().pilot.manual(now, {0, 0, 0, 0.8});
    flight.run(6);
    QVERIFY2(a.heightAboveHome() > 4, qPrintable(QString::number(a.heightAboveHome())));
    a.flight().pilot.manual(now, {0, 0, 0, 0.5});
    flight.run(4);
    const double held = a.heightAboveHome();
    flight.run(10);
    QVERIFY(std::abs(a.heightAboveHome() - held) < 0.5);

    a.flight().pilot.manual(now, {0.5, 0, 0, 0.5});
    flight.run(1.5);
    QVERIFY(std::abs(degrees(a.estimate().attitude.euler().roll) - 15) < 3); // half of ANGLE_MAX
    a.flight().pilot.manual(now, {0, 0, 0, 0.5});
    QVERIFY(!a.requests().enterMode(FlightMode::Loiter));
    flight.run(8);
    QVERIFY(a.estimate().velocity.horizontal() < 0.4);
    a.flight().pilot.manual(now, {0, -0.4, 0, 0.5}); // stick forward
    flight.run(6);
    QVERIFY(a.estimate().velocity.horizontal() > 3);
    a.flight().pilot.manual(now, {0, 0, 0.5, 0.5});
    QVERIFY(!a.requests().enterMode(FlightMode::Stabilize));
    const double yaw = a.estimate().attitude.euler().yaw;
    flight.run(1.5);
    QVERIFY(wrapPi(a.estimate().attitude.euler().yaw - yaw) > 0.4);
    QVERIFY(flight.finite);
}

void SimFlightTest::refusesWhatIsNotSafe()
{
    TestFlight flight;
    Autopilot &a = flight.autopilot;
    QVERIFY(a.arming().arm(false)->find("PreArm: ") == 0);
    flight.run(2);
    QVERIFY(a.requests().enterMode(FlightMode::Guided)->find("requires position") != std::string::npos);
    QVERIFY(!a.arming().preArm()); // STABILIZE needs no position
    flight.run(4);
    QVERIFY(!a.requests().enterMode(FlightMode::Guided));
    QVERIFY(a.requests().takeOff(10)); // not armed
    QVERIFY(!a.requests().enterMode(FlightMode::Rtl));
    QVERIFY(a.arming().arm(false)->find("mode not armable") != std::string::npos);
    QVERIFY(!a.requests().enterMode(FlightMode::Stabilize));
    a.flight().pilot.manual({}, {0, 0, 0, 0.7});
    QVERIFY(a.arming().arm(false)->find("Throttle too high") != std::string::npos);
    a.flight().pilot.releaseAll();
    QVERIFY(!a.requests().enterMode(FlightMode::Guided));
    a.parameters().set("SIM_GPS_DISABLE", 1);
    flight.run(1);
    QCOMPARE(*a.arming().arm(false), std::string("PreArm: GPS 1: Bad fix"));
    a.parameters().set("SIM_GPS_DISABLE", 0);
    flight.run(6);
    QVERIFY(!a.arming().arm(false));
    QVERIFY(a.requests().takeOff(std::nan("")));
    QVERIFY(a.requests().takeOff(-5));
    QVERIFY(!a.requests().takeOff(5));
    flight.run(6);
    QVERIFY(a.requests().takeOff(5));  // flying already
    QVERIFY(a.arming().disarm(false)); // in the air
    QVERIFY(a.requests().goTo({1e9, 0, 0}));
    QVERIFY(a.armed());
    QVERIFY(!a.requests().enterMode(FlightMode::Loiter));
    QVERIFY(a.requests().goTo({10, 0, -5})); // only in GUIDED
}

void SimFlightTest::idleOnTheGroundDisarms()
{
    TestFlight flight;
    flight.run(6);
    QVERIFY(!flight.autopilot.requests().enterMode(FlightMode::Guided));
    QVERIFY(!flight.autopilot.arming().arm(false));
    const double taken = flight.until([&] { return !flight.autopilot.armed(); }, 30);
    QVERIFY2(taken > 9.5 && taken < 11, qPrintable(QString::number(taken))); // DISARM_DELAY
}

void SimFlightTest::forcedDisarmFalls()
{
    TestFlight flight;
    QVERIFY(flight.airborne(10));
    QVERIFY(!flight.autopilot.arming().disarm(true));
    flight.run(3);
    QVERIFY(flight.autopilot.landed());
    QVERIFY(flight.said("SIM Hit ground at 1")); // some 13 m/s
}

void SimFlightTest::batteryRunsLowAndReturns()
{
    TestFlight flight;
    flight.autopilot.parameters().set("BATT_LOW_MAH", 3200);
    flight.autopilot.parameters().set("BATT_FS_LOW_ACT", 2);
    QVERIFY(flight.airborne(10));
    QVERIFY(flight.until([&] { return flight.autopilot.modes().current() == FlightMode::Rtl; }, 60) >= 0);
    QVERIFY(flight.said("Battery 1 is low"));
    QVERIFY(flight.said("Battery Failsafe - RTL"));
    QVERIFY(flight.autopilot.arming().preArm()); // not again with this battery
}

void SimFlightTest::losesGpsAndLands()
{
    TestFlight flight;
    QVERIFY(flight.airborne(6));
    flight.autopilot.parameters().set("SIM_GPS_DISABLE", 1);
    QVERIFY(flight.until([&] { return flight.autopilot.modes().current() == FlightMode::Land; }, 10) >= 0);
    QVERIFY(flight.said("EKF Failsafe - LAND"));
    QVERIFY(flight.until([&] { return !flight.autopilot.armed(); }, 40) >= 0);
}

namespace {

StoredItem item(std::uint16_t command, const Autopilot &a, double north, double east, float height)
{
    const GeoPoint place = a.flight().world.toGeo({north, east, 0});
    StoredItem out;
    out.frame = 3;
    out.command = command;
    out.x = static_cast<std::int32_t>(std::lround(place.latitude * 1e7));
    out.y = static_cast<std::int32_t>(std::lround(place.longitude * 1e7));
    out.z = height;
    return out;
}

} // namespace

void SimFlightTest::fliesAMission()
{
    using namespace skyseal::mavlink;
    TestFlight flight;
    Autopilot &a = flight.autopilot;
    QVERIFY(flight.until([&] { return a.estimate().positionOk; }, 10) >= 0);
    StoredItem fast = item(MAV_CMD_DO_CHANGE_SPEED, a, 0, 0, 0);
    fast.parameters = {1, 8, -1, 0};
    StoredItem wait = item(MAV_CMD_NAV_LOITER_TIME, a, 40, 20, 12);
    wait.parameters[0] = 3;
    a.modes().mission().load({item(MAV_CMD_NAV_WAYPOINT, a, 0, 0, 0), item(MAV_CMD_NAV_TAKEOFF, a, 0, 0, 12), fast,
                              item(MAV_CMD_NAV_WAYPOINT, a, 40, 0, 12), wait, item(MAV_CMD_NAV_LAND, a, 10, 10, 0)});
    QVERIFY(!a.requests().enterMode(FlightMode::Guided));
    QVERIFY(!a.arming().arm(false));
    QVERIFY(!a.requests().startMission());
    std::vector<int> reached;
    double fastest = 0;
    const double taken = flight.until(
        [&] {
            if (const auto sequence = a.modes().mission().takeReached())
                reached.push_back(*sequence);
            fastest = std::max(fastest, a.estimate().velocity.horizontal());
            return !a.armed();
        },
        150);
    QVERIFY(taken > 0);
    QCOMPARE(reached, (std::vector<int>{1, 3, 4, 5}));
    QVERIFY(fastest > 5.5);
    QVERIFY(std::hypot(a.truth().position.x - 10, a.truth().position.y - 10) < 1.5);
}

void SimFlightTest::missionNeedsATakeOff()
{
    using namespace skyseal::mavlink;
    TestFlight flight;
    Autopilot &a = flight.autopilot;
    flight.run(6);
    QVERIFY(a.requests().enterMode(FlightMode::Auto)); // none at all
    a.modes().mission().load({item(MAV_CMD_NAV_WAYPOINT, a, 0, 0, 0), item(MAV_CMD_NAV_WAYPOINT, a, 40, 0, 12)});
    QVERIFY(a.requests().enterMode(FlightMode::Auto)->find("Missing Takeoff") != std::string::npos);
    QVERIFY(flight.airborne(5));
    QVERIFY(!a.requests().enterMode(FlightMode::Auto));
    flight.run(12);
    QVERIFY(std::abs(a.estimate().position.x - 40) < 4);
}

void SimFlightTest::jumpsEnd()
{
    using namespace skyseal::mavlink;
    TestFlight flight;
    Autopilot &a = flight.autopilot;
    QVERIFY(flight.airborne(10));
    StoredItem twice = item(MAV_CMD_DO_JUMP, a, 0, 0, 0);
    twice.parameters = {1, 2, 0, 0};
    StoredItem forever = item(MAV_CMD_DO_JUMP, a, 0, 0, 0);
    forever.parameters = {3, -1, 0, 0};
    a.modes().mission().load({item(MAV_CMD_NAV_WAYPOINT, a, 0, 0, 0), item(MAV_CMD_NAV_WAYPOINT, a, 0, 5, 10), twice, forever});
    QVERIFY(!a.requests().enterMode(FlightMode::Auto));
    int visits = 0;
    QVERIFY(flight.until(
                [&] {
                    visits += a.modes().mission().takeReached() ? 1 : 0;
                    return a.modes().mission().finished();
                },
                120)
            >= 0);
    QCOMPARE(visits, 3);
    QVERIFY(a.armed());
}

SKYSEAL_TEST_APPLESS(SimFlightTest)
#include "flight_test.moc"
