// Other ground stations behind the gateway of a sealed station, over real sockets.
#include "core/engine/gateway/gateway.h"
#include "core/engine/station/snapshot.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "tests/engine/served_flight.h"
#include "tests/engine/udp_end.h"
#include "tests/support/eventually.h"
#include "tests/support/heartbeat.h"
#include "tests/support/test_runner.h"

#include <QtNetwork/QTcpSocket>
#include <QtNetwork/QUdpSocket>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

#include <algorithm>

using namespace skyseal;
using namespace skyseal::test;

namespace {

std::string contentOf(const QByteArray &bytes)
{
    return bytes.toStdString();
}

mavlink::CommandLong arm()
{
    mavlink::CommandLong out;
    out.target_system = out.target_component = 1;
    out.command = mavlink::MAV_CMD_COMPONENT_ARM_DISARM;
    out.param1 = 1;
    return out;
}

mavlink::ParamRequestRead parameterByIndex(int index)
{
    mavlink::ParamRequestRead out;
    out.target_system = out.target_component = 1;
    out.param_index = static_cast<std::int16_t>(index);
    return out;
}

} // namespace

class GatewayTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void framesArriveAsTheAutopilotSentThem();
    void readerIsAnsweredAndCommandsNothing();
    void clientWithTheRightCommands();
    void rightsOfTheStationAreAboveThoseOfTheClient();
    void onlyHeartbeatsOfClientsThatMayWriteArrive();
    void stationThatListensIsServed();
    void strangerIsNotTheConfiguredStation();
    void tcpClientNeedNotSendFirst();
    void clientOfAnotherNetworkIsNotServed();
    void silentClientsKeepNobodyOut();
    void reconnectingIsReportedOnlySoOften();
    void denialsOfReconnectingClientsAreReportedOnlySoOften();
    void takenPortIsReported();
    void serviceEnds();
};

void GatewayTest::framesArriveAsTheAutopilotSentThem()
{
    ServedFlight flight("");
    UdpEnd client(flight.port());
    client.send(mavlink::Heartbeat{});
    EVENTUALLY(!flight.client().name.empty());

    std::vector<QByteArray> sent{clearHeartbeat(1, 1, false)}; // MAVLink 1
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    mavlink::FrameWriter writer(1, 1);
    const auto add = [&sent](ByteView frame) {
        sent.emplace_back(reinterpret_cast<const char *>(frame.data()), static_cast<qsizetype>(frame.size()));
    };
    for (int i = 0; i < 3; ++i) // sequence numbers as they are
        add(writer.write(mavlink::Attitude{.roll = 0.1f * float(i + 1)}, buffer));
    const std::array<std::uint8_t, 9> payload{1, 2, 3, 4, 5, 6, 7, 8, 9};
    add(mavlink::writeFrame(buffer, 2, 77, 1, 1, mavlink::Attitude::kId, mavlink::Attitude::kCrcExtra,
                            mavlink::Attitude::kMinLength, payload, mavlink::kFlagSigned)); // signed, whatever the signature
    add(mavlink::writeFrame(buffer, 2, 78, 1, 1, 0x00A1B2C3, 0x5a, 9, payload));            // of another dialect
    QUdpSocket vehicle;
    for (const QByteArray &frame : sent)
        vehicle.writeDatagram(frame, QHostAddress::LocalHost, portOf(flight.rig.vehicleAddress()));
    for (const QByteArray &frame : sent)
        EVENTUALLY2(client.received(frame), contentOf(frame.toHex(' ')).c_str());
}

