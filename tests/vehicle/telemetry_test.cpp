// Telemetry into state: units, values that mean "not known", frames packed by the reference implementation, and arbitrary
// bytes, which must leave only values that a window can show.
#include "tests/support/test_runner.h"
#include "vehicle_harness.h"

#include "core/base/hex.h"
#include "core/mavlink/field_value.h"
#include "core/vehicle/state_fields.h"
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
    void everyFieldThatIsNotKnownIsUnknownAtOnce();
    void lostPositionIsUnknownAtOnce();
    void headingThatIsNotKnownStaysUnknown();
    void autopilotWithoutMonitorHasNoBattery();
    void cellsBeyondTheTenthCount();
    void batteryThatTheVehicleFliesOn();
    void batteryThatIsNoLongerReported();
    void impossibleValuesAreUnknown();
    void ekfNeedsItsFlags_data();
    void ekfNeedsItsFlags();
    void estimatorOfPx4_data();
    void estimatorOfPx4();
    void checksOfPx4AreInTheHealthAlone();
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
        return telemetry.handle(now, sender.frame(message), state);
    }

    TelemetryUpdate feedHex(std::string_view hex)
    {
        const Bytes bytes = *fromHex(hex);
        return telemetry.handle(now, *mavlink::readFrame(bytes, mavlink::Dialect::builtin()), state);
    }

    Telemetry telemetry;
    VehicleState state;
    TimePoint now{std::chrono::hours(1)};
};

/// A message of the dialect with any values in its fields.
class AnyMessage
{
public:
    explicit AnyMessage(const mavlink::MessageInfo &info) : m_info(info), m_payload(info.maxLength)
    {
        for (const mavlink::FieldInfo &field : info.fields)
            set(field, field.unknown.empty() ? mavlink::FieldValue::fromNumber(field.type, 2) : unknownOf(field));
    }

    static mavlink::FieldValue unknownOf(const mavlink::FieldInfo &field, std::size_t which = 0)
    {
        return mavlink::FieldValue::fromBits(field.type, field.unknown[which]);
    }

    /// All elements of the field.
    AnyMessage &set(const mavlink::FieldInfo &field, mavlink::FieldValue value)
    {
        for (std::size_t i = 0; i < field.elements(); ++i)
            mavlink::setFieldValue(m_payload, field, i, value);
        return *this;
    }

    void feedTo(Reading &reading) const
    {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        const auto bytes = mavlink::writeFrame(buffer, 2, 0, 1, 1, m_info.id, m_info.crcExtra, m_info.minLength, m_payload);
        reading.telemetry.handle(reading.now, *mavlink::readFrame(bytes, mavlink::Dialect::builtin()), reading.state);
    }

private:
    const mavlink::MessageInfo &m_info;
    Bytes m_payload;
};

/// The values of the state that change with a field, when it changes from one known value to another.
std::vector<const StateField *> valuesOf(const mavlink::MessageInfo &message, const mavlink::FieldInfo &field)
{
    Reading one, other;
    AnyMessage(message).set(field, mavlink::FieldValue::fromNumber(field.type, 20)).feedTo(one);
    AnyMessage(message).set(field, mavlink::FieldValue::fromNumber(field.type, 30)).feedTo(other);
    std::vector<const StateField *> out;
    for (const StateField &value : stateFields()) {
        if (value.number && std::isfinite(value.number(one.state)) && value.number(one.state) != value.number(other.state))
            out.push_back(&value);
    }
    return out;
}

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
    Reading alone;
    alone.feed(cells);
    QVERIFY(near(alone.state.batteryVoltage, 7.9) && std::isnan(alone.state.batteryCurrent));
    QCOMPARE(alone.state.batteryPercent, 60.);
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

