// Aircraft that the vehicle's ADS-B receiver reports: units, what is not known, age, and the bound of the list.
#include "tests/support/test_runner.h"
#include "core/vehicle/traffic.h"
#include "vehicle_harness.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace skyseal;
using namespace skyseal::vehicle;

namespace {

mavlink::AdsbVehicle reportOf(std::uint32_t address, double latitude = 47.4, double longitude = 8.55)
{
    mavlink::AdsbVehicle out;
    out.ICAO_address = address;
    out.lat = static_cast<std::int32_t>(std::lround(latitude * 1e7));
    out.lon = static_cast<std::int32_t>(std::lround(longitude * 1e7));
    out.altitude = 620'500;
    out.heading = 27'050;
    out.hor_velocity = 6'150;
    out.ver_velocity = -250;
    mavlink::setText(out.callsign, "SWR12A  ");
    out.flags = mavlink::ADSB_FLAGS_VALID_COORDS | mavlink::ADSB_FLAGS_VALID_ALTITUDE | mavlink::ADSB_FLAGS_VALID_HEADING
        | mavlink::ADSB_FLAGS_VALID_VELOCITY | mavlink::ADSB_FLAGS_VALID_CALLSIGN | mavlink::ADSB_FLAGS_VERTICAL_VELOCITY_VALID;
    return out;
}

mavlink::GlobalPositionInt ownPosition()
{
    mavlink::GlobalPositionInt out;
    out.lat = 474'000'000;
    out.lon = 85'000'000;
    out.alt = 500'000;
    return out;
}

} // namespace

class TrafficTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void reportInItsUnits()
    {
        Harness h = Harness::copter();
        h.feed(reportOf(0x4b1805));
        const auto traffic = h.vehicle.state(h.now).traffic;
        QCOMPARE(traffic.size(), std::size_t(1));
        const Aircraft &one = traffic.front();
        QCOMPARE(one.address, 0x4b1805u);
        QCOMPARE(one.callsign, std::string("SWR12A"));
        QCOMPARE(one.position.latitude, 47.4);
        QCOMPARE(one.position.longitude, 8.55);
        QCOMPARE(one.position.altitude, 620.5);
        QCOMPARE(one.heading, 270.5);
        QCOMPARE(one.groundSpeed, 61.5);
        QCOMPARE(one.climb, -2.5);
        QVERIFY(!one.simulated);
    }

    /// The receiver is a component of its own (mavlink::MAV_COMP_ID_ADSB) where the autopilot does not pass its reports on.
    void reportOfTheReceiver()
    {
        Harness h = Harness::copter();
        Sender receiver(1, mavlink::MAV_COMP_ID_ADSB);
        h.vehicle.handleFrame(h.now, {}, receiver.frame(reportOf(7)));
        QCOMPARE(h.vehicle.state(h.now).traffic.size(), std::size_t(1));
    }

    void whatIsNotKnown()
    {
        mavlink::AdsbVehicle report = reportOf(7);
        report.flags = 0;
        Harness h = Harness::copter();
        h.feed(report);
        report = reportOf(8, 90.5, 8);
        report.altitude = std::numeric_limits<std::int32_t>::max();
        report.heading = 36'001;
        report.hor_velocity = std::numeric_limits<std::uint16_t>::max();
        report.ver_velocity = std::numeric_limits<std::int16_t>::max();
        mavlink::setText(report.callsign, "\xff\n ");
        h.feed(report);
        const auto traffic = h.vehicle.state(h.now).traffic;
        QCOMPARE(traffic.size(), std::size_t(2));
        for (const Aircraft &one : traffic) {
            QVERIFY(!one.position.known());
            QVERIFY(std::isnan(one.position.altitude) && std::isnan(one.heading) && std::isnan(one.groundSpeed));
            QVERIFY(std::isnan(one.climb));
            QVERIFY(one.callsign.empty());
        }
    }

    void newerReportReplacesTheOlderOne()
    {
        Harness h = Harness::copter();
        h.feed(reportOf(7));
        h.now += std::chrono::seconds(10);
        QCOMPARE(h.vehicle.state(h.now).traffic.front().age, 10.0);
        h.feed(reportOf(7, 47.5));
        const auto traffic = h.vehicle.state(h.now).traffic;
        QCOMPARE(traffic.size(), std::size_t(1));
        QCOMPARE(traffic.front().position.latitude, 47.5);
        QCOMPARE(traffic.front().age, 0.0);
    }

    void silentOnesAreForgotten()
    {
        Harness h = Harness::copter();
        h.feed(reportOf(7));
        mavlink::AdsbVehicle old = reportOf(8);
        old.tslc = 12; // the receiver itself heard it so long ago
        h.feed(old);
        h.now += std::chrono::milliseconds(17'900);
        QCOMPARE(h.vehicle.state(h.now).traffic.size(), std::size_t(2));
        h.now += std::chrono::milliseconds(200);
        QCOMPARE(h.vehicle.state(h.now).traffic.size(), std::size_t(1));
        h.now += std::chrono::seconds(12);
        QVERIFY(h.vehicle.state(h.now).traffic.empty());
        old.tslc = 30;
        h.feed(old);
        QVERIFY(h.vehicle.state(h.now).traffic.empty());
    }

    void nearestOnesAreKept()
    {
        Harness h = Harness::copter();
        h.feed(ownPosition());
        for (std::uint32_t i = 0; i < 2 * Traffic::kMost; ++i)
            h.feed(reportOf(1000 + i, 47.5 + 0.01 * i));
        QCOMPARE(h.vehicle.state(h.now).traffic.size(), Traffic::kMost);
        const auto has = [&h](std::uint32_t address) {
            const auto traffic = h.vehicle.state(h.now).traffic;
            return std::ranges::find(traffic, address, &Aircraft::address) != traffic.end();
        };
        QVERIFY(has(1000) && has(1000 + Traffic::kMost - 1) && !has(1000 + Traffic::kMost));
        h.feed(reportOf(1, 47.41)); // nearer than all
        QVERIFY(has(1) && has(1000) && !has(1000 + Traffic::kMost - 1));
        QCOMPARE(h.vehicle.state(h.now).traffic.size(), Traffic::kMost);
    }

    void forgottenOnesMakeRoom()
    {
        Harness h = Harness::copter();
        for (std::uint32_t i = 0; i < Traffic::kMost; ++i)
            h.feed(reportOf(1000 + i));
        h.feed(reportOf(1)); // without a place of the vehicle
        QCOMPARE(h.vehicle.state(h.now).traffic.size(), Traffic::kMost);
        h.now += Traffic::kForgottenAfter;
        h.feed(reportOf(1));
        const auto traffic = h.vehicle.state(h.now).traffic;
        QCOMPARE(traffic.size(), std::size_t(1));
        QCOMPARE(traffic.front().address, 1u);
    }
};

SKYSEAL_TEST(TrafficTest)
#include "traffic_test.moc"
