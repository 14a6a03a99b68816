// One agent with several links to the ground: a station at each, or one station behind two modems.
#include "core/channel/mac1.h"
#include "core/engine/station/snapshot.h"
#include "core/mavlink/enums.h"
#include "tests/engine/ground.h"
#include "tests/support/stranger_messages.h"
#include "tests/support/test_runner.h"
#include "tests/support/udp_attacker.h"

using namespace skyseal;
using namespace skyseal::test;

namespace {

std::string local(quint16 port)
{
    return "127.0.0.1:" + std::to_string(port);
}

std::uint64_t framesAt(const Ground &ground)
{
    return ground.ears->snapshot->mavlink.frames;
}

bool hears(const Ground &ground)
{
    return ground.up() && framesAt(ground) > 20;
}

/// Between an agent and a station: what it carries can be cut in each direction.
struct Modem
{
    explicit Modem(quint16 station) : relay(station)
    {
        relay.passes = [this](const UdpAttacker::Seen &seen) {
            const bool passes = seen.toGround ? up : down;
            carried += passes && !channel::Announcement::hasForm(viewOf(seen.bytes));
            return passes;
        };
    }
    static ByteView viewOf(const QByteArray &bytes)
    {
        return {reinterpret_cast<const std::uint8_t *>(bytes.constData()), static_cast<std::size_t>(bytes.size())};
    }

    bool up = true, down = true; ///< to the station, to the agent
    std::uint64_t carried = 0;   ///< datagrams other than announcements
    UdpAttacker relay;
};

} // namespace

class SeveralGroundsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void stationsEachAtItsLink();
    void plainFramesReachAll();
    void takesTheModemThatWorks_data();
    void takesTheModemThatWorks();
    void stationCallsAnAgentThatListens();
    void routerIsNotCalled();
    void strangersMavlinkStopsNoCalls();
    void listeningAgentIsNoAmplifier_data();
    void listeningAgentIsNoAmplifier();
    void listeningAgentIsPaired();
};

void SeveralGroundsTest::stationsEachAtItsLink()
{
    FlightRig rig;
    Ground pilot(rig.stationConfig());
    Ground observer(rig.addStation("observer", channel::PeerRole::Observer));
    rig.startAgentAt({pilot.ears->listening(), observer.ears->listening()});
    VehicleOnUdp vehicle(rig.vehicleAddress());
    EVENTUALLY(hears(pilot) && hears(observer));

    const engine::AgentSnapshot agent = rig.agent->snapshot();
    QCOMPARE(agent.grounds.size(), std::size_t(2));
    QCOMPARE(agent.grounds[0].remoteAddress, pilot.ears->listening());
    QCOMPARE(agent.grounds[1].remoteAddress, observer.ears->listening());
    QVERIFY(agent.grounds[0].rxDatagrams > 0 && agent.grounds[1].rxDatagrams > 0);

    // One station ends; the other does not notice.
    observer.station.reset();
    const std::uint64_t before = framesAt(pilot);
    EVENTUALLY(framesAt(pilot) > before + 50);
    QCOMPARE(pilot.ears->all<channel::SessionUp>().size(), std::size_t(1));
}

void SeveralGroundsTest::plainFramesReachAll()
{
    FlightRig rig;
    rig.allowPlain = true;
    Ground one(rig.stationConfig(engine::SecureMode::Off)), other(rig.stationConfig(engine::SecureMode::Off));
    rig.startAgentAt({one.ears->listening(), other.ears->listening()});
    VehicleOnUdp vehicle(rig.vehicleAddress());
    EVENTUALLY(framesAt(one) > 50 && framesAt(other) > 50);
    QCOMPARE(one.ears->snapshot->mavlink.lost, std::uint64_t(0));
    QCOMPARE(other.ears->snapshot->mavlink.lost, std::uint64_t(0));
}

void SeveralGroundsTest::takesTheModemThatWorks_data()
{
    QTest::addColumn<bool>("up");
    QTest::addColumn<bool>("down");
    QTest::newRow("cut in both directions") << false << false;
    QTest::newRow("cut towards the station") << false << true;
    QTest::newRow("cut towards the agent") << true << false;
}

/// channel/two_ways_test has the times.
void SeveralGroundsTest::takesTheModemThatWorks()
{
    QFETCH(bool, up);
    QFETCH(bool, down);
    FlightRig rig;
    Ground ground(rig.stationConfig());
    Modem first(ground.port()), second(ground.port());
    rig.startAgentAt({local(first.relay.port()), local(second.relay.port())});
    VehicleOnUdp vehicle(rig.vehicleAddress());
    EVENTUALLY(hears(ground));
    QCOMPARE(ground.ears->all<channel::SessionUp>().size(), std::size_t(1));

    const bool usedFirst = first.carried > second.carried;
    Modem &used = usedFirst ? first : second, &other = usedFirst ? second : first;
    for (const bool back : {false, true}) { // to the other modem, then back
        Modem &failing = back ? other : used, &good = back ? used : other;
        good.up = good.down = true;
        failing.up = up;
        failing.down = down;
        // Telemetry comes again, and what the station sends reaches the vehicle.
        const std::uint64_t carried = good.carried;
        EVENTUALLY(good.carried > carried + 50);
        const std::uint64_t frames = framesAt(ground), commands = rig.agent->snapshot().counters.toVehicle;
        EVENTUALLY(framesAt(ground) > frames + 20);
        EVENTUALLY(rig.agent->snapshot().counters.toVehicle > commands + 1);
        QCOMPARE(int(ground.ears->snapshot->security), int(engine::Security::Sealed));
    }
}

