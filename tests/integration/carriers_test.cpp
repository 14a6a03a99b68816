// Real programs over what is no datagram: a serial line, a TCP connection, MAVLink routers. A session comes up by itself,
// walks through all suites and loses nothing; a command gets through; and routers see nothing but TUNNEL and the agent's
// heartbeat. With SKYSEAL_MAVLINK_ROUTERD naming the program, also through the real mavlink-router.
#include "tests/support/flight.h"
#include "tests/support/mavlink_hub.h"
#include "tests/support/null_modem.h"
#include "tests/support/router_spoofers.h"
#include "tests/support/tcp_cable.h"

#include <QtCore/QFile>
#include <QtCore/QJsonDocument>
#include <QtNetwork/QTcpSocket>
#include <QtTest/QTest>

#include <algorithm>
#include <array>
#include <functional>

using namespace skyseal;
using namespace skyseal::test;

namespace {

constexpr int kSeconds = 20;

QStringList with(QStringList arguments, const char *option, const QString &value)
{
    const qsizetype at = arguments.indexOf(QLatin1String(option));
    if (at >= 0)
        arguments[at + 1] = value;
    return arguments;
}

QString loopback(const char *scheme, quint16 port)
{
    return QStringLiteral("%1:127.0.0.1:%2").arg(QLatin1String(scheme)).arg(port);
}

QString serial(const QString &device, int baud)
{
    return QStringLiteral("serial:%1:%2").arg(device).arg(baud);
}

QStringList words(std::initializer_list<const char *> texts)
{
    QStringList out;
    for (const char *text : texts)
        out += QLatin1String(text);
    return out;
}

qint64 number(const QJsonObject &object, const char *key)
{
    return object[QLatin1String(key)].toInteger();
}

/// A flight over links of the caller's.
struct Way
{
    QString ground;  ///< the agent's --ground
    QString station; ///< the monitor's --link
    QString carrier; ///< empty: the default
    int rate = 20;   ///< Hz of each stream
    bool spoofed = false; ///< somebody sends clear frames beside it
};

} // namespace

class CarriersTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void serialLine();
    void noisySerialLine();
    void tcp();
    void tcpConnectionCut();
    void idleConnectionsKeepNobodyOut();
    void tunnelThroughAHub();
    void tunnelToAStationThatCalls();
    void tunnelOnASerialLine();
    void routersSeeNoMore();
    void spoofersAtTheHub();
    void mavlinkRouter();
    void spoofersAtMavlinkRouter();
    void pairing_data();
    void pairing();
    void optionsThatDoNotFit();

private:
    void fly(Flight &flight, const Way &way, const char *carrier);
};

/// Through all suites, with a command at the end; nothing may be lost.
void CarriersTest::fly(Flight &flight, const Way &way, const char *carrier)
{
    QVERIFY(flight.ready());
    QStringList air = with(flight.airArguments(), "--ground", way.ground);
    if (!way.carrier.isEmpty())
        air += {QStringLiteral("--carrier"), way.carrier};
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    Program agent(QStringLiteral("skyseal-air"), air);
    Program monitor(QStringLiteral("skyseal-cli"),
                    with(flight.monitorArguments(), "--link", way.station)
                        + words({"--do", "wait ekf_ok==1 60; mode GUIDED; arm; takeoff 3; wait alt_rel>=2.5 60",
                                 "--switch-every", "1.5", "--switch-to"})
                        + QStringList{allSuites(), QStringLiteral("--stream-rate"), QString::number(way.rate),
                                      QStringLiteral("--duration"), QString::number(kSeconds)});
    const QJsonObject session = monitor.waitFor(QStringLiteral("session"), 15000);
    QVERIFY2(session[QLatin1String("state")] == QLatin1String("up"), monitor.errors() + agent.errors());
    QCOMPARE(session[QLatin1String("carrier")].toString(), QLatin1String(carrier));
    const QJsonObject vehicle = monitor.waitFor(QStringLiteral("vehicle"), 15000);
    QCOMPARE(number(vehicle, "sysid"), 1);
    QCOMPARE(monitor.waitForExit((kSeconds + 90) * 1000), 0);

    const QJsonObject summary = monitor.last(QStringLiteral("summary"));
    const QJsonObject mavlink = summary[QLatin1String("mavlink")].toObject();
    const QJsonObject received = summary[QLatin1String("channel")][QLatin1String("rx")].toObject();
    QVERIFY2(number(mavlink, "frames") > 300, qPrintable(QString::number(number(mavlink, "frames"))));
    for (const char *counter : {"lost", "duplicate", "bad_crc"})
        QVERIFY2(number(mavlink, counter) == 0, counter);
    for (const char *counter : {"lost", "replayed", "forged", "malformed"})
        QVERIFY2(number(received, counter) == 0, counter);
    QCOMPARE(number(received, "plaintext_dropped") > 0, way.spoofed);
    const auto sessions = monitor.events(QStringLiteral("session"));
    QCOMPARE(std::count_if(sessions.begin(), sessions.end(), [](const QJsonObject &event) {
                 return event[QLatin1String("state")] == QLatin1String("up");
             }), 1);
    std::size_t committed = 0;
    for (const QJsonObject &event : monitor.events(QStringLiteral("switch"))) {
        QVERIFY2(event[QLatin1String("result")] == QLatin1String("committed"), QJsonDocument(event).toJson());
        ++committed;
    }
    QVERIFY(committed >= 6);
    QCOMPARE(agent.terminate(), 0);
    qInfo("%s: %lld frames in %lld records", carrier, static_cast<long long>(number(mavlink, "frames")),
          static_cast<long long>(number(received, "good")));
}

