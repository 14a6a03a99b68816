// Telemetry into state: units, values that mean "not known", frames packed by the reference implementation, and arbitrary
// bytes, which must leave only values that a window can show.
#include "tests/support/test_runner.h"
#include "vehicle_harness.h"

#include "core/base/hex.h"
#include "core/vehicle/telemetry.h"

#include <rapidcheck.h>

using namespace skyseal;
using namespace skyseal::vehicle;

class TelemetryTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void positionInItsUnits();
    void placeZeroIsNoPlace();
    void rawGpsStandsInUntilTheEstimateComes();
    void batteryInItsUnits();
    void unknownValuesStayUnknown();
    void impossibleValuesAreUnknown();
    void ekfNeedsItsFlags_data();
    void ekfNeedsItsFlags();
    void satelliteMessageGivesTheWholePicture();
    void framesOfTheReference();
    void anyPayloadLeavesShowableValues();
};

namespace {

/// A state after one message.
struct Reading
{
    template<typename Message> TelemetryUpdate feed(const Message &message)
    {
        Sender sender;
        return telemetry.handle(sender.frame(message), state);
    }

    TelemetryUpdate feedHex(std::string_view hex)
    {
        const Bytes bytes = *fromHex(hex);
        return telemetry.handle(*mavlink::readFrame(bytes, mavlink::Dialect::builtin()), state);
    }

    Telemetry telemetry;
    VehicleState state;
};

bool near(double a, double b)
{
    return std::abs(a - b) < 1e-9;
}

} // namespace

void TelemetryTest::positionInItsUnits()
{
    Reading r;
    mavlink::GlobalPositionInt m;
    m.lat = -353632610;
    m.lon = 1491652300;
    m.alt = 594120;
    m.relative_alt = 10120;
    m.vx = 300;
    m.vy = -400;
    m.vz = 120;
    m.hdg = 35999;
    QVERIFY(r.feed(m).positionChanged);
    QVERIFY(near(r.state.position.latitude, -35.363261) && near(r.state.position.longitude, 149.16523));
    QVERIFY(near(r.state.position.altitude, 594.12) && near(r.state.altitudeRelative, 10.12));
    QVERIFY(near(r.state.groundSpeed, 5) && near(r.state.climb, -1.2) && near(r.state.heading, 359.99));

    mavlink::Attitude attitude;
    attitude.roll = 0.5f;
    attitude.yawspeed = -0.25f;
    r.feed(attitude);
    QCOMPARE(r.state.roll, 0.5);
    QCOMPARE(r.state.yawSpeed, -0.25);
}

void TelemetryTest::placeZeroIsNoPlace()
{
    Reading r;
    r.feed(mavlink::GlobalPositionInt{});
    QVERIFY(!r.state.position.known());
    mavlink::GlobalPositionInt off;
    off.lat = 910000000;
    r.feed(off);
    QVERIFY(!r.state.position.known());
}

void TelemetryTest::rawGpsStandsInUntilTheEstimateComes()
{
    Reading r;
    mavlink::GpsRawInt gps;
    gps.fix_type = 3;
    gps.lat = 480000000;
    gps.lon = 110000000;
    gps.satellites_visible = 12;
    gps.eph = 121;
    gps.vel = 250;
    r.feed(gps);
    QCOMPARE(r.state.gpsFix, 3);
    QCOMPARE(r.state.satellites, 12);
    QVERIFY(near(r.state.hdop, 1.21) && near(r.state.position.latitude, 48) && near(r.state.groundSpeed, 2.5));
    mavlink::GlobalPositionInt estimate;
    estimate.lat = 490000000;
    r.feed(estimate);
    r.feed(gps);
    QVERIFY(near(r.state.position.latitude, 49));
}

