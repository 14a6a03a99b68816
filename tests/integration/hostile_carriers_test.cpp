// Real programs over bad serial lines, with cut or idle connections, and behind a MAVLink router with an attacker that uses
// every system id: the session stays up and loses only damaged records. With SKYSEAL_MAVLINK_ROUTERD set to the program, the
// real mavlink-router is tested as well.
#include "carrier_flight.h"
#include "tests/support/addresses.h"
#include "tests/support/eventually.h"
#include "tests/support/mavlink_hub.h"
#include "tests/support/null_modem.h"
#include "tests/support/router_spoofers.h"
#include "tests/support/tcp_cable.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtNetwork/QTcpSocket>

#include <array>
#include <memory>
#include <set>
#include <vector>

using namespace skyseal;
using namespace skyseal::test;

class HostileCarriersTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void noisySerialLine();
    void tcpConnectionCut();
    void idleConnectionsDoNotBlock();
    void routersSeeNoTelemetry();
    void spoofersAtTheHub();
    void spoofersAtMavlinkRouter();
};

void HostileCarriersTest::noisySerialLine()
{
    NullModem line;
    int spoilt = 0; // damaged records at most: a damaged delimiter joins two
    // One of about 2000 bytes is damaged, as on a bad radio, from the beginning.
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
    QVERIFY(!monitor.waitFor(QStringLiteral("session")).isEmpty());
    QCOMPARE(monitor.waitForExit(), 0);
    const QJsonObject summary = monitor.last(QStringLiteral("summary"));
    const QJsonObject received = summary[QLatin1String("channel")][QLatin1String("rx")].toObject();
    const qint64 good = number(received, "good");
    QVERIFY(spoilt > 10);
    QVERIFY2(number(received, "lost") <= spoilt && good > 3 * number(received, "lost"),
             qPrintable(QStringLiteral("%1 good, %2 lost, %3 spoilt").arg(good).arg(number(received, "lost")).arg(spoilt)));
    QCOMPARE(number(summary[QLatin1String("mavlink")].toObject(), "bad_crc"), 0);
}

void HostileCarriersTest::tcpConnectionCut()
{
    Flight flight;
    QVERIFY(flight.ready());
    const quint16 port = freeTcpPort();
    TcpCable cable(port);
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    Program monitor(QStringLiteral("skyseal-cli"), with(flight.monitorArguments(), "--link", loopback("tcpin", port)));
    QVERIFY(monitor.waitUntilListening(QStringLiteral("tcpin")));
    Program agent(QStringLiteral("skyseal-air"), with(flight.airArguments(), "--ground", loopback("tcp", cable.port())));
    QVERIFY(!monitor.waitFor(QStringLiteral("session")).isEmpty());
    QVERIFY(!monitor.waitFor(QStringLiteral("vehicle")).isEmpty());
    const auto received = [&monitor](const char *counter) {
        const QJsonObject stats = monitor.waitFor(QStringLiteral("stats"));
        return number(stats[QLatin1String("channel")][QLatin1String("rx")].toObject(), counter);
    };
    for (int cut = 1; cut <= 3; ++cut) {
        cable.cut();
        EVENTUALLY_EQUAL(cable.joined, cut + 1);
        monitor.skipReceivedEvents();
        const qint64 before = received("good");
        EVENTUALLY(received("good") > before + 20);
    }
    // The same session all the time, resumed by its first report.
    QCOMPARE(monitor.events(QStringLiteral("session")).size(), std::size_t(1));
    QCOMPARE(received("forged"), 0);
}

