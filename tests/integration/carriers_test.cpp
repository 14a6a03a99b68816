// Real programs over a serial line, a TCP connection and MAVLink routers. The session comes up without help, switches through
// all suites and loses nothing; commands reach the vehicle; and the routers see only TUNNEL messages and the agent's
// heartbeat. With SKYSEAL_MAVLINK_ROUTERD naming the program, also through the real mavlink-router.
#include "carrier_flight.h"
#include "tests/support/addresses.h"
#include "tests/support/mavlink_hub.h"
#include "tests/support/null_modem.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>

using namespace skyseal;
using namespace skyseal::test;

class CarriersTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void serialLine();
    void tcp();
    void tunnelThroughAHub();
    void tunnelToAStationThatCalls();
    void tunnelOnASerialLine();
    void mavlinkRouter();
    void pairing_data();
    void pairing();
    void optionsThatDoNotFit();
};

void CarriersTest::serialLine()
{
    NullModem line;
    Flight flight;
    fly(flight, {serial(line.device(0), 115200), serial(line.device(1), 115200), {}}, "serial");
}

void CarriersTest::tcp()
{
    Flight flight;
    const quint16 port = freeTcpPort();
    fly(flight, {loopback("tcp", port), loopback("tcpin", port), {}, 50}, "serial");
}

void CarriersTest::tunnelThroughAHub()
{
    MavlinkHub hub;
    Flight flight;
    hub.setRemote(1, flight.groundPort);
    fly(flight, {loopback("udpout", hub.port(0)), loopback("udpin", flight.groundPort), QStringLiteral("tunnel")}, "tunnel");
    QVERIFY(hub.passed[385] > 300);
    QVERIFY(hub.passed[0] > kSeconds / 2); // the agent's heartbeats, one a second
    QCOMPARE(hub.passed.size(), std::size_t(2));
    QCOMPARE(hub.unrouted.size(), std::size_t(0));
    QCOMPARE(hub.notMavlink, 0);
    QVERIFY(hub.longest <= 145); // radios refuse payloads of 230
}

void CarriersTest::tunnelToAStationThatCalls()
{
    // Both ends connect to the router, which learns where the station is from the station's greeting.
    MavlinkHub hub;
    Flight flight;
    fly(flight, {loopback("udpout", hub.port(0)), loopback("udpout", hub.port(1)), QStringLiteral("tunnel")}, "tunnel");
    // Before it has heard MAVLink, the station may look for an agent that listens there (several_grounds_test).
    QVERIFY2(hub.notMavlink <= 10, qPrintable(QString::number(hub.notMavlink)));
}

void CarriersTest::tunnelOnASerialLine()
{
    NullModem line;
    Flight flight;
    fly(flight, {serial(line.device(0), 115200), serial(line.device(1), 115200), QStringLiteral("tunnel")}, "tunnel");
}

void CarriersTest::mavlinkRouter()
{
    SKYSEAL_REQUIRES("mavlink_router");
    const QString program = qEnvironmentVariable("SKYSEAL_MAVLINK_ROUTERD");
    Flight flight;
    const quint16 port = freeUdpPort();
    const QString address = QStringLiteral("127.0.0.1:%1");
    Program router(program, words({"-t", "0", "-e"}) + QStringList{address.arg(flight.groundPort), address.arg(port)});
    fly(flight, {loopback("udpout", port), loopback("udpin", flight.groundPort), QStringLiteral("tunnel")}, "tunnel");
    QVERIFY2(router.running(), router.errors());
}

void CarriersTest::pairing_data()
{
    QTest::addColumn<bool>("tunnel");
    QTest::newRow("serial") << false;
    QTest::newRow("tunnel") << true;
}