void GatewayTest::readerIsAnsweredAndCommandsNothing()
{
    ServedFlight flight("");
    VehicleOnUdp &vehicle = flight.fly();
    UdpEnd client(flight.port());
    client.send(mavlink::Heartbeat{});
    client.send(parameterByIndex(3));
    EVENTUALLY(client.newest<mavlink::ParamValue>().has_value());
    QCOMPARE(int(client.newest<mavlink::ParamValue>()->param_index), 3);

    client.send(arm());
    EVENTUALLY(client.answerTo(mavlink::MAV_CMD_COMPONENT_ARM_DISARM).has_value());
    const mavlink::CommandAck ack = *client.answerTo(mavlink::MAV_CMD_COMPONENT_ARM_DISARM);
    QCOMPARE(int(ack.result), int(mavlink::MAV_RESULT_DENIED));
    QCOMPARE(int(ack.target_system), 255);
    const auto told = [&client] {
        const auto text = client.newest<mavlink::Statustext>();
        return text && std::string(text->text.data()).starts_with("Gateway: COMMAND_LONG denied");
    };
    EVENTUALLY(told());
    EVENTUALLY_EQUAL(flight.client().counters.denied, std::uint64_t(1));
    QCOMPARE(flight.client().counters.forwarded, std::uint64_t(1));
    QCOMPARE(flight.ground.ears->all<engine::ClientDenied>().size(), std::size_t(1));
    QVERIFY(!vehicle.vehicle.autopilot().armed());
}

void GatewayTest::clientWithTheRightCommands()
{
    ServedFlight flight(",write=command");
    VehicleOnUdp &vehicle = flight.fly();
    UdpEnd client(flight.port());
    const auto armed = [&] {
        client.send(mavlink::Heartbeat{});
        client.send(arm());
        return vehicle.vehicle.autopilot().armed();
    };
    EVENTUALLY(armed()); // asked again until the vehicle is ready for it
    const auto accepted = [&client] {
        const auto ack = client.answerTo(mavlink::MAV_CMD_COMPONENT_ARM_DISARM);
        return ack && ack->result == mavlink::MAV_RESULT_ACCEPTED;
    };
    EVENTUALLY(accepted());
    client.send(mavlink::ParamSet{.target_system = 1});
    EVENTUALLY_EQUAL(flight.client().counters.denied, std::uint64_t(1));
}

void GatewayTest::rightsOfTheStationAreAboveThoseOfTheClient()
{
    ServedFlight flight(",write=all", channel::PeerRole::Observer);
    VehicleOnUdp &vehicle = flight.fly();
    UdpEnd client(flight.port());
    client.send(arm());
    const auto refused = [&] {
        flight.rig.agent->snapshot(); // publishes refusals
        return std::ranges::any_of(flight.rig.agentEvents, [](const engine::AgentEvent &event) {
            const auto *frames = std::get_if<engine::FramesRefused>(&event);
            return frames && frames->command == mavlink::MAV_CMD_COMPONENT_ARM_DISARM;
        });
    };
    EVENTUALLY(refused());
    QVERIFY(!vehicle.vehicle.autopilot().armed());
}

void GatewayTest::onlyHeartbeatsOfClientsThatMayWriteArrive()
{
    for (const bool mayWrite : {false, true}) {
        ServedFlight flight(mayWrite ? ",write=mission" : "");
        UdpEnd client(flight.port()), vehicle(portOf(flight.rig.vehicleAddress()));
        const auto arrived = [&] {
            vehicle.send(mavlink::Heartbeat{.type = mavlink::MAV_TYPE_QUADROTOR}, 1);
            client.send(mavlink::Heartbeat{.type = mavlink::MAV_TYPE_GCS});
            client.send(parameterByIndex(3));
            return vehicle.newest<mavlink::ParamRequestRead>().has_value();
        };
        EVENTUALLY(arrived());
        const double begin = flight.ground.ears->snapshot->time;
        EVENTUALLY(flight.ground.ears->snapshot->time > begin + 2.5); // the station's own would come once a second
        QCOMPARE(vehicle.newest<mavlink::Heartbeat>().has_value(), mayWrite);
    }
}

void GatewayTest::stationThatListensIsServed()
{
    UdpEnd station(0);
    ServedFlight flight("", channel::PeerRole::Pilot, "udpout:127.0.0.1:" + std::to_string(station.port()));
    flight.fly();
    EVENTUALLY(station.newest<mavlink::Heartbeat>().has_value());
    QCOMPARE(flight.client().address, "127.0.0.1:" + std::to_string(station.port()));
}