void CarriersTest::serialLine()
{
    NullModem line;
    Flight flight;
    fly(flight, {serial(line.device(0), 115200), serial(line.device(1), 115200), {}}, "serial");
}

void CarriersTest::noisySerialLine()
{
    NullModem line;
    int spoilt = 0; // at most so many records: a spoilt delimiter makes one of two
    // One byte of some 2000, as a bad radio does it; from the beginning.
    line.noise = [&spoilt, at = std::uint64_t(0)](std::size_t, std::array<char, 4096> &bytes, std::size_t size) mutable {
        for (std::size_t i = 0; i < size; ++i) {
            if (++at % 2003 == 0) {
                spoilt += bytes[i] == 0 ? 2 : 1;
                bytes[i] = static_cast<char>(bytes[i] ^ (at % 3 == 0 ? bytes[i] : 0x41));
            }
        }
    };
    Flight flight;
    QVERIFY(flight.ready());
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    Program agent(QStringLiteral("skyseal-air"), with(flight.airArguments(), "--ground", serial(line.device(0), 57600)));
    Program monitor(QStringLiteral("skyseal-cli"),
                    with(flight.monitorArguments(words({"--duration", "15", "--switch-to"}) + QStringList{allSuites()}),
                         "--link", serial(line.device(1), 57600)));
    QVERIFY(!monitor.waitFor(QStringLiteral("session"), 15000).isEmpty());
    QCOMPARE(monitor.waitForExit(60000), 0);
    const QJsonObject summary = monitor.last(QStringLiteral("summary"));
    const QJsonObject received = summary[QLatin1String("channel")][QLatin1String("rx")].toObject();
    const qint64 good = number(received, "good");
    QVERIFY(spoilt > 10);
    QVERIFY2(number(received, "lost") <= spoilt && good > 3 * number(received, "lost"),
             qPrintable(QStringLiteral("%1 good, %2 lost, %3 spoilt").arg(good).arg(number(received, "lost")).arg(spoilt)));
    QCOMPARE(number(summary[QLatin1String("mavlink")].toObject(), "bad_crc"), 0);
}

void CarriersTest::tcp()
{
    Flight flight;
    const quint16 port = freeTcpPort();
    fly(flight, {loopback("tcp", port), loopback("tcpin", port), {}, 50}, "serial");
}

void CarriersTest::tcpConnectionCut()
{
    Flight flight;
    QVERIFY(flight.ready());
    const quint16 port = freeTcpPort();
    TcpCable cable(port);
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    Program monitor(QStringLiteral("skyseal-cli"), with(flight.monitorArguments(), "--link", loopback("tcpin", port)));
    QVERIFY(!monitor.waitFor(QStringLiteral("link"), 10000).isEmpty());
    Program agent(QStringLiteral("skyseal-air"), with(flight.airArguments(), "--ground", loopback("tcp", cable.port())));
    QVERIFY(!monitor.waitFor(QStringLiteral("session"), 15000).isEmpty());
    QVERIFY(!monitor.waitFor(QStringLiteral("vehicle"), 15000).isEmpty());
    const auto received = [&monitor](const char *counter) {
        const QJsonObject stats = monitor.waitFor(QStringLiteral("stats"), 5000);
        return number(stats[QLatin1String("channel")][QLatin1String("rx")].toObject(), counter);
    };
    for (int cut = 1; cut <= 3; ++cut) {
        cable.cut();
        QTRY_COMPARE_WITH_TIMEOUT(cable.joined, cut + 1, 10000);
        monitor.skipWhatCame();
        const qint64 before = received("good");
        QTRY_VERIFY_WITH_TIMEOUT(received("good") > before + 20, 10000);
    }
    // It is the same session all the time, found again by its first report.
    QCOMPARE(monitor.events(QStringLiteral("session")).size(), std::size_t(1));
    QCOMPARE(received("forged"), 0);
}

