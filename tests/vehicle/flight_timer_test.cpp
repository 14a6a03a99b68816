// Whether the station saw the take-off of a flight, and whether a vehicle is in the air.
#include "tests/support/test_runner.h"
#include "vehicle_harness.h"

using namespace skyseal;
using namespace skyseal::vehicle;

class FlightTimerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takeOffIsSeenOrNot_data()
    {
        QTest::addColumn<double>("first"); // altitude
        QTest::addColumn<bool>("armed");   // at first
        QTest::addColumn<int>("landed");   // MAV_LANDED_STATE, 0: never
        QTest::addColumn<bool>("seen");
        QTest::newRow("from the ground") << 0.1 << true << 0 << true;
        QTest::newRow("armed later, on a hill") << 8. << false << 0 << true;
        QTest::newRow("in the air") << 20. << true << 0 << false;
        QTest::newRow("in the air, it says") << 0.2 << true << int(mavlink::MAV_LANDED_STATE_IN_AIR) << false;
        QTest::newRow("on a hill, it says") << 8. << true << int(mavlink::MAV_LANDED_STATE_ON_GROUND) << true;
    }

    /// As when the station starts during a flight.
    void takeOffIsSeenOrNot()
    {
        QFETCH(double, first);
        QFETCH(bool, armed);
        QFETCH(int, landed);
        Harness h = Harness::copter(4, armed);
        mavlink::ExtendedSysState extended;
        extended.landed_state = static_cast<std::uint8_t>(landed);
        h.feed(extended);
        mavlink::GlobalPositionInt position;
        position.relative_alt = static_cast<std::int32_t>(first * 1000);
        h.feed(position);
        QCOMPARE(h.vehicle.state(h.now).inAir, armed && landed != mavlink::MAV_LANDED_STATE_ON_GROUND && (landed || first > 1));
        h.feed(heartbeat(4, true));
        if (landed)
            extended.landed_state = mavlink::MAV_LANDED_STATE_IN_AIR;
        h.feed(extended);
        position.relative_alt = 30'000;
        h.feed(position);
        QVERIFY(h.vehicle.state(h.now).inAir);
        QTEST(h.vehicle.state(h.now).takeOffSeen, "seen");
        // The next flight is seen from its beginning.
        h.feed(heartbeat(4, false));
        QVERIFY(!h.vehicle.state(h.now).inAir);
        h.feed(heartbeat(4, true));
        h.feed(position);
        QVERIFY(h.vehicle.state(h.now).takeOffSeen);
    }
};

SKYSEAL_TEST_APPLESS(FlightTimerTest)
#include "flight_timer_test.moc"