void SeveralGroundsTest::stationCallsAnAgentThatListens()
{
    FlightRig rig;
    rig.startAgentOn({urlOf("udpin:127.0.0.1:0")});
    VehicleOnUdp vehicle(rig.vehicleAddress());
    const std::string port = rig.agent->snapshot().grounds.at(0).localAddress;
    Ground caller(rig.stationConfig(), urlOf("udpout:" + port));
    Ground second(rig.addStation("observer", channel::PeerRole::Observer), urlOf("udpout:" + port));
    EVENTUALLY(hears(caller));
    // The agent restarts, which reads the list with the second station: both find it again.
    rig.killAgent();
    rig.startAgentOn({urlOf("udpin:" + port)});
    EVENTUALLY(hears(second));
    EVENTUALLY_EQUAL(caller.ears->all<channel::SessionUp>().size(), std::size_t(2));
    const std::uint64_t frames = framesAt(caller);
    EVENTUALLY(framesAt(caller) > frames + 20);
}

/// Where MAVLink comes from, no agent listens: the station greets routers, and sends nothing else.
void SeveralGroundsTest::routerIsNotCalled()
{
    QUdpSocket router;
    QVERIFY(router.bind(QHostAddress::LocalHost, 0));
    int greetings = 0, calls = 0;
    bool answers = false;
    QObject::connect(&router, &QUdpSocket::readyRead, &router, [&] {
        while (router.hasPendingDatagrams()) {
            const QNetworkDatagram datagram = router.receiveDatagram();
            const bool isCall = datagram.data().size() == 127 && datagram.data().at(0) == 0x59;
            ++(isCall ? calls : greetings);
            if (!answers)
                continue;
            std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
            mavlink::FrameWriter writer(2, 1);
            const ByteView frame = writer.write(
                mavlink::Heartbeat{.type = mavlink::MAV_TYPE_QUADROTOR, .autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA},
                buffer);
            router.writeDatagram(datagram.makeReply(
                QByteArray(reinterpret_cast<const char *>(frame.data()), static_cast<qsizetype>(frame.size()))));
        }
    });
    FlightRig rig;
    Ground caller(rig.stationConfig(), urlOf("udpout:" + local(router.localPort())));
    EVENTUALLY(greetings > 0 && calls > 2);
    answers = true;
    const int before = greetings;
    EVENTUALLY(greetings > before);
    EVENTUALLY(!caller.ears->all<engine::PlaintextRefused>().empty()); // the answer has arrived
    const int called = calls, greeted = greetings;
    EVENTUALLY(greetings > greeted + 4);
    QVERIFY2(calls <= called + 1, qPrintable(QString::number(calls - called))); // one may have been on its way
}

/// MAVLink that comes to the port of a calling station from another address than the called one says nothing about that one.
void SeveralGroundsTest::strangersMavlinkStopsNoCalls()
{
    QUdpSocket place; // where an agent will listen
    QVERIFY(place.bind(QHostAddress::LocalHost, 0));
    quint16 station = 0;
    QObject::connect(&place, &QUdpSocket::readyRead, &place, [&] {
        while (place.hasPendingDatagrams())
            station = static_cast<quint16>(place.receiveDatagram().senderPort());
    });
    FlightRig rig;
    Ground caller(rig.stationConfig(), urlOf("udpout:" + local(place.localPort())));
    EVENTUALLY(station != 0);
    QUdpSocket stranger;
    QVERIFY(stranger.bind(QHostAddress::LocalHost, 0));
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    mavlink::FrameWriter writer(2, 1);
    const ByteView frame = writer.write(
        mavlink::Heartbeat{.type = mavlink::MAV_TYPE_QUADROTOR, .autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA}, buffer);
    stranger.writeDatagram(reinterpret_cast<const char *>(frame.data()), static_cast<qint64>(frame.size()),
                           QHostAddress::LocalHost, station);
    EVENTUALLY(!caller.ears->all<engine::PlaintextRefused>().empty()); // it has arrived
    const quint16 port = place.localPort();
    place.close();
    rig.startAgentOn({urlOf("udpin:" + local(port))});
    VehicleOnUdp vehicle(rig.vehicleAddress());
    EVENTUALLY(hears(caller));
}

void SeveralGroundsTest::listeningAgentIsNoAmplifier_data()
{
    QTest::addColumn<bool>("pairing");
    QTest::newRow("pairing closed") << false;
    QTest::newRow("pairing open") << true;
}

