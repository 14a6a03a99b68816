// MAVLink signing on the vehicle's side with the real programs: set up, checked, flown with, and removed, while a device
// without the key talks to the vehicle on another link.
#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"
#include "tests/support/clear_frames.h"
#include "tests/support/flight.h"
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QJsonDocument>
#include <QtNetwork/QNetworkDatagram>
#include <QtNetwork/QUdpSocket>

using namespace skyseal;
using namespace skyseal::test;

namespace {

/// Speaks plain MAVLink with the vehicle, and hears its heartbeats.
class Stranger
{
public:
    explicit Stranger(quint16 vehiclePort) : m_vehiclePort(vehiclePort)
    {
        m_socket.bind(QHostAddress::LocalHost, 0);
        QObject::connect(&m_socket, &QUdpSocket::readyRead, &m_socket, [this] { readWaiting(); });
    }
    /// What has arrived while another program was waited for.
    void readWaiting()
    {
        while (m_socket.hasPendingDatagrams())
            take(m_socket.receiveDatagram().data());
    }
    /// Greets until the vehicle answers: a program that has just been started may not listen yet. False: it never answered.
    bool findsVehicle()
    {
        return eventually([this] {
            greet();
            readWaiting();
            return heartbeats > 0;
        });
    }
    void arm(bool on)
    {
        const mavlink::CommandLong command{.target_system = 1,
                                           .target_component = 1,
                                           .command = mavlink::MAV_CMD_COMPONENT_ARM_DISARM,
                                           .param1 = on ? 1.f : 0.f,
                                           .param2 = 21196};
        m_socket.writeDatagram(frameOf(command, 255), QHostAddress::LocalHost, m_vehiclePort);
    }

    bool armed = false; ///< by the newest heartbeat
    int heartbeats = 0;

private:
    void greet()
    {
        const mavlink::Heartbeat own{.type = mavlink::MAV_TYPE_GCS, .autopilot = mavlink::MAV_AUTOPILOT_INVALID};
        m_socket.writeDatagram(frameOf(own, 255), QHostAddress::LocalHost, m_vehiclePort);
    }
    void take(const QByteArray &datagram)
    {
        mavlink::FrameScanner scanner(viewOf(datagram), mavlink::Dialect::builtin());
        while (const auto item = scanner.next()) {
            if (!item->frame || item->frame->messageId() != mavlink::Heartbeat::kId)
                continue;
            ++heartbeats;
            // So that it is not forgotten; and once signing is off, it is the station without which the failsafe disarms.
            greet();
            armed = mavlink::Heartbeat::decode(item->frame->payload()).base_mode & mavlink::MAV_MODE_FLAG_SAFETY_ARMED;
        }
    }

    QUdpSocket m_socket;
    quint16 m_vehiclePort;
};

/// The key of the file, as it could be written down.
QByteArrayList spellings(const QString &keyFile)
{
    QFile file(keyFile);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QByteArray hex = file.readAll().trimmed(), raw = QByteArray::fromHex(hex);
    return {hex, hex.toUpper(), raw, raw.toBase64().left(42), raw.toBase64(QByteArray::Base64UrlEncoding).left(42)};
}

} // namespace

class SigningProgramsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void wholeFlight();
    void keyIsNotSentOverANetwork();
    void contradictionsAreUsageErrors_data();
    void contradictionsAreUsageErrors();
};

