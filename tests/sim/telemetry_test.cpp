// Messages of the simulated vehicle to a station: parameters, streams at exact rates, texts, time; and two runs that are equal
// to the last byte.
#include "core/sim/air_traffic.h"
#include "tests/sim/test_station.h"
#include "tests/support/test_runner.h"

#include "core/mavlink/enums.h"

#include <QtTest/QTest>

#include <map>
#include <set>

using namespace skyseal;
using namespace skyseal::sim;
using namespace skyseal::mavlink;
using namespace std::chrono_literals;

class SimTelemetryTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void parameterListIsComplete();
    void parametersTakeEffect();
    void streamRatesAreExact();
    void requestedMessagesComeOnce();
    void aircraftAreReported();
    void timeAndPing();
    void longTextsAreChunked();
    void rebootKeepsParameters();
    void hurriedFlightKeepsTheLinksTime();
    void sameSeedSameBytes();
};

void SimTelemetryTest::parameterListIsComplete()
{
    TestStation station;
    station.run(1);
    ParamRequestList request;
    request.target_system = 1;
    station.send(request);
    station.run(4);
    std::map<int, std::string> names;
    for (const auto &value : station.all<ParamValue>()) {
        QCOMPARE(std::size_t(value.param_count), Parameters().count());
        names[value.param_index] = std::string(value.param_id.data(), strnlen(value.param_id.data(), 16));
    }
    QCOMPARE(names.size(), Parameters().count());
    QVERIFY(names.size() >= 100);
    QCOMPARE(std::set<std::string>([&] {
                 std::set<std::string> unique;
                 for (const auto &[index, name] : names)
                     unique.insert(name);
                 return unique;
             }())
                 .size(),
             names.size());

    station.forget();
    ParamRequestRead read;
    read.target_system = 1;
    read.param_index = 17;
    station.send(read);
    QCOMPARE(std::string(station.last<ParamValue>().param_id.data(), strnlen(station.last<ParamValue>().param_id.data(), 16)),
             names[17]);
    read.param_index = -1;
    std::copy_n("WPNAV_SPEED", 11, read.param_id.begin());
    station.send(read);
    QCOMPARE(station.last<ParamValue>().param_value, 500.f);
    QCOMPARE(int(station.last<ParamValue>().param_type), int(MAV_PARAM_TYPE_REAL32));
    const std::size_t answers = station.count<ParamValue>();
    read.param_index = 9999;
    station.send(read);
    read.param_index = -1;
    read.param_id.fill('X'); // sixteen letters and no end
    station.send(read);
    QCOMPARE(station.count<ParamValue>(), answers);
}

void SimTelemetryTest::parametersTakeEffect()
{
    TestStation station;
    const auto set = [&](std::string_view name, float value) {
        ParamSet out;
        out.target_system = 1;
        std::copy(name.begin(), name.end(), out.param_id.begin());
        out.param_value = value;
        station.send(out);
        return station.last<ParamValue>().param_value;
    };
    station.run(1);
    QCOMPARE(set("WPNAV_SPEED_UP", 100), 100.f);
    QCOMPARE(set("WPNAV_SPEED_UP", std::numeric_limits<float>::infinity()), 100.f);
    QCOMPARE(set("WPNAV_SPEED_UP", -1), 100.f);
    QVERIFY(station.said("value refused"));
    QCOMPARE(set("SR0_EXTRA1", 20), 20.f);
    QVERIFY(station.takeOff(5));
    float fastest = 0;
    for (const auto &hud : station.all<mavlink::VfrHud>())
        fastest = std::max(fastest, hud.climb);
    QVERIFY2(fastest < 1.3f, qPrintable(QString::number(static_cast<double>(fastest))));
    station.forget();
    station.run(10);
    QVERIFY(std::abs(int(station.count<mavlink::Attitude>()) - 200) <= 1);
}

void SimTelemetryTest::streamRatesAreExact()
{
    for (int rate : {1, 10, 50, 100}) {
        TestStation station;
        station.step = 7ms;
        station.run(1);
        RequestDataStream request;
        request.target_system = 1;
        request.req_stream_id = MAV_DATA_STREAM_ALL;
        request.req_message_rate = static_cast<std::uint16_t>(rate);
        request.start_stop = 1;
        station.send(request);
        station.run(0.5);
        station.forget();
        station.run(20);
        std::map<std::uint32_t, int> counts;
        for (const Bytes &bytes : station.received)
            ++counts[readFrame(bytes, Dialect::builtin())->messageId()];
        for (std::uint32_t id :
             {1u, 2u, 24u, 27u, 29u, 30u, 32u, 33u, 36u, 42u, 62u, 65u, 74u, 116u, 125u, 147u, 152u, 163u, 168u, 193u, 241u})
            QVERIFY2(std::abs(counts[id] - 20 * rate) <= 1, qPrintable(QStringLiteral("%1: %2").arg(id).arg(counts[id])));
        QVERIFY(std::abs(counts[0] - 20) <= 1);
        QCOMPARE(station.vehicle.dropped(), std::uint64_t(0));
        request.start_stop = 0;
        station.send(request);
        station.run(0.1);
        station.forget();
        station.run(2);
        QCOMPARE(station.count<mavlink::Attitude>(), std::size_t(0));
    }
}