void GatewayTest::strangerIsNotTheConfiguredStation()
{
    UdpEnd station(0);
    ServedFlight flight(",write=all", channel::PeerRole::Pilot, "udpout:127.0.0.1:" + std::to_string(station.port()));
    VehicleOnUdp &vehicle = flight.fly();
    UdpEnd stranger(flight.port());
    for (int i = 0; i < 5; ++i)
        stranger.send(arm());
    const std::uint64_t frames = flight.ground.ears->snapshot->mavlink.frames;
    EVENTUALLY(flight.ground.ears->snapshot->mavlink.frames > frames + 20);
    QCOMPARE(flight.client().counters.forwarded, std::uint64_t(0));
    QVERIFY(!vehicle.vehicle.autopilot().armed());
    QVERIFY(stranger.datagrams.empty());
}

void GatewayTest::tcpClientNeedNotSendFirst()
{
    ServedFlight flight("", channel::PeerRole::Pilot, "tcpin:127.0.0.1:0");
    flight.fly();
    QTcpSocket program;
    program.connectToHost(QHostAddress::LocalHost, flight.port());
    EVENTUALLY(program.bytesAvailable() > 100);
    QCOMPARE(std::uint8_t(program.peek(1)[0]), mavlink::kMagic2);
    EVENTUALLY_EQUAL(flight.ground.ears->all<engine::ClientConnected>().size(), std::size_t(1));
    program.abort();
    EVENTUALLY_EQUAL(flight.ground.ears->all<engine::ClientGone>().size(), std::size_t(1));
    EVENTUALLY(flight.ground.ears->snapshot->clients.empty());
}

void GatewayTest::clientOfAnotherNetworkIsNotServed()
{
    ServedFlight flight(",write=all,from=10.0.0.0/8");
    VehicleOnUdp &vehicle = flight.fly();
    UdpEnd client(flight.port());
    for (int i = 0; i < 5; ++i)
        client.send(arm());
    const std::uint64_t frames = flight.ground.ears->snapshot->mavlink.frames;
    EVENTUALLY(flight.ground.ears->snapshot->mavlink.frames > frames + 20);
    QVERIFY(client.datagrams.empty() && flight.ground.ears->snapshot->clients.empty());
    QVERIFY(!vehicle.vehicle.autopilot().armed());
}

void GatewayTest::silentClientsKeepNobodyOut()
{
    ServedFlight flight("");
    flight.fly();
    std::vector<std::unique_ptr<UdpEnd>> others;
    for (std::size_t i = 0; i < engine::Gateway::kMostClients; ++i)
        others.push_back(std::make_unique<UdpEnd>(flight.port()));
    const auto greetFrom = [&others](std::size_t first) {
        for (std::size_t i = first; i < others.size(); ++i)
            others[i]->send(mavlink::Heartbeat{});
    };
    const auto all = [&] {
        greetFrom(0);
        return flight.ground.ears->snapshot->clients.size() == others.size();
    };
    EVENTUALLY(all());
    UdpEnd late(flight.port());
    const auto served = [&] { // the first one is silent from now on
        greetFrom(1);
        late.send(mavlink::Heartbeat{});
        return !late.datagrams.empty();
    };
    EVENTUALLY(served());
    const auto isClient = [&](quint16 port) {
        const std::string address = "127.0.0.1:" + std::to_string(port);
        return std::ranges::any_of(flight.ground.ears->snapshot->clients,
                                   [&](const engine::ClientSnapshot &client) { return client.address == address; });
    };
    EVENTUALLY(isClient(late.port()));
    QVERIFY(!isClient(others[0]->port()));
    for (std::size_t i = 1; i < others.size(); ++i)
        QVERIFY2(isClient(others[i]->port()), std::to_string(i).c_str());
}