void HostileCarriersTest::idleConnectionsDoNotBlock()
{
    // More idle connections than the agent accepts, before a session and during it.
    Flight flight;
    QVERIFY(flight.ready());
    const quint16 port = freeTcpPort();
    Program monitor(QStringLiteral("skyseal-cli"), with(flight.monitorArguments(), "--link", loopback("tcpin", port)));
    QVERIFY(monitor.waitUntilListening(QStringLiteral("tcpin")));
    std::vector<std::unique_ptr<QTcpSocket>> idle;
    int connected = 0; // excluding those closed before they were reported as connected
    const auto connectIdle = [&](int count) {
        for (int i = 0; i < count; ++i) {
            idle.push_back(std::make_unique<QTcpSocket>());
            idle.back()->connectToHost(QHostAddress(QHostAddress::LocalHost), port);
            connected += idle.back()->waitForConnected(kDeadlineMs);
        }
    };
    connectIdle(40);
    QVERIFY2(connected >= 32, qPrintable(QString::number(connected)));
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    Program agent(QStringLiteral("skyseal-air"), with(flight.airArguments(), "--ground", loopback("tcp", port)));
    QVERIFY(!monitor.waitFor(QStringLiteral("session")).isEmpty());
    connectIdle(80);
    const auto good = [&monitor] {
        return number(monitor.waitFor(QStringLiteral("stats"))[QLatin1String("channel")][QLatin1String("rx")].toObject(),
                      "good");
    };
    monitor.skipReceivedEvents();
    const qint64 before = good();
    EVENTUALLY(good() > before + 100);
    QCOMPARE(monitor.events(QStringLiteral("session")).size(), std::size_t(1));
}

void HostileCarriersTest::routersSeeNoTelemetry()
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
    Program agent(QStringLiteral("skyseal-air"),
                  with(flight.airArguments(), "--ground", loopback("udpout", hub.port(0)))
                      + QStringList{QStringLiteral("--carrier"), QStringLiteral("tunnel")});
    Program monitor(QStringLiteral("skyseal-cli"), flight.monitorArguments());
    QVERIFY(!monitor.waitFor(QStringLiteral("vehicle")).isEmpty());
    for (int second = 0; second < 3; ++second)
        QVERIFY(!monitor.waitFor(QStringLiteral("stats")).isEmpty());
    QCOMPARE(speakers, (std::set<std::pair<int, int>>{{1, 191}, {255, 190}}));
    QVERIFY(!telemetryInClear);
    // The clear heartbeat, which routers need, does not count as refused telemetry.
    const QJsonObject channel = monitor.last(QStringLiteral("stats"))[QLatin1String("channel")].toObject();
    QCOMPARE(number(channel[QLatin1String("rx")].toObject(), "plaintext_dropped"), 0);
}

/// Spoofed armed heartbeats under all three system ids, from before the session until after it: the session comes up and stays
/// up.
void HostileCarriersTest::spoofersAtTheHub()
{
    MavlinkHub hub(5);
    Flight flight;
    hub.setRemote(1, flight.groundPort);
    RouterSpoofers<QUdpSocket> spoofers([&hub](std::size_t i, QUdpSocket &socket) {
        socket.connectToHost(QHostAddress(QHostAddress::LocalHost), hub.port(2 + i));
    });
    fly(flight, {loopback("udpout", hub.port(0)), loopback("udpin", flight.groundPort), QStringLiteral("tunnel"), 20, true},
        "tunnel");
    QVERIFY(spoofers.copied > 100 && !spoofers.more); // it receives copies, all sealed
}

void HostileCarriersTest::spoofersAtMavlinkRouter()
{
    SKYSEAL_REQUIRES("mavlink_router");
    const QString program = qEnvironmentVariable("SKYSEAL_MAVLINK_ROUTERD");
    Flight flight;
    const quint16 port = freeUdpPort(), door = freeTcpPort();
    const QString address = QStringLiteral("127.0.0.1:%1");
    Program router(
        program,
        words({"-t"})
            + QStringList{QString::number(door), QStringLiteral("-e"), address.arg(flight.groundPort), address.arg(port)});
    RouterSpoofers<QTcpSocket> spoofers([door](std::size_t, QTcpSocket &socket) {
        const auto connected = [&] {
            if (socket.state() == QAbstractSocket::ConnectedState)
                return true;
            socket.abort();
            socket.connectToHost(QHostAddress(QHostAddress::LocalHost), door);
            return socket.waitForConnected(1000);
        };
        EVENTUALLY(connected());
    });
    fly(flight, {loopback("udpout", port), loopback("udpin", flight.groundPort), QStringLiteral("tunnel"), 20, true}, "tunnel");
    QVERIFY2(router.running(), router.errors());
    QVERIFY(spoofers.copied > 100 && !spoofers.more);
}

SKYSEAL_TEST(HostileCarriersTest)
#include "hostile_carriers_test.moc"