void SimTelemetryTest::requestedMessagesComeOnce()
{
    TestStation station;
    station.run(6);
    station.forget();
    QCOMPARE(station.command(MAV_CMD_SET_MESSAGE_INTERVAL, {30, 12500}), int(MAV_RESULT_ACCEPTED)); // 80 Hz
    QCOMPARE(station.command(MAV_CMD_GET_MESSAGE_INTERVAL, {30}), int(MAV_RESULT_ACCEPTED));
    QCOMPARE(station.last<MessageInterval>().interval_us, 12500);
    station.forget();
    station.run(5);
    QVERIFY(std::abs(int(station.count<mavlink::Attitude>()) - 400) <= 1);
    QCOMPARE(station.command(MAV_CMD_SET_MESSAGE_INTERVAL, {30, -1}), int(MAV_RESULT_ACCEPTED));
    QCOMPARE(station.command(MAV_CMD_SET_MESSAGE_INTERVAL, {4242, 1000}), int(MAV_RESULT_FAILED));
    QCOMPARE(station.command(MAV_CMD_GET_MESSAGE_INTERVAL, {4242}), int(MAV_RESULT_ACCEPTED));
    QCOMPARE(station.last<MessageInterval>().interval_us, 0);
    station.forget();
    station.run(2);
    QCOMPARE(station.count<mavlink::Attitude>(), std::size_t(0));
    QCOMPARE(station.command(MAV_CMD_REQUEST_MESSAGE, {148}), int(MAV_RESULT_ACCEPTED));
    QCOMPARE(station.count<AutopilotVersion>(), std::size_t(1));
    QVERIFY(station.last<AutopilotVersion>().capabilities & MAV_PROTOCOL_CAPABILITY_MAVLINK2);
    QCOMPARE(station.last<AutopilotVersion>().flight_sw_version >> 16, 0x0405u);
    QCOMPARE(station.command(MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES, {1}), int(MAV_RESULT_ACCEPTED));
    QCOMPARE(station.command(MAV_CMD_GET_HOME_POSITION), int(MAV_RESULT_ACCEPTED));
    QVERIFY(std::abs(station.last<HomePosition>().latitude + 353632610) < 100);
    QCOMPARE(station.command(MAV_CMD_DO_SET_HOME, {0, 0, 0, 0, -35.3600f, 149.1650f, 584}), int(MAV_RESULT_ACCEPTED));
    QVERIFY(std::abs(station.last<HomePosition>().latitude + 353600000) < 100);
}

void SimTelemetryTest::aircraftAreReported()
{
    TestStation station;
    station.setParameter("SIM_ADSB_COUNT", 3);
    station.setParameter("SIM_ADSB_RADIUS", 400);
    station.setParameter("SIM_ADSB_ALT", 60);
    RequestDataStream request;
    request.target_system = 1;
    request.req_message_rate = 10;
    request.start_stop = 1;
    station.send(request); // all streams, of which this is none
    station.run(3);
    QCOMPARE(station.count<AdsbVehicle>(), std::size_t(0));
    station.setParameter("SR0_ADSB", 6);
    station.run(0.5);
    station.forget();
    station.run(10);
    const auto reports = station.all<AdsbVehicle>();
    QVERIFY2(std::abs(int(reports.size()) - 60) <= 1, qPrintable(QString::number(reports.size())));
    const GeoFrame world(AutopilotConfig{}.start);
    std::map<std::uint32_t, std::vector<AdsbVehicle>> aircraft;
    for (const AdsbVehicle &report : reports) {
        const Vector3 place = world.toLocal({report.lat * 1e-7, report.lon * 1e-7, report.altitude * 1e-3});
        QVERIFY(std::abs(place.horizontal() - 400) < 0.1 && std::abs(place.z + 60) < 0.1);
        QVERIFY(report.flags & ADSB_FLAGS_SIMULATED);
        aircraft[report.ICAO_address].push_back(report);
    }
    QCOMPARE(aircraft.size(), std::size_t(3));
    for (const auto &[address, path] : aircraft) {
        const AdsbVehicle &one = path[5], &next = path[6];
        const auto north = [&](const AdsbVehicle &at) { return world.toLocal({at.lat * 1e-7, at.lon * 1e-7, 0}).x; };
        const double course = one.heading * 0.01 + degrees(AirTraffic::kSpeed * 0.25 / 400); // the mean of the arc between
        const double flown = north(next) - north(one);
        QVERIFY2(std::abs(flown - AirTraffic::kSpeed * 0.5 * std::cos(radians(course))) < 2,
                 qPrintable(QString::number(flown)));
        QCOMPARE(int(one.hor_velocity), 5000);
    }
    station.setParameter("SIM_ADSB_COUNT", 0);
    station.run(0.5);
    station.forget();
    station.run(3);
    QCOMPARE(station.count<AdsbVehicle>(), std::size_t(0));
}

