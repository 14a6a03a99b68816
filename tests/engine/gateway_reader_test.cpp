// Questions (read-only requests) of a client of the gateway that may only read, through gateway, session and agent to the
// simulated vehicle and back.
#include "core/engine/gateway/gateway.h"
#include "core/engine/station/snapshot.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"
#include "tests/engine/served_flight.h"
#include "tests/engine/udp_end.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <algorithm>

using namespace skyseal;
using namespace skyseal::test;

namespace {

/// The system of the reader, by which answers to it are told from those to the gateway's own requests.
constexpr std::uint8_t kReader = 250;

template<typename Command> Command readerCommand(unsigned id, double first, double second = 0)
{
    Command out;
    out.target_system = out.target_component = 1;
    out.command = static_cast<std::uint16_t>(id);
    out.param1 = static_cast<float>(first);
    out.param2 = static_cast<float>(second);
    return out;
}

mavlink::RequestDataStream positionStream(unsigned rate)
{
    mavlink::RequestDataStream out;
    out.target_system = out.target_component = 1;
    out.req_stream_id = mavlink::MAV_DATA_STREAM_POSITION;
    out.req_message_rate = static_cast<std::uint16_t>(rate);
    out.start_stop = 1;
    return out;
}

/// The interval of the newest positions in milliseconds of the vehicle's clock; 0 while there are too few. The median, since a
/// vehicle on a busy machine may skip some.
std::uint32_t positionInterval(const UdpEnd &reader)
{
    constexpr std::size_t kIntervals = 9;
    const auto positions = reader.all<mavlink::GlobalPositionInt>();
    if (positions.size() <= kIntervals)
        return 0;
    std::array<std::uint32_t, kIntervals> out;
    for (std::size_t i = 0; i < kIntervals; ++i) {
        const std::size_t at = positions.size() - kIntervals + i;
        out[i] = positions[at].time_boot_ms - positions[at - 1].time_boot_ms;
    }
    std::ranges::nth_element(out, out.begin() + kIntervals / 2);
    return out[kIntervals / 2];
}

bool isAbout(std::uint32_t interval, std::uint32_t expected)
{
    return interval + 5 >= expected && interval <= expected + 5;
}

} // namespace

class GatewayReaderTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void versionIsAnswered_data();
    void versionIsAnswered();
    void modestRateIsSetAndAnotherDenied_data();
    void modestRateIsSetAndAnotherDenied();
};

void GatewayReaderTest::versionIsAnswered_data()
{
    QTest::addColumn<int>("command");
    QTest::addColumn<float>("parameter");
    QTest::addColumn<bool>("isInt");
    constexpr int kRequest = mavlink::MAV_CMD_REQUEST_MESSAGE, kOlder = mavlink::MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES;
    QTest::newRow("REQUEST_MESSAGE") << kRequest << float(mavlink::AutopilotVersion::kId) << false;
    QTest::newRow("REQUEST_MESSAGE as COMMAND_INT") << kRequest << float(mavlink::AutopilotVersion::kId) << true;
    QTest::newRow("REQUEST_AUTOPILOT_CAPABILITIES") << kOlder << 1.f << false;
}

void GatewayReaderTest::versionIsAnswered()
{
    QFETCH(int, command);
    QFETCH(float, parameter);
    QFETCH(bool, isInt);
    ServedFlight flight("");
    flight.fly();
    const auto known = [&] { return flight.ground.ears->snapshot->vehicles[0].state.capabilities; };
    EVENTUALLY(known() != 0); // the gateway's own station asks no more
    UdpEnd reader(flight.port());
    reader.send(mavlink::Heartbeat{}, kReader);
    EVENTUALLY(!reader.datagrams.empty());
    QVERIFY(!reader.newest<mavlink::AutopilotVersion>());

    if (isInt)
        reader.send(readerCommand<mavlink::CommandInt>(unsigned(command), double(parameter)), kReader);
    else
        reader.send(readerCommand<mavlink::CommandLong>(unsigned(command), double(parameter)), kReader);
    EVENTUALLY(reader.newest<mavlink::AutopilotVersion>().has_value());
    QCOMPARE(reader.newest<mavlink::AutopilotVersion>()->capabilities, known());
    EVENTUALLY(reader.answerTo(command, kReader).has_value());
    QCOMPARE(int(reader.answerTo(command, kReader)->result), int(mavlink::MAV_RESULT_ACCEPTED));
    EVENTUALLY_EQUAL(flight.client().counters.forwarded, std::uint64_t(1));
    QCOMPARE(flight.client().counters.denied, std::uint64_t(0));
}

void GatewayReaderTest::modestRateIsSetAndAnotherDenied_data()
{
    QTest::addColumn<bool>("asStream");
    QTest::newRow("SET_MESSAGE_INTERVAL") << false;
    QTest::newRow("REQUEST_DATA_STREAM") << true;
}

void GatewayReaderTest::modestRateIsSetAndAnotherDenied()
{
    QFETCH(bool, asStream);
    constexpr int kInterval = mavlink::MAV_CMD_SET_MESSAGE_INTERVAL;
    ServedFlight flight("");
    flight.fly();
    UdpEnd reader(flight.port());
    const auto request = [&](unsigned rate) {
        if (asStream)
            reader.send(positionStream(rate), kReader);
        else
            reader.send(readerCommand<mavlink::CommandLong>(kInterval, mavlink::GlobalPositionInt::kId, 1e6 / rate), kReader);
    };
    const auto answer = [&]() -> int {
        const auto ack = reader.answerTo(kInterval, kReader);
        return ack ? int(ack->result) : -1;
    };
    reader.send(mavlink::Heartbeat{}, kReader);
    EVENTUALLY2(isAbout(positionInterval(reader), 333), "the rate that the gateway's own station requests");

    request(8);
    EVENTUALLY2(isAbout(positionInterval(reader), 125), "the rate of the reader's request");
    if (!asStream)
        EVENTUALLY_EQUAL(answer(), int(mavlink::MAV_RESULT_ACCEPTED));
    QCOMPARE(flight.client().counters.denied, std::uint64_t(0));

    reader.datagrams.clear();
    request(50);
    EVENTUALLY_EQUAL(flight.client().counters.denied, std::uint64_t(1));
    if (!asStream)
        EVENTUALLY_EQUAL(answer(), int(mavlink::MAV_RESULT_DENIED));
    EVENTUALLY(positionInterval(reader) != 0);
    QVERIFY2(isAbout(positionInterval(reader), 125), std::to_string(positionInterval(reader)).c_str());
    QCOMPARE(flight.client().counters.forwarded, std::uint64_t(1));
}

SKYSEAL_TEST(GatewayReaderTest)
#include "gateway_reader_test.moc"