void TelemetryTest::everyFieldThatIsNotKnownIsUnknownAtOnce()
{
    QStringList read;
    for (const mavlink::MessageInfo &message : mavlink::Dialect::builtin().messages()) {
        for (const mavlink::FieldInfo &field : message.fields) {
            const auto values = field.unknown.empty() ? std::vector<const StateField *>() : valuesOf(message, field);
            if (values.empty())
                continue;
            const std::string name = std::string(message.name) + '.' + std::string(field.name);
            read << QString::fromStdString(name);
            for (std::size_t which = 0; which < field.unknown.size(); ++which) {
                Reading r;
                AnyMessage(message).set(field, mavlink::FieldValue::fromNumber(field.type, 20)).feedTo(r);
                AnyMessage(message).set(field, AnyMessage::unknownOf(field, which)).feedTo(r);
                for (const StateField *value : values)
                    QVERIFY2(std::isnan(value->number(r.state)), (name + " keeps " + std::string(value->name)).c_str());
            }
        }
    }
    read.sort();
    QCOMPARE(read.join(QLatin1Char(' ')),
             QStringLiteral(
                 "BATTERY_STATUS.battery_remaining BATTERY_STATUS.current_battery BATTERY_STATUS.voltages "
                 "BATTERY_STATUS.voltages_ext GLOBAL_POSITION_INT.hdg GPS_RAW_INT.eph GPS_RAW_INT.satellites_visible "
                 "GPS_RAW_INT.vel HIGH_LATENCY.gps_nsat HIGH_LATENCY2.battery MISSION_CURRENT.seq SYS_STATUS.battery_remaining "
                 "SYS_STATUS.current_battery SYS_STATUS.voltage_battery"));
}

void TelemetryTest::lostPositionIsUnknownAtOnce()
{
    Reading r;
    mavlink::GlobalPositionInt estimate;
    estimate.lat = 470000000;
    estimate.lon = 80000000;
    r.feed(estimate);
    QVERIFY(near(r.state.position.latitude, 47));
    mavlink::GpsRawInt gps;
    gps.fix_type = mavlink::GPS_FIX_TYPE_2D_FIX;
    gps.lat = 480000000;
    gps.lon = 80000000;
    gps.alt = 400000;
    r.feed(gps);
    r.feed(mavlink::GlobalPositionInt{}); // the estimator lost its origin, the receiver has its fix
    QVERIFY(near(r.state.position.latitude, 48) && std::isnan(r.state.position.altitude));
    gps.fix_type = mavlink::GPS_FIX_TYPE_NO_FIX;
    r.feed(gps);
    QVERIFY(!r.state.position.known() && std::isnan(r.state.groundSpeed));
}

void TelemetryTest::headingThatIsNotKnownStaysUnknown()
{
    Reading r;
    mavlink::GlobalPositionInt position;
    position.hdg = 9000;
    r.feed(position);
    QCOMPARE(r.state.heading, 90.);
    position.hdg = 65535;
    r.feed(position);
    r.feed(mavlink::VfrHud{.heading = 91}); // cannot say that it does not know
    QVERIFY(std::isnan(r.state.heading));
    position.hdg = 9200;
    r.feed(position);
    r.feed(mavlink::VfrHud{.heading = 93});
    QCOMPARE(r.state.heading, 93.);
}

void TelemetryTest::autopilotWithoutMonitorHasNoBattery()
{
    Reading r;
    mavlink::SysStatus status; // as ArduPlane sends it, and ArduCopter before its monitor has measured
    status.current_battery = -1;
    status.battery_remaining = -1;
    r.feed(status);
    QVERIFY(std::isnan(r.state.batteryVoltage) && std::isnan(r.state.batteryCurrent) && std::isnan(r.state.batteryPercent));
}

void TelemetryTest::cellsBeyondTheTenthCount()
{
    Reading r;
    mavlink::BatteryStatus cells;
    cells.voltages.fill(4200);
    cells.voltages_ext = {4100, 4000, 0, 65535};
    r.feed(cells);
    QVERIFY(near(r.state.batteryVoltage, 50.1));
    cells.voltages.fill(65535);
    cells.voltages[0] = 65534; // a pack of 71.2 V without cell monitors
    cells.voltages[1] = 5666;
    cells.voltages_ext = {};
    r.feed(cells);
    QVERIFY(near(r.state.batteryVoltage, 71.2));
}