void TelemetryTest::batteryInItsUnits()
{
    Reading r;
    mavlink::SysStatus m;
    m.voltage_battery = 15812;
    m.current_battery = 1234;
    m.battery_remaining = 78;
    m.load = 415;
    r.feed(m);
    QVERIFY(near(r.state.batteryVoltage, 15.812) && near(r.state.batteryCurrent, 12.34) && near(r.state.cpuLoad, 41.5));
    QCOMPARE(r.state.batteryPercent, 78.);
    mavlink::BatteryStatus cells;
    cells.voltages.fill(65535);
    cells.voltages[0] = 4000;
    cells.voltages[1] = 3900;
    cells.current_battery = -1;
    cells.battery_remaining = 60;
    r.feed(cells);
    QVERIFY(near(r.state.batteryVoltage, 7.9) && near(r.state.batteryCurrent, 12.34));
    cells.id = 1;
    cells.battery_remaining = 5;
    r.feed(cells); // another battery
    QCOMPARE(r.state.batteryPercent, 60.);
}

void TelemetryTest::unknownValuesStayUnknown()
{
    Reading r;
    mavlink::SysStatus status;
    status.voltage_battery = 65535;
    status.current_battery = -1;
    status.battery_remaining = -1;
    r.feed(status);
    QVERIFY(std::isnan(r.state.batteryVoltage) && std::isnan(r.state.batteryCurrent) && std::isnan(r.state.batteryPercent));
    mavlink::GpsRawInt gps;
    gps.satellites_visible = 255;
    gps.eph = 65535;
    r.feed(gps);
    QCOMPARE(r.state.satellites, -1);
    QVERIFY(std::isnan(r.state.hdop));
    mavlink::GlobalPositionInt position;
    position.hdg = 65535;
    r.feed(position);
    QVERIFY(std::isnan(r.state.heading));
    QVERIFY(!r.state.ekfOk.has_value());
}

void TelemetryTest::impossibleValuesAreUnknown()
{
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (const float impossible : {1e30f, -1e30f, kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN()}) {
        Reading r;
        r.feed(mavlink::VfrHud{.airspeed = impossible, .groundspeed = impossible, .climb = impossible});
        QVERIFY(std::isnan(r.state.airSpeed) && std::isnan(r.state.groundSpeed) && std::isnan(r.state.climb));
        r.feed(mavlink::Attitude{.roll = impossible, .pitch = impossible, .yaw = impossible, .rollspeed = impossible});
        QVERIFY(std::isnan(r.state.roll) && std::isnan(r.state.pitch) && std::isnan(r.state.yaw));
        QVERIFY(std::isnan(r.state.rollSpeed));
        r.feed(mavlink::Vibration{.vibration_x = impossible, .vibration_y = impossible, .vibration_z = impossible});
        QVERIFY(std::isnan(r.state.vibration));
    }
}

void TelemetryTest::ekfNeedsItsFlags_data()
{
    QTest::addColumn<int>("flags");
    QTest::addColumn<float>("variance");
    QTest::addColumn<bool>("ok");
    QTest::newRow("as in flight") << 831 << 0.1f << true;
    QTest::newRow("no position") << 167 << 0.1f << false;
    QTest::newRow("constant position") << (831 | 128) << 0.1f << false;
    QTest::newRow("not initialised") << 1024 << 0.f << false;
    QTest::newRow("GPS glitch") << (831 | 32768) << 0.1f << false;
    QTest::newRow("inconsistent") << 831 << 1.2f << false;
}

void TelemetryTest::ekfNeedsItsFlags()
{
    QFETCH(int, flags);
    QFETCH(float, variance);
    QFETCH(bool, ok);
    Reading r;
    mavlink::EkfStatusReport m;
    m.flags = static_cast<std::uint16_t>(flags);
    m.compass_variance = variance;
    r.feed(m);
    QCOMPARE(r.state.ekfOk, std::optional(ok));
    QCOMPARE(int(r.state.ekfFlags), flags);
}

void TelemetryTest::satelliteMessageGivesTheWholePicture()
{
    Reading r;
    r.state.home = {48, 11, 500};
    mavlink::HighLatency2 m;
    m.latitude = 481000000;
    m.longitude = 110000000;
    m.altitude = 620;
    m.heading = 90;
    m.groundspeed = 60;
    m.climb_rate = -15;
    m.battery = 44;
    m.wp_num = 3;
    r.feed(m);
    QVERIFY(near(r.state.altitudeRelative, 120) && near(r.state.heading, 180) && near(r.state.groundSpeed, 12));
    QVERIFY(near(r.state.climb, -1.5) && near(r.state.batteryPercent, 44));
    QCOMPARE(r.state.missionCurrent, 3);
}

