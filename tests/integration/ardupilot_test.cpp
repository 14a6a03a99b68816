// A real autopilot: an unmodified ArduCopter SITL behind skyseal-air flies by script while the ciphers switch, and the same
// program without an agent shows as not sealed.
//
// ARDUPILOT_SITL names the arducopter program (waf's build/sitl/bin/arducopter, or any prebuilt one); without it the test is
// skipped.
#include "core/mavlink/stream_parser.h"
#include "tests/support/eventually.h"
#include "tests/support/gateway_flight.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QJsonArray>
#include <QtNetwork/QTcpSocket>
#include <QtNetwork/QUdpSocket>
#include <QtTest/QTest>

#include <memory>

using namespace skyseal;
using namespace skyseal::test;

namespace {

/// Parameters that let a simulated vehicle arm: frame class, calibrated sensors, centered sticks.
const char kParameters[] =
    "FRAME_CLASS 1\nFRAME_TYPE 0\nBATT_MONITOR 4\nEK2_ENABLE 1\nFS_THR_ENABLE 1\n"
    "RC1_MAX 2000\nRC1_MIN 1000\nRC1_TRIM 1500\nRC2_MAX 2000\nRC2_MIN 1000\nRC2_TRIM 1500\n"
    "RC3_MAX 2000\nRC3_MIN 1000\nRC3_TRIM 1500\nRC4_MAX 2000\nRC4_MIN 1000\nRC4_TRIM 1500\n"
    "COMPASS_OFS_X 5\nCOMPASS_OFS_Y 13\nCOMPASS_OFS_Z -18\nCOMPASS_OFS2_X 5\nCOMPASS_OFS2_Y 13\nCOMPASS_OFS2_Z -18\n"
    "COMPASS_OFS3_X 5\nCOMPASS_OFS3_Y 13\nCOMPASS_OFS3_Z -18\n"
    "INS_ACCOFFS_X 0.001\nINS_ACCOFFS_Y 0.001\nINS_ACCOFFS_Z 0.001\nINS_ACCSCAL_X 1.001\nINS_ACCSCAL_Y 1.001\n"
    "INS_ACCSCAL_Z 1.001\nINS_ACC2OFFS_X 0.001\nINS_ACC2OFFS_Y 0.001\nINS_ACC2OFFS_Z 0.001\nINS_ACC2SCAL_X 1.001\n"
    "INS_ACC2SCAL_Y 1.001\nINS_ACC2SCAL_Z 1.001\n";

} // namespace

class ArduPilotTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void fliesSealedWhileCiphersSwitch();
    void anotherStationFliesThroughTheGateway();
    void plainOnUdpIsShownAsNotSealed();

private:
    std::unique_ptr<Program> startSitl(quint16 port) const;

    QTemporaryDir m_folder; // its eeprom and logs go to the working directory
    QString m_sitl;
};

void ArduPilotTest::initTestCase()
{
    m_sitl = qEnvironmentVariable("ARDUPILOT_SITL");
    if (m_sitl.isEmpty())
        QSKIP("ARDUPILOT_SITL names no ArduCopter SITL: the flight with a real autopilot is skipped");
    QVERIFY2(QFile::exists(m_sitl), qPrintable(m_sitl));
    QVERIFY(QDir::setCurrent(m_folder.path()));
    QFile parameters(m_folder.filePath(QStringLiteral("copter.parm")));
    QVERIFY(parameters.open(QIODevice::WriteOnly));
    parameters.write(kParameters);
}

std::unique_ptr<Program> ArduPilotTest::startSitl(quint16 port) const
{
    return std::make_unique<Program>(m_sitl,
                                     QStringList{QStringLiteral("--wipe"), QStringLiteral("--synthetic-clock"),
                                                 QStringLiteral("--disable-fgview"), QStringLiteral("--home"),
                                                 QStringLiteral("-35.363261,149.165230,584,353"), QStringLiteral("--model"),
                                                 QStringLiteral("+"), QStringLiteral("--speedup"), QStringLiteral("2"),
                                                 QStringLiteral("--defaults"), m_folder.filePath(QStringLiteral("copter.parm")),
                                                 QStringLiteral("--base-port"), QString::number(port), QStringLiteral("-I0")});
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