/// Each datagram of a stranger causes at most as many bytes as it has, and without one nothing is sent.
void SeveralGroundsTest::listeningAgentIsNoAmplifier()
{
    QFETCH(bool, pairing);
    FlightRig rig;
    rig.startAgentOn({urlOf("udpin:127.0.0.1:0")});
    VehicleOnUdp vehicle(rig.vehicleAddress());
    const auto agent = [&] { return rig.agent->snapshot(); };
    const quint16 port = portOf(agent().grounds.at(0).localAddress);
    EVENTUALLY(agent().mavlink.frames > 50);
    QCOMPARE(agent().grounds[0].txBytes, std::uint64_t(0));

    QUdpSocket stranger;
    QVERIFY(stranger.bind(QHostAddress::LocalHost, 0));
    StrangersKnowledge knows{rig.agent->publicKey(), {}, {}, {}};
    const channel::PairingDatagram request = channel::pairingRequest();
    const QByteArray asked(reinterpret_cast<const char *>(request.data()), static_cast<qsizetype>(request.size()));
    if (pairing) {
        QVERIFY(rig.agent->openPairing("air"));
        stranger.writeDatagram(asked, QHostAddress::LocalHost, port);
        EVENTUALLY(stranger.hasPendingDatagrams());
        const QByteArray call = stranger.receiveDatagram().data();
        QCOMPARE(call.size(), asked.size());
        knows.token = channel::calledToken(Modem::viewOf(call)).value();
    }
    std::mt19937_64 random(1);
    std::uint64_t sent = pairing ? 1 : 0;
    for (const StrangerMessage &message : kStrangerMessages) {
        for (int i = 0; i < 100; ++i) {
            const Bytes bytes = message.make(knows, random);
            const std::uint64_t before = agent().grounds[0].txBytes, datagrams = agent().grounds[0].rxDatagrams;
            stranger.writeDatagram(reinterpret_cast<const char *>(bytes.data()), static_cast<qint64>(bytes.size()),
                                   QHostAddress::LocalHost, port);
            ++sent;
            EVENTUALLY(agent().grounds[0].rxDatagrams > datagrams);
            QVERIFY2(agent().grounds[0].txBytes - before <= bytes.size(), message.name);
        }
    }
    if (!pairing) {
        const std::uint64_t quiet = agent().grounds[0].txBytes;
        stranger.writeDatagram(asked, QHostAddress::LocalHost, port);
        EVENTUALLY(agent().grounds[0].rxDatagrams > sent);
        QCOMPARE(agent().grounds[0].txBytes, quiet);
        ++sent;
    }
    QCOMPARE(agent().grounds[0].rxDatagrams, sent);
    const std::uint64_t told = agent().grounds[0].txBytes, frames = agent().mavlink.frames;
    EVENTUALLY(agent().mavlink.frames > frames + 100);
    QCOMPARE(agent().grounds[0].txBytes, told); // nothing follows, and no telemetry
}

/// A station that the agent does not know calls it by its udpout link.
void SeveralGroundsTest::listeningAgentIsPaired()
{
    FlightRig rig;
    rig.introduceStation(false);
    rig.startAgentOn({urlOf("udpin:127.0.0.1:0")});
    Ground caller(rig.stationConfig(), urlOf("udpout:" + rig.agent->snapshot().grounds.at(0).localAddress));
    std::vector<channel::PairingEvent> seen;
    QObject::connect(caller.station.get(), &engine::Station::pairing, caller.station.get(),
                     [&](const channel::PairingEvent &event) { seen.push_back(event); });
    const auto shownHere = [&] {
        return std::ranges::any_of(seen,
                                   [](const auto &event) { return std::holds_alternative<channel::PairingPeerSeen>(event); });
    };
    const auto atAgent = [&]() -> const channel::PairingPeerSeen * {
        for (const engine::AgentEvent &event : rig.agentEvents) {
            const auto *pairing = std::get_if<channel::PairingEvent>(&event);
            if (const auto *peer = pairing ? std::get_if<channel::PairingPeerSeen>(pairing) : nullptr)
                return peer;
        }
        return nullptr;
    };
    QVERIFY(rig.agent->openPairing("air"));
    caller.station->openPairing("ground");
    EVENTUALLY(shownHere() && atAgent());
    const auto peer = std::ranges::find_if(
        seen, [](const auto &event) { return std::holds_alternative<channel::PairingPeerSeen>(event); });
    const channel::PairingPeer &here = std::get<channel::PairingPeerSeen>(*peer).peer;
    QCOMPARE(here.key, rig.agent->publicKey());
    QCOMPARE(here.code, atAgent()->peer.code);
    caller.station->confirmPairing(here.key);
    rig.agent->confirmPairing(atAgent()->peer.key);
    const auto paired = [&] {
        return std::ranges::any_of(seen, [](const auto &event) { return std::holds_alternative<channel::Paired>(event); });
    };
    EVENTUALLY(paired());
}

SKYSEAL_TEST(SeveralGroundsTest)
#include "several_grounds_test.moc"