void CarriersTest::pairing()
{
    QFETCH(bool, tunnel);
    Flight flight;
    QVERIFY(flight.ready());
    const auto fingerprint = [&flight](const char *key) {
        Program show(QStringLiteral("skyseal-cli"), words({"keys", "show", "--json"}) << flight.path(QLatin1String(key)));
        return show.waitFor(QStringLiteral("key"))[QLatin1String("fingerprint")].toString();
    };
    for (const char *peers : {"ground.new", "air.new"}) {
        QFile empty(flight.path(QLatin1String(peers)));
        QVERIFY(empty.open(QIODevice::WriteOnly));
    }
    MavlinkHub hub;
    hub.setRemote(1, flight.groundPort);
    const quint16 port = freeTcpPort();
    QStringList air = with(with(flight.airArguments(), "--peers", flight.path(QStringLiteral("air.new"))), "--ground",
                           tunnel ? loopback("udpout", hub.port(0)) : loopback("tcp", port));
    if (tunnel)
        air += words({"--carrier", "tunnel"});
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    Program agent(QStringLiteral("skyseal-air"), air);
    QVERIFY(!agent.waitFor(QStringLiteral("link")).isEmpty());
    Program ground(QStringLiteral("skyseal-cli"),
                   words({"keys", "pair", "--json", "--link"})
                       + QStringList{tunnel ? loopback("udpin", flight.groundPort) : loopback("tcpin", port),
                                     QStringLiteral("--identity"), flight.path(QStringLiteral("ground.key")),
                                     QStringLiteral("--peers"), flight.path(QStringLiteral("ground.new")),
                                     QStringLiteral("--expect"), fingerprint("air.key")});
    Program desk(
        QStringLiteral("skyseal-air"),
        words({"--pair", "--json", "--identity"})
            + QStringList{flight.path(QStringLiteral("air.key")), QStringLiteral("--expect"), fingerprint("ground.key")});
    QCOMPARE(ground.waitForExit(), 0);
    QCOMPARE(desk.waitForExit(), 0);
}

void CarriersTest::optionsThatDoNotFit()
{
    Flight flight;
    QVERIFY(flight.ready());
    const auto status = [&](const QString &ground, const QString &carrier) {
        QStringList arguments = with(flight.airArguments(), "--ground", ground);
        if (!carrier.isEmpty())
            arguments += {QStringLiteral("--carrier"), carrier};
        Program air(QStringLiteral("skyseal-air"), arguments);
        return air.waitForExit();
    };
    QCOMPARE(status(QStringLiteral("udpin:127.0.0.1:14550"), QStringLiteral("tunnel")), 2);
    QCOMPARE(status(QStringLiteral("tlog:flight.tlog"), QStringLiteral("tunnel")), 2);
    QCOMPARE(status(QStringLiteral("udpout:127.0.0.1:14550"), QStringLiteral("serial")), 2);
    QCOMPARE(status(QStringLiteral("tcp:127.0.0.1:14550"), QStringLiteral("datagram")), 2);
    QCOMPARE(status(QStringLiteral("udpout:127.0.0.1:14550"), QStringLiteral("pigeon")), 2);
    // A carrier behind the URL is for that link alone.
    QCOMPARE(status(QStringLiteral("udpout:127.0.0.1:14550,carrier=serial"), {}), 2);
    QCOMPARE(status(QStringLiteral("tcp:127.0.0.1:14550,carrier=datagram"), QStringLiteral("tunnel")), 2);
    QCOMPARE(status(QStringLiteral("udpout:127.0.0.1:14550,speed=9"), {}), 2);
    // More links than there may be, and one twice.
    const auto withMore = [&](int more, int step) {
        QStringList arguments = flight.airArguments();
        for (int i = 0; i < more; ++i)
            arguments += {QStringLiteral("--ground"), loopback("udpout", static_cast<quint16>(20000 + i * step))};
        return Program(QStringLiteral("skyseal-air"), arguments).waitForExit();
    };
    QCOMPARE(withMore(8, 1), 2); // nine with that of the flight
    QCOMPARE(withMore(2, 0), 2);
}

SKYSEAL_TEST(CarriersTest)
#include "carriers_test.moc"