void TelemetryTest::framesOfTheReference()
{
    // Packed by the reference implementation from random and special values; not one of our own lines stood between.
    Reading r;
    r.feedHex("fe14d7ee044a97fba94633a809392bb021bdec62c13c9907382b1e33"); // VFR_HUD, MAVLink 1
    QCOMPARE(r.state.airSpeed, double(21757.7949f));
    QCOMPARE(r.state.groundSpeed, double(0.000131279972f));
    QCOMPARE(r.state.climb, double(0.0236067399f));
    QCOMPARE(r.state.heading, double(1945 % 360));
    QCOMPARE(r.state.throttle, 11064.);
    r.feedHex("fd1200007d766d2a0000527d3834057af921189308675f0f7a996cbb89be"); // MISSION_CURRENT
    QCOMPARE(r.state.missionCurrent, 32082);
    r.feedHex("fd1a0000754c1fc10000920f15b9d408bd43499f38363b468e4485372fc3d87c881c2848c9c1"); // EKF_STATUS_REPORT
    QCOMPARE(int(r.state.ekfFlags), 31960);
    QCOMPARE(r.state.ekfOk, std::optional(false));
    const auto home = r.feedHex(
        "fd3c0000c57e33f200005d403ddc8e9b8c30c5c7b1d985c29ec2d8c37ec03ae297c5f2619cb555740db832ad433fa61341c486299cb"
        "69bc2c3bfd7f9dcb733d752660472faab0365"); // HOME_POSITION
    QVERIFY(home.home && near(home.home->latitude, -59.9965603) && near(home.home->longitude, 81.452123));
    r.feedHex("fd1300000f71d14a00000000807f000080ff0100c0ff0000c07fffff049939"); // VFR_HUD: infinities, NaN, heading -1
    QCOMPARE(r.state.heading, double(1945 % 360));
}

void TelemetryTest::anyPayloadLeavesShowableValues()
{
    const std::uint32_t ids[] = {0,   1,   24,  30, 33,  42,  74, 87, 147, 193, 230, 235, 241,
                                 242, 245, 253, 77, 111, 148, 22, 44, 51,  73,  39,  47};
    QVERIFY(rc::check("random payloads through a whole vehicle", [&] {
        Harness h = Harness::copter(4, true);
        h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
        for (const std::uint32_t id : ids) {
            const auto payload = *rc::gen::container<std::vector<std::uint8_t>>(rc::gen::arbitrary<std::uint8_t>());
            const auto *info = mavlink::Dialect::builtin().find(id);
            RC_ASSERT(info);
            std::vector<std::uint8_t> cut(payload);
            cut.resize(std::min<std::size_t>(std::max<std::size_t>(cut.size(), 1), 255));
            std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
            const auto bytes = mavlink::writeFrame(buffer, 2, 0, 1, 1, id, info->crcExtra, info->minLength, cut);
            const auto frame = mavlink::readFrame(bytes, mavlink::Dialect::builtin());
            if (!frame)
                continue;
            h.vehicle.handleFrame(h.now, {}, *frame);
        }
        h.runUntil(h.now + std::chrono::seconds(5));
        const auto state = h.vehicle.state(h.now);
        RC_ASSERT(std::isnan(state.heading) || (state.heading >= 0 && state.heading < 360));
        RC_ASSERT(!state.position.known()
                  || (std::abs(state.position.latitude) <= 90 && std::abs(state.position.longitude) <= 180));
        for (const double value : {state.roll, state.pitch, state.yaw, state.groundSpeed, state.airSpeed, state.climb,
                                   state.altitudeRelative, state.vibration})
            RC_ASSERT(std::isnan(value) || std::abs(value) < 1e7); // a display converts it to whole pixels
        RC_ASSERT(std::isnan(state.distanceHome) || (state.distanceHome >= 0 && state.distanceHome < 20100e3));
    }));
}

SKYSEAL_TEST_APPLESS(TelemetryTest)
#include "telemetry_test.moc"
