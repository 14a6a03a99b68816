// Where a station that can seal sends its heartbeat in clear: a link to one address (udpout), whose remote end inspects what
// arrives and forwards it between station, agent and vehicle, as a router does.
#include "core/engine/station/snapshot.h"
#include "core/keys/peers_file.h"
#include "core/mavlink/frame_scanner.h"
#include "core/mavlink/messages.h"
#include "tests/engine/flight_rig.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtNetwork/QNetworkDatagram>
#include <QtNetwork/QUdpSocket>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;

namespace {

/// Forwards datagrams between the station, which sends to it, and the first other program that does.
class Middle
{
public:
    Middle()
    {
        m_socket.bind(QHostAddress::LocalHost, 0);
        QObject::connect(&m_socket, &QUdpSocket::readyRead, &m_socket, [this] { take(); });
    }
    std::string address() const { return "127.0.0.1:" + std::to_string(m_socket.localPort()); }

    int heartbeats = 0; ///< of the station, in clear
    int greetings = 0;

private:
    void take()
    {
        while (m_socket.hasPendingDatagrams()) {
            const QNetworkDatagram datagram = m_socket.receiveDatagram();
            const QByteArray bytes = datagram.data();
            const auto from = static_cast<quint16>(datagram.senderPort());
            if (m_station == 0)
                m_station = from; // it is the first program that sends
            const auto frame = mavlink::readFrame(
                ByteView(reinterpret_cast<const std::uint8_t *>(bytes.constData()), static_cast<std::size_t>(bytes.size())),
                mavlink::Dialect::builtin());
            if (from != m_station)
                m_other = from;
            else if (frame && frame->systemId() == 255)
                ++(frame->messageId() == mavlink::Heartbeat::kId ? heartbeats : greetings);
            const quint16 to = from == m_station ? m_other : m_station;
            if (to != 0)
                m_socket.writeDatagram(bytes, QHostAddress::LocalHost, to);
        }
    }

    QUdpSocket m_socket;
    quint16 m_station = 0, m_other = 0;
};

struct CallingStation
{
    CallingStation(const engine::StationConfig &config, const Middle &middle)
    {
        auto made = engine::Station::create(config);
        if (!made)
            qFatal("%s", made.error().text().c_str());
        station = std::move(*made);
        ears = std::make_unique<StationEars>(*station);
        station->addLink(urlOf("udpout:" + middle.address()));
    }
    std::unique_ptr<engine::Station> station;
    std::unique_ptr<StationEars> ears;
};

/// For three heartbeat intervals.
bool beatsWithin(const Middle &middle)
{
    const int before = middle.heartbeats;
    return QTest::qWaitFor([&] { return middle.heartbeats > before; }, 3200);
}

} // namespace

class ClearHeartbeatTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void stationWithoutAgentsSendsHeartbeats();
    void noClearHeartbeatDuringOrAfterASession();
    void approvedVehicleGetsHeartbeats();
};

void ClearHeartbeatTest::stationWithoutAgentsSendsHeartbeats()
{
    FlightRig rig;
    const engine::StationConfig config = rig.stationConfig(engine::SecureMode::Preferred);
    QVERIFY(keys::PeersFile().save(config.keys.peers));
    Middle middle;
    CallingStation ground(config, middle);
    EVENTUALLY(middle.heartbeats >= 2);
}

void ClearHeartbeatTest::noClearHeartbeatDuringOrAfterASession()
{
    FlightRig rig;
    Middle middle;
    CallingStation ground(rig.stationConfig(engine::SecureMode::Preferred), middle);
    // A router learns where the station is without a heartbeat.
    EVENTUALLY(middle.greetings >= 2);
    QCOMPARE(middle.heartbeats, 0);
    rig.startAgent(middle.address());
    VehicleOnUdp vehicle(rig.vehicleAddress());
    EVENTUALLY(!ground.ears->all<engine::VehicleFound>().empty());
    QVERIFY(ground.ears->all<engine::VehicleFound>()[0].sealed);
    QVERIFY(!beatsWithin(middle));
    // The sealed link dies: the autopilot, which may be connected to the router as well, must detect this.
    rig.killAgent();
    QVERIFY(!beatsWithin(middle));
}

void ClearHeartbeatTest::approvedVehicleGetsHeartbeats()
{
    FlightRig rig;
    Middle middle;
    CallingStation ground(rig.stationConfig(engine::SecureMode::Preferred), middle);
    EVENTUALLY(middle.greetings >= 1);
    VehicleOnUdp vehicle(middle.address());
    EVENTUALLY_EQUAL(ground.ears->snapshot->pendingApproval.size(), std::size_t(1));
    QVERIFY(!beatsWithin(middle));
    const int before = middle.heartbeats;
    ground.station->allowPlaintext(1);
    EVENTUALLY(middle.heartbeats > before);
    EVENTUALLY_EQUAL(ground.ears->snapshot->vehicles.size(), std::size_t(1));
}

SKYSEAL_TEST(ClearHeartbeatTest)
#include "clear_heartbeat_test.moc"