void SimTelemetryTest::timeAndPing()
{
    TestStation station;
    station.run(3);
    Timesync sync;
    sync.ts1 = 123456789;
    station.send(sync);
    QCOMPARE(station.last<Timesync>().ts1, std::int64_t(123456789));
    QVERIFY(std::abs(station.last<Timesync>().tc1 - station.now.time_since_epoch().count()) < 50'000'000);
    sync.tc1 = 5;
    station.send(sync); // an answer is not answered
    QCOMPARE(station.count<Timesync>(), std::size_t(1));
    Ping ping;
    ping.seq = 77;
    station.send(ping);
    QCOMPARE(station.last<Ping>().seq, 77u);
    QCOMPARE(int(station.last<Ping>().target_system), 255);

    station.writer.setVersion(1); // an old station is answered too
    ping.seq = 78;
    station.send(ping);
    QCOMPARE(station.last<Ping>().seq, 78u);
}

void SimTelemetryTest::longTextsAreChunked()
{
    TestStation station;
    station.run(1.1);
    station.forget();
    for (std::size_t length : {50u, 51u, 100u, 130u}) {
        std::string text;
        for (std::size_t i = 0; i < length; ++i)
            text.push_back(static_cast<char>('a' + i % 26));
        station.forget();
        station.vehicle.autopilot().texts().say(Severity::Info, text);
        station.run(0.2);
        std::string joined;
        std::set<int> ids;
        int expected = 0;
        for (const auto &chunk : station.all<Statustext>()) {
            joined.append(chunk.text.data(), strnlen(chunk.text.data(), 50));
            ids.insert(chunk.id);
            QCOMPARE(int(chunk.chunk_seq), expected++);
        }
        QCOMPARE(joined, text);
        QCOMPARE(ids.size(), std::size_t(1));
        QCOMPARE(*ids.begin() != 0, length > 50);
        QVERIFY(length <= 50 || station.last<Statustext>().text.back() == '\0'); // the last chunk shows its end
    }
}

void SimTelemetryTest::rebootKeepsParameters()
{
    TestStation station;
    station.run(6);
    station.setParameter("RTL_ALT", 2500);
    station.forget();
    QCOMPARE(station.command(MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, {1}), int(MAV_RESULT_ACCEPTED));
    station.run(1);
    QVERIFY(station.vehicle.autopilot().time() < 2'000'000);
    QCOMPARE(station.vehicle.autopilot().parameters().value("RTL_ALT"), 2500.f);
    station.run(6);
    QCOMPARE(int(station.last<EkfStatusReport>().flags), 831);
}

void SimTelemetryTest::hurriedFlightKeepsTheLinksTime()
{
    SimulatedVehicleConfig config;
    config.rate = 10;
    TestStation station(config);
    station.run(1);
    QCOMPARE(station.command(MAV_CMD_DO_SET_MODE, {1, 4}),
             int(MAV_RESULT_ACCEPTED)); // ten seconds of flight time have passed
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}), int(MAV_RESULT_ACCEPTED));
    QCOMPARE(station.command(MAV_CMD_NAV_TAKEOFF, {0, 0, 0, 0, 0, 0, 10}), int(MAV_RESULT_ACCEPTED));
    station.forget();
    station.run(3);
    QVERIFY(station.vehicle.autopilot().heightAboveHome() > 9);
    QVERIFY(station.vehicle.autopilot().modes().current() == FlightMode::Guided);
    QVERIFY(std::abs(int(station.count<mavlink::Heartbeat>()) - 3) <= 1);
    QVERIFY(std::abs(int(station.count<mavlink::Attitude>()) - 12) <= 1);
}

void SimTelemetryTest::sameSeedSameBytes()
{
    const auto fly = [](std::uint64_t seed, Duration step) {
        SimulatedVehicleConfig config;
        config.autopilot.seed = seed;
        TestStation station(config);
        station.step = step;
        if (!station.takeOff(6))
            return Bytes{};
        station.run(4);
        Bytes whole;
        for (const Bytes &frame : station.received)
            whole.insert(whole.end(), frame.begin(), frame.end());
        return whole;
    };
    const Bytes first = fly(5, 20ms);
    QVERIFY(first.size() > 10000);
    QVERIFY(first == fly(5, 20ms));
    QVERIFY(first != fly(6, 20ms));

    // Nor does it matter how often the vehicle is looked at.
    const auto idle = [](Duration step) {
        SimulatedVehicle vehicle({}, TimePoint{});
        Bytes whole;
        for (TimePoint now{}; now <= TimePoint(6s); now += step) {
            vehicle.advance(now);
            for (ByteView frame = vehicle.pollFrame(); !frame.empty(); frame = vehicle.pollFrame())
                whole.insert(whole.end(), frame.begin(), frame.end());
        }
        return whole;
    };
    QVERIFY(idle(1ms) == idle(500ms));
}

SKYSEAL_TEST_APPLESS(SimTelemetryTest)
#include "telemetry_test.moc"