void SigningProgramsTest::wholeFlight()
{
    Flight flight;
    QVERIFY(flight.ready());
    const QString keyFile = flight.path(QStringLiteral("vehicle.signing"));
    const QStringList withKey{QStringLiteral("--vehicle-signing"), keyFile};
    const quint16 otherPort = freeUdpPort();
    Program sim(QStringLiteral("skyseal-sim"),
                flight.simArguments({QStringLiteral("--link"), QStringLiteral("udpin:127.0.0.1:%1").arg(otherPort)}));
    QByteArray said;
    const auto signing = [&](const char *action, const QStringList &more = {}) {
        RunResult result = runProgram("skyseal-air",
                                      QStringList{QStringLiteral("--vehicle"),
                                                  QStringLiteral("udpin:127.0.0.1:%1").arg(flight.vehiclePort),
                                                  QStringLiteral("--signing"), QLatin1String(action)}
                                          + withKey + more);
        said += result.out + result.err;
        return result;
    };
    QCOMPARE(signing("check").status, 3); // no key yet
    Stranger stranger(otherPort);
    const auto isArmedFor = [&stranger](bool on) { // what the vehicle does with a plain command
        stranger.readWaiting();
        stranger.arm(on);
        const int before = stranger.heartbeats;
        return eventually([&] { return stranger.heartbeats >= before + 3 || stranger.armed == on; }) && stranger.armed == on;
    };
    QVERIFY(stranger.findsVehicle());
    QVERIFY(isArmedFor(true));
    QVERIFY(isArmedFor(false));

    const RunResult setUp = signing("setup");
    QVERIFY2(setUp.status == 0, (setUp.out + setUp.err).constData());
    QCOMPARE(setUp.out, QByteArray("vehicle 1 signs with this key and accepts messages that are signed with it\n"));
    const RunResult check = signing("check", {QStringLiteral("--json")});
    QCOMPARE(check.status, 0);
    QCOMPARE(QJsonDocument::fromJson(check.out).object()[QLatin1String("result")].toString(), QStringLiteral("works"));
    QVERIFY(!isArmedFor(true));
    {
        Program air(QStringLiteral("skyseal-air"), flight.airArguments(0, withKey));
        // With the usual failsafe the vehicle disarms 5 s after the monitor has ended, while the stranger is watched.
        Program monitor(QStringLiteral("skyseal-cli"),
                        flight.monitorArguments({QStringLiteral("--do"),
                                                 QStringLiteral("param FS_GCS_TIMEOUT 120; mode GUIDED; "
                                                                "arm; wait armed==1 30")}));
        QVERIFY(!air.waitFor(QStringLiteral("vehicle_signing"),
                             [](const QJsonObject &event) {
                                 return event[QLatin1String("state")].toString() == QLatin1String("verified");
                             })
                     .isEmpty());
        QCOMPARE(monitor.waitForExit(), 0);
        EVENTUALLY(stranger.armed);
        QVERIFY(!isArmedFor(false));
        Program again(QStringLiteral("skyseal-cli"),
                      flight.monitorArguments({QStringLiteral("--do"), QStringLiteral("disarm; wait armed==0 30")}));
        QCOMPARE(again.waitForExit(), 0);
        QCOMPARE(air.terminate(), 0);
        const QJsonObject counters = air.last(QStringLiteral("summary"))[QLatin1String("signing")].toObject();
        QVERIFY(counters[QLatin1String("signed")].toInt() > 2);
        QVERIFY(counters[QLatin1String("verified")].toInt() > 20);
        QCOMPARE(counters[QLatin1String("wrong_key")].toInt(-1) + counters[QLatin1String("old")].toInt(-1), 0);
        for (Program *program : {&air, &monitor}) {
            said += program->errors() + program->otherLines().join('\n');
            for (const QJsonObject &event : program->events())
                said += QJsonDocument(event).toJson(QJsonDocument::Compact) + '\n';
        }
    }
    EVENTUALLY(!stranger.armed);
    const RunResult removed = signing("remove");
    QVERIFY2(removed.status == 0, (removed.out + removed.err).constData());
    QCOMPARE(signing("check").status, 1);
    QVERIFY(isArmedFor(true));

    const QByteArrayList key = spellings(keyFile);
    QCOMPARE(key.size(), qsizetype(5));
    QCOMPARE(key[0].size(), qsizetype(64));
    for (const QByteArray &spelling : key)
        QVERIFY(!said.contains(spelling));
    QVERIFY(said.contains("created, a new signing key") && said.contains("\"event\":\"vehicle_signing\""));
    QFile time(keyFile + QStringLiteral(".time"));
    QVERIFY(time.open(QIODevice::ReadOnly) && time.readAll().startsWith("skyseal-signing-time-v1\n"));
}

void SigningProgramsTest::keyIsNotSentOverANetwork()
{
    Flight flight;
    QVERIFY(flight.ready());
    const QString keyFile = flight.path(QStringLiteral("vehicle.signing"));
    for (const char *url : {"udpin:0.0.0.0:%1", "udpout:192.0.2.1:%1", "tcp:autopilot.invalid:%1"}) {
        const RunResult result = runProgram("skyseal-air",
                                            {QStringLiteral("--vehicle"), QString(QLatin1String(url)).arg(flight.vehiclePort),
                                             QStringLiteral("--signing"), QStringLiteral("setup"),
                                             QStringLiteral("--vehicle-signing"), keyFile});
        QCOMPARE(result.status, 2);
        QVERIFY2(result.err.contains("would send the key in clear over "), result.err.constData());
        QVERIFY(!QFile::exists(keyFile));
    }
}

void SigningProgramsTest::contradictionsAreUsageErrors_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QByteArray>("said");
    const QString file = QStringLiteral("/nonexistent/key");
    QTest::newRow("unknown action") << QStringList{QStringLiteral("--signing"), QStringLiteral("start"),
                                                   QStringLiteral("--vehicle-signing"), file}
                                    << QByteArray("setup, check or remove is expected");
    QTest::newRow("no key file") << QStringList{QStringLiteral("--signing"), QStringLiteral("check")}
                                 << QByteArray("--vehicle-signing");
    QTest::newRow("unsigned without a key")
        << QStringList{QStringLiteral("--accept-unsigned")} << QByteArray("--accept-unsigned requires --vehicle-signing");
    QTest::newRow("plain with a key") << QStringList{QStringLiteral("--allow-plain"), QStringLiteral("--vehicle-signing"), file}
                                      << QByteArray("--allow-plain: not with --vehicle-signing");
    QTest::newRow("key in clear") << QStringList{QStringLiteral("--send-key-in-clear")}
                                  << QByteArray("--send-key-in-clear requires --signing setup");
}

void SigningProgramsTest::contradictionsAreUsageErrors()
{
    QFETCH(QStringList, options);
    QFETCH(QByteArray, said);
    Flight flight;
    QVERIFY(flight.ready());
    const RunResult result = runProgram("skyseal-air", flight.airArguments(0, options));
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains(said), result.err.constData());
}

SKYSEAL_TEST(SigningProgramsTest)
#include "signing_programs_test.moc"