void TelemetryTest::batteryThatTheVehicleFliesOn()
{
    Reading r;
    mavlink::BatteryStatus first, payload, second;
    first.voltages.fill(65535);
    payload = second = first;
    payload.battery_function = mavlink::MAV_BATTERY_FUNCTION_PAYLOAD;
    payload.voltages[0] = 12000;
    payload.battery_remaining = 5;
    first.id = 1;
    first.voltages[0] = 22000;
    first.battery_remaining = 80;
    second.id = 2;
    second.voltages[0] = 21000;
    second.battery_remaining = 40;
    for (const auto &one : {second, payload, first})
        r.feed(one);
    QVERIFY(near(r.state.batteryVoltage, 22) && near(r.state.batteryPercent, 80)); // the first one that is for the flight
    QCOMPARE(int(r.state.batteries.size()), 3);
    QVERIFY(r.state.batteries[0].id == 0 && near(r.state.batteries[0].voltage, 12) && near(r.state.batteries[2].percent, 40));
    mavlink::SysStatus status;
    status.voltage_battery = 21100;
    status.current_battery = 500;
    status.battery_remaining = 41;
    r.feed(status);
    for (const auto &one : {second, payload, first})
        r.feed(one);
    QVERIFY(near(r.state.batteryVoltage, 21.1) && near(r.state.batteryCurrent, 5) && near(r.state.batteryPercent, 41));
    status.voltage_battery = 65535; // greater than the field holds
    r.feed(status);
    QVERIFY(near(r.state.batteryVoltage, 21) && near(r.state.batteryPercent, 41));
}

void TelemetryTest::batteryThatIsNoLongerReported()
{
    Reading r;
    mavlink::BatteryStatus first, second;
    first.voltages[0] = 22000;
    second.voltages[0] = 11000;
    second.id = 1;
    r.feed(first);
    r.feed(second);
    r.now += Batteries::kKept / 2;
    r.feed(second);
    QVERIFY(near(r.state.batteryVoltage, 22));
    r.now += Batteries::kKept / 2;
    r.feed(second);
    QVERIFY(near(r.state.batteryVoltage, 11));
    QCOMPARE(int(r.state.batteries.size()), 1);
    for (int id = 0; id < 256; ++id) {
        second.id = static_cast<std::uint8_t>(id);
        r.feed(second);
    }
    QCOMPARE(r.state.batteries.size(), Batteries::kMost);
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
    QTest::newRow("diverged") << 831 << std::numeric_limits<float>::quiet_NaN() << false;
    QTest::newRow("nothing estimated yet") << 0 << 0.1f << false;
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
    r.feed(mavlink::EkfStatusReport{}); // an autopilot that is set to fly without an EKF
    QVERIFY(!r.state.ekfOk);
}

void TelemetryTest::estimatorOfPx4_data()
{
    QTest::addColumn<int>("flags");
    QTest::addColumn<bool>("ok");
    QTest::newRow("at rest on the ground") << 1023 << true;
    QTest::newRow("in flight") << 895 << true;
    QTest::newRow("holds its position for want of GPS") << (1 | 4 | 32 | 128) << false;
    QTest::newRow("GPS glitch") << (895 | 1024) << false;
    QTest::newRow("accelerometer error") << (895 | 2048) << false;
    QTest::newRow("started") << 0 << false;
}

void TelemetryTest::estimatorOfPx4()
{
    QFETCH(int, flags);
    QFETCH(bool, ok);
    Reading r;
    r.feed(mavlink::EstimatorStatus{.flags = static_cast<std::uint16_t>(flags)});
    QCOMPARE(r.state.ekfOk, std::optional(ok));
}

void TelemetryTest::checksOfPx4AreInTheHealthAlone()
{
    Reading r;
    mavlink::SysStatus status;
    r.feed(status);
    QVERIFY(!r.state.preArmOk);
    status.onboard_control_sensors_health = mavlink::MAV_SYS_STATUS_PREARM_CHECK;
    r.feed(status);
    QCOMPARE(r.state.preArmOk, std::optional(true));
    status.onboard_control_sensors_health = 0;
    r.feed(status);
    QCOMPARE(r.state.preArmOk, std::optional(false));
    // ArduPilot with all its checks disabled
    status.onboard_control_sensors_present = mavlink::MAV_SYS_STATUS_PREARM_CHECK;
    r.feed(status);
    QVERIFY(!r.state.preArmOk);
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
    QVERIFY(std::isnan(r.state.heading));
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