void GatewayTest::reconnectingIsReportedOnlySoOften()
{
    ServedFlight flight("", channel::PeerRole::Pilot, "tcpin:127.0.0.1:0");
    const double begin = flight.ground.ears->snapshot->time;
    for (int i = 0; i < 200; ++i) {
        QTcpSocket program;
        // Not its state: the gateway closes what is one too many while it has not seen the others go.
        const QSignalSpy connected(&program, &QTcpSocket::connected);
        program.connectToHost(QHostAddress::LocalHost, flight.port());
        EVENTUALLY(!connected.isEmpty());
        program.abort();
    }
    QTcpSocket last;
    const auto alone = [&] {
        if (last.state() == QAbstractSocket::UnconnectedState)
            last.connectToHost(QHostAddress::LocalHost, flight.port());
        return last.state() == QAbstractSocket::ConnectedState && flight.ground.ears->snapshot->clients.size() == 1;
    };
    EVENTUALLY(alone());
    const double lasted = flight.ground.ears->snapshot->time - begin;
    const auto reported = static_cast<double>(flight.ground.ears->all<engine::ClientConnected>().size());
    QVERIFY2(reported <= engine::Gateway::kReportsAtOnce + engine::Gateway::kReportsPerSecond * (lasted + 1),
             std::to_string(reported).c_str());
    QVERIFY(reported >= engine::Gateway::kReportsAtOnce / 2);
}

/// A new connection may be denied something at once, so that the limit of one report a minute for each client limits nothing.
void GatewayTest::denialsOfReconnectingClientsAreReportedOnlySoOften()
{
    constexpr int kConnections = 100;
    ServedFlight flight("", channel::PeerRole::Pilot, "tcpin:127.0.0.1:0");
    const double begin = flight.ground.ears->snapshot->time;
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    const ByteView frame = mavlink::FrameWriter(255, 190).write(arm(), buffer);
    for (int i = 0; i < kConnections; ++i) {
        QTcpSocket program;
        const QSignalSpy answered(&program, &QTcpSocket::readyRead);
        program.connectToHost(QHostAddress::LocalHost, flight.port());
        program.write(reinterpret_cast<const char *>(frame.data()), static_cast<qint64>(frame.size()));
        EVENTUALLY(!answered.isEmpty()); // by COMMAND_ACK: denied
        program.abort();
    }
    EVENTUALLY(!flight.ground.ears->all<engine::ClientsUnreported>().empty());
    const double lasted = flight.ground.ears->snapshot->time - begin;
    const std::size_t connected = flight.ground.ears->all<engine::ClientConnected>().size();
    const std::size_t denied = flight.ground.ears->all<engine::ClientDenied>().size();
    QVERIFY2(static_cast<double>(connected + denied)
                 <= engine::Gateway::kReportsAtOnce + engine::Gateway::kReportsPerSecond * (lasted + 1),
             (std::to_string(connected) + " and " + std::to_string(denied)).c_str());
    QVERIFY(connected > 0 && denied > 0);
    const engine::ClientsUnreported others = flight.ground.ears->all<engine::ClientsUnreported>()[0];
    QVERIFY(others.clients + others.frames > 0);
}

void GatewayTest::takenPortIsReported()
{
    QUdpSocket other;
    QVERIFY(other.bind(QHostAddress::LocalHost));
    FlightRig rig;
    Ground ground(gatewayConfig(rig));
    ground.station->serve({*engine::ServeConfig::parse("udpin:" + std::to_string(other.localPort()))});
    const auto reported = [&ground] {
        const auto changes = ground.ears->all<engine::ServedLinkChanged>();
        return !changes.empty() && changes.back().link.addressInUse;
    };
    EVENTUALLY(reported());
}

void GatewayTest::serviceEnds()
{
    ServedFlight flight("");
    flight.fly();
    UdpEnd client(flight.port());
    client.send(mavlink::Heartbeat{});
    EVENTUALLY(!client.datagrams.empty());
    flight.ground.station->serve({});
    EVENTUALLY(flight.ground.ears->snapshot->served.empty() && flight.ground.ears->snapshot->clients.empty());
    client.datagrams.clear();
    const std::uint64_t frames = flight.ground.ears->snapshot->mavlink.frames;
    EVENTUALLY(flight.ground.ears->snapshot->mavlink.frames > frames + 20);
    QVERIFY(client.datagrams.empty());
}

SKYSEAL_TEST(GatewayTest)
#include "gateway_test.moc"
