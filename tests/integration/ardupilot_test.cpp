// A real autopilot: an unmodified ArduCopter SITL behind skyseal-air flies by script while the ciphers switch, and the same
// program without an agent shows as not sealed.
// Without ARDUPILOT_SITL (see Sitl) the test is skipped.
#include "core/mavlink/stream_parser.h"
#include "tests/support/eventually.h"
#include "tests/support/gateway_flight.h"
#include "tests/support/sitl.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QJsonArray>
#include <QtNetwork/QTcpSocket>
#include <QtNetwork/QUdpSocket>
#include <QtTest/QTest>

#include <memory>

using namespace skyseal;
using namespace skyseal::test;

class ArduPilotTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void fliesSealedWhileCiphersSwitch();
    void anotherStationFliesThroughTheGateway();
    void plainOnUdpIsShownAsNotSealed();

private:
    std::unique_ptr<Program> startSitl(quint16 port) const { return m_sitl.start(port, 2); }

    Sitl m_sitl;
};

void ArduPilotTest::initTestCase()
{
    SKYSEAL_REQUIRES("arducopter");
    QVERIFY2(QFile::exists(m_sitl.program()), qPrintable(m_sitl.program()));
}

void ArduPilotTest::fliesSealedWhileCiphersSwitch()
{
    Flight flight;
    QVERIFY(flight.ready());
    const quint16 port = freeTcpPort();
    const auto sitl = startSitl(port);
    Program monitor(
        QStringLiteral("skyseal-cli"),
        flight.monitorArguments({QStringLiteral("--switch-to"), allSuites(), QStringLiteral("--switch-every"),
                                 QStringLiteral("2"), QStringLiteral("--do"),
                                 QStringLiteral("wait gps_fix>=3 90; wait ekf_ok==1 90; mode GUIDED; arm; takeoff 10; "
                                                "wait alt_rel>=9.5 90; land; wait armed==0 120")}));
    QStringList arguments = flight.airArguments();
    arguments[arguments.indexOf(QStringLiteral("--vehicle")) + 1] = QStringLiteral("tcp:127.0.0.1:%1").arg(port);
    Program air(QStringLiteral("skyseal-air"), arguments);

    QCOMPARE(monitor.waitForExit(6 * kDeadlineMs), 0);
    QCOMPARE(monitor.events(QStringLiteral("vehicle")).front()[QLatin1String("autopilot")].toInt(), 3);
    for (const QJsonObject &step : monitor.events(QStringLiteral("command")))
        QVERIFY(step[QLatin1String("result")] == QLatin1String("accepted")
                || step[QLatin1String("result")] == QLatin1String("reached"));
    int committed = 0;
    for (const QJsonObject &change : monitor.events(QStringLiteral("switch")))
        committed += change[QLatin1String("result")] == QLatin1String("committed");
    QVERIFY(committed >= 6);
    const QJsonObject received =
        monitor.last(QStringLiteral("summary"))[QLatin1String("channel")][QLatin1String("rx")].toObject();
    qInfo("%d switches; of the records of the vehicle %d good, %d lost", committed, received[QLatin1String("good")].toInt(),
          received[QLatin1String("lost")].toInt());
    QVERIFY(received[QLatin1String("good")].toInt() > 500);
    QCOMPARE(received[QLatin1String("lost")].toInt(), 0);
    QCOMPARE(received[QLatin1String("forged")].toInt(), 0);
}

void ArduPilotTest::anotherStationFliesThroughTheGateway()
{
    const quint16 port = freeTcpPort(), stationPort = freeUdpPort();
    const auto sitl = startSitl(port);
    GatewayFlight flight({QStringLiteral("udpout:127.0.0.1:%1,write=command").arg(stationPort)});
    flight.startAgent(QStringLiteral("tcp:127.0.0.1:%1").arg(port));
    QVERIFY2(flight.waitForSession(), flight.gateway->errors().constData());
    const auto station = plainStation(stationPort,
                                      {QStringLiteral("--do"),
                                       QStringLiteral("wait gps_fix>=3 90; wait ekf_ok==1 90; mode GUIDED; arm; takeoff 10; "
                                                      "wait alt_rel>=9.5 90; land; wait armed==0 120")});
    const int switched = switchWhileFlying(flight, *station, 2);
    QVERIFY2(station->waitForExit() == 0, station->errors().constData());
    QVERIFY(switched > 8);
    const QJsonObject mavlink = station->last(QStringLiteral("summary"))[QLatin1String("mavlink")].toObject();
    qInfo("%d switches; %d frames, %d lost", switched, mavlink[QLatin1String("frames")].toInt(),
          mavlink[QLatin1String("lost")].toInt(-1));
    QVERIFY(mavlink[QLatin1String("frames")].toInt() > 500);
    QCOMPARE(mavlink[QLatin1String("lost")].toInt(-1), 0);
    QCOMPARE(mavlink[QLatin1String("duplicate")].toInt(-1), 0);
}

void ArduPilotTest::plainOnUdpIsShownAsNotSealed()
{
    const quint16 tcpPort = freeTcpPort();
    const auto sitl = startSitl(tcpPort);
    const quint16 udpPort = freeUdpPort();
    Program monitor(QStringLiteral("skyseal-cli"),
                    {QStringLiteral("monitor"), QStringLiteral("--link"), QStringLiteral("udpin:127.0.0.1:%1").arg(udpPort),
                     QStringLiteral("--secure"), QStringLiteral("off"), QStringLiteral("--json")});
    QVERIFY(!monitor.waitFor(QStringLiteral("link")).isEmpty());

    // This SITL supports TCP only: whole frames are forwarded to UDP here, as MAVProxy does for sim_vehicle.py.
    QTcpSocket autopilot;
    EVENTUALLY((autopilot.connectToHost(QStringLiteral("127.0.0.1"), tcpPort), autopilot.waitForConnected(500)));
    QUdpSocket station;
    QVERIFY(station.bind(QHostAddress::LocalHost, 0));
    mavlink::StreamParser parser(mavlink::Dialect::builtin());
    connect(&autopilot, &QTcpSocket::readyRead, this, [&] {
        const QByteArray bytes = autopilot.readAll();
        parser.feed({reinterpret_cast<const std::uint8_t *>(bytes.data()), static_cast<std::size_t>(bytes.size())},
                    [&](const mavlink::ScanItem &item) {
                        if (item.frame)
                            station.writeDatagram(reinterpret_cast<const char *>(item.bytes.data()),
                                                  static_cast<qint64>(item.bytes.size()), QHostAddress::LocalHost, udpPort);
                    });
    });
    connect(&station, &QUdpSocket::readyRead, this, [&] {
        while (station.hasPendingDatagrams()) {
            QByteArray datagram(static_cast<qsizetype>(station.pendingDatagramSize()), 0);
            station.readDatagram(datagram.data(), datagram.size());
            autopilot.write(datagram);
        }
    });
    EVENTUALLY(!monitor.events(QStringLiteral("vehicle")).empty());
    EVENTUALLY(!monitor.events(QStringLiteral("stats")).empty()
               && !monitor.last(QStringLiteral("stats"))[QLatin1String("vehicles")].toArray().isEmpty());
    QVERIFY(monitor.events(QStringLiteral("session")).empty());
}

SKYSEAL_TEST(ArduPilotTest)
#include "ardupilot_test.moc"