void CarriersTest::idleConnectionsKeepNobodyOut()
{
    // More connections than there are places, from which nothing ever comes; and more of them while a session is up.
    Flight flight;
    QVERIFY(flight.ready());
    const quint16 port = freeTcpPort();
    Program monitor(QStringLiteral("skyseal-cli"), with(flight.monitorArguments(), "--link", loopback("tcpin", port)));
    QVERIFY(!monitor.waitFor(QStringLiteral("link"), 10000).isEmpty());
    std::vector<std::unique_ptr<QTcpSocket>> idle;
    int connected = 0; // not one that is turned away before it has noticed that it was connected
    const auto connectIdle = [&](int count) {
        for (int i = 0; i < count; ++i) {
            idle.push_back(std::make_unique<QTcpSocket>());
            idle.back()->connectToHost(QHostAddress(QHostAddress::LocalHost), port);
            connected += idle.back()->waitForConnected(10000);
        }
    };
    connectIdle(40);
    QVERIFY2(connected >= 32, qPrintable(QString::number(connected)));
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    Program agent(QStringLiteral("skyseal-air"), with(flight.airArguments(), "--ground", loopback("tcp", port)));
    QVERIFY(!monitor.waitFor(QStringLiteral("session"), 20000).isEmpty());
    connectIdle(80);
    const auto good = [&monitor] {
        return number(monitor.waitFor(QStringLiteral("stats"), 5000)[QLatin1String("channel")][QLatin1String("rx")].toObject(),
                      "good");
    };
    monitor.skipWhatCame();
    const qint64 before = good();
    QTRY_VERIFY_WITH_TIMEOUT(good() > before + 100, 10000);
    QCOMPARE(monitor.events(QStringLiteral("session")).size(), std::size_t(1));
}

void CarriersTest::tunnelThroughAHub()
{
    MavlinkHub hub;
    Flight flight;
    hub.setRemote(1, flight.groundPort);
    fly(flight, {loopback("udpout", hub.port(0)), loopback("udpin", flight.groundPort), QStringLiteral("tunnel")}, "tunnel");
    QVERIFY(hub.passed[385] > 300);
    QVERIFY(hub.passed[0] > kSeconds - 4); // the agent's heartbeats
    QCOMPARE(hub.passed.size(), std::size_t(2));
    QCOMPARE(hub.unrouted.size(), std::size_t(0));
    QCOMPARE(hub.notMavlink, 0);
    QVERIFY(hub.longest <= 145); // radios refuse payloads of 230
}

void CarriersTest::tunnelToAStationThatCalls()
{
    // The router waits to be called by both: it knows the station by its greeting.
    MavlinkHub hub;
    Flight flight;
    fly(flight, {loopback("udpout", hub.port(0)), loopback("udpout", hub.port(1)), QStringLiteral("tunnel")}, "tunnel");
    QCOMPARE(hub.notMavlink, 0);
}

void CarriersTest::tunnelOnASerialLine()
{
    NullModem line;
    Flight flight;
    fly(flight, {serial(line.device(0), 115200), serial(line.device(1), 115200), QStringLiteral("tunnel")}, "tunnel");
}

void CarriersTest::routersSeeNoMore()
{
    MavlinkHub hub;
    Flight flight;
    QVERIFY(flight.ready());
    hub.setRemote(1, flight.groundPort);
    std::set<std::pair<int, int>> speakers;
    bool telemetryInClear = false;
    hub.filter = [&](const mavlink::Frame &frame) {
        speakers.insert({frame.systemId(), frame.componentId()});
        telemetryInClear = telemetryInClear || (frame.messageId() == 0 && frame.payload()[5] != 8);
        return true;
    };
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    Program agent(QStringLiteral("skyseal-air"), with(flight.airArguments(), "--ground", loopback("udpout", hub.port(0)))
                      + QStringList{QStringLiteral("--carrier"), QStringLiteral("tunnel")});
    Program monitor(QStringLiteral("skyseal-cli"), flight.monitorArguments());
    QVERIFY(!monitor.waitFor(QStringLiteral("vehicle"), 20000).isEmpty());
    for (int second = 0; second < 3; ++second)
        QVERIFY(!monitor.waitFor(QStringLiteral("stats"), 5000).isEmpty());
    QCOMPARE(speakers, (std::set<std::pair<int, int>>{{1, 191}, {255, 190}}));
    QVERIFY(!telemetryInClear);
    // The heartbeat that routers need is no clear telemetry that was refused.
    const QJsonObject channel = monitor.last(QStringLiteral("stats"))[QLatin1String("channel")].toObject();
    QCOMPARE(number(channel[QLatin1String("rx")].toObject(), "plaintext_dropped"), 0);
}

/// Armed heartbeats in all three names, from before the session until after it: it comes up, flies and holds all the same.
void CarriersTest::spoofersAtTheHub()
{
    MavlinkHub hub(5);
    Flight flight;
    hub.setRemote(1, flight.groundPort);
    RouterSpoofers<QUdpSocket> spoofers([&hub](std::size_t i, QUdpSocket &socket) {
        socket.connectToHost(QHostAddress(QHostAddress::LocalHost), hub.port(2 + i));
    });
    fly(flight, {loopback("udpout", hub.port(0)), loopback("udpin", flight.groundPort), QStringLiteral("tunnel"), 20, true}, "tunnel");
    QVERIFY(spoofers.copied > 100 && !spoofers.more); // what it gets of them is sealed
}

void CarriersTest::mavlinkRouter()
{
    const QString program = qEnvironmentVariable("SKYSEAL_MAVLINK_ROUTERD");
    if (program.isEmpty())
        QSKIP("SKYSEAL_MAVLINK_ROUTERD names no mavlink-routerd");
    Flight flight;
    const quint16 port = freeUdpPort();
    const QString address = QStringLiteral("127.0.0.1:%1");
    Program router(program, words({"-t", "0", "-e"}) + QStringList{address.arg(flight.groundPort), address.arg(port)});
    fly(flight, {loopback("udpout", port), loopback("udpin", flight.groundPort), QStringLiteral("tunnel")}, "tunnel");
    QVERIFY2(router.running(), router.errors());
}

void CarriersTest::spoofersAtMavlinkRouter()
{
    const QString program = qEnvironmentVariable("SKYSEAL_MAVLINK_ROUTERD");
    if (program.isEmpty())
        QSKIP("SKYSEAL_MAVLINK_ROUTERD names no mavlink-routerd");
    Flight flight;
    const quint16 port = freeUdpPort(), door = freeTcpPort();
    const QString address = QStringLiteral("127.0.0.1:%1");
    Program router(program, words({"-t"}) + QStringList{QString::number(door), QStringLiteral("-e"), address.arg(flight.groundPort), address.arg(port)});
    RouterSpoofers<QTcpSocket> spoofers([door](std::size_t, QTcpSocket &socket) {
        const auto connected = [&] {
            if (socket.state() == QAbstractSocket::ConnectedState)
                return true;
            socket.abort();
            socket.connectToHost(QHostAddress(QHostAddress::LocalHost), door);
            return socket.waitForConnected(1000);
        };
        QTRY_VERIFY(connected());
    });
    fly(flight, {loopback("udpout", port), loopback("udpin", flight.groundPort), QStringLiteral("tunnel"), 20, true}, "tunnel");
    QVERIFY2(router.running(), router.errors());
    QVERIFY(spoofers.copied > 100 && !spoofers.more);
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
        return show.waitFor(QStringLiteral("key"), 10000)[QLatin1String("fingerprint")].toString();
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
    QVERIFY(!agent.waitFor(QStringLiteral("link"), 10000).isEmpty());
    Program ground(QStringLiteral("skyseal-cli"),
                   words({"keys", "pair", "--json", "--link"})
                       + QStringList{tunnel ? loopback("udpin", flight.groundPort) : loopback("tcpin", port),
                                     QStringLiteral("--identity"), flight.path(QStringLiteral("ground.key")),
                                     QStringLiteral("--peers"), flight.path(QStringLiteral("ground.new")),
                                     QStringLiteral("--expect"), fingerprint("air.key")});
    Program desk(QStringLiteral("skyseal-air"),
                 words({"--pair", "--json", "--identity"})
                     + QStringList{flight.path(QStringLiteral("air.key")), QStringLiteral("--expect"),
                                   fingerprint("ground.key")});
    QCOMPARE(ground.waitForExit(30000), 0);
    QCOMPARE(desk.waitForExit(30000), 0);
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
        return air.waitForExit(10000);
    };
    QCOMPARE(status(QStringLiteral("udpin:0.0.0.0:14550"), {}), 2);
    QCOMPARE(status(QStringLiteral("tlog:flight.tlog"), QStringLiteral("tunnel")), 2);
    QCOMPARE(status(QStringLiteral("udpout:127.0.0.1:14550"), QStringLiteral("serial")), 2);
    QCOMPARE(status(QStringLiteral("tcp:127.0.0.1:14550"), QStringLiteral("datagram")), 2);
    QCOMPARE(status(QStringLiteral("udpout:127.0.0.1:14550"), QStringLiteral("pigeon")), 2);
}

QTEST_GUILESS_MAIN(CarriersTest)
#include "carriers_test.moc"
