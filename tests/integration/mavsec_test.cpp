// --framing mavsec2019: decode and monitor show frames that the openssl program encrypted, and the monitor never sends a byte
// to their source. The simulator encrypts as that code does, and the monitor counts and shows all that it sends.
#include "core/base/hex.h"
#include "core/mavlink/crc.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/frame_intake.h"
#include "core/mavlink/messages.h"
#include "tests/support/eventually.h"
#include "tests/support/program.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QProcess>
#include <QtCore/QTemporaryDir>
#include <QtCore/QTimer>
#include <QtNetwork/QTcpServer>
#include <QtNetwork/QTcpSocket>
#include <QtNetwork/QUdpSocket>
#include <QtTest/QTest>

#include <set>

using namespace skyseal;
using namespace skyseal::test;

namespace {

const char kHeartbeat[] = "fd090000070101000000040000000203510403381c";
const char kAttitude[] = "fd1c00000801011e000040e201000000803e000000be0000c03f0ad7233c0ad7a33c8fc2f53c8fc3";
const char kOldHeartbeat[] = "fe090901010004000000020351040368fc";

const QString kKey = QStringLiteral("a0a1a2a3a4a5a6a7a8a9aaabacadaeafb0b1b2b3b4b5b6b7b8b9babbbcbdbebf");

QByteArray bytesOf(const char *hex)
{
    return QByteArray::fromHex(hex);
}

/// The frame with its payload encrypted by the openssl program, and the checksum over the result.
QByteArray encrypted(const QByteArray &frame, const QString &cipher, const QString &iv)
{
    const int header = static_cast<std::uint8_t>(frame[0]) == 0xfd ? 10 : 6;
    const int length = static_cast<std::uint8_t>(frame[1]);
    QProcess openssl;
    openssl.start(QStringLiteral("openssl"),
                  {QStringLiteral("enc"), QStringLiteral("-") + cipher, QStringLiteral("-K"), kKey, QStringLiteral("-iv"), iv});
    openssl.write(frame.mid(header, length));
    openssl.closeWriteChannel();
    openssl.waitForFinished(kDeadlineMs);
    const QByteArray payload = openssl.readAllStandardOutput();
    if (payload.size() != length)
        return {};
    QByteArray out = frame;
    out.replace(header, length, payload);
    const ByteView covered(reinterpret_cast<const std::uint8_t *>(out.constData()) + 1,
                           static_cast<std::size_t>(header - 1 + length));
    const std::uint8_t extra = frame.mid(header == 10 ? 7 : 5, 1)[0] == 30 ? 39 : 50; // ATTITUDE, HEARTBEAT
    const std::uint16_t crc = mavlink::crcAccumulate(mavlink::crcAccumulate(mavlink::kCrcStart, covered), {&extra, 1});
    out[header + length] = static_cast<char>(crc);
    out[header + length + 1] = static_cast<char>(crc >> 8);
    return out;
}

QList<QJsonObject> messages(Program &decode)
{
    QList<QJsonObject> out;
    if (decode.waitForExit() != 0)
        return out;
    for (const QJsonObject &event : decode.events())
        out.append(event);
    return out;
}

struct Setting
{
    QString cipher, opensslIv, nonce, counter;
};

/// ChaCha20 of openssl expects the block number before the nonce, little-endian.
const Setting kSettings[] = {
    {QStringLiteral("chacha20"), QStringLiteral("05000000000102030405060708090a0b"), QStringLiteral("000102030405060708090a0b"),
     QStringLiteral("5")},
    {QStringLiteral("aes-256-ctr"),
     QStringLiteral("00112233445566778899aabbffffffff"),
     QStringLiteral("00112233445566778899aabbffffffff"),
     {}},
};

} // namespace

class MavsecTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void decodeShowsThePlaintext_data();
    void decodeShowsThePlaintext();
    void keyFilesAreForTheirOwner();
    void monitorReadsAndNeverSends_data();
    void monitorReadsAndNeverSends();
    void neverSendsOverTcp();
    void simulatorIsReadFrameByFrame_data();
    void simulatorIsReadFrameByFrame();
    void simulatorChangesItsCipher();
    void simulatorChecksItsOptions_data();
    void simulatorChecksItsOptions();

private:
    QString writeFile(const char *name, const QByteArray &content);
    QTemporaryDir m_folder;
};

void MavsecTest::initTestCase()
{
    SKYSEAL_REQUIRES("openssl");
}

QString MavsecTest::writeFile(const char *name, const QByteArray &content)
{
    QFile file(m_folder.filePath(QLatin1String(name)));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
        return {};
    file.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
    return file.fileName();
}

void MavsecTest::decodeShowsThePlaintext_data()
{
    QTest::addColumn<int>("setting");
    QTest::newRow("chacha20") << 0;
    QTest::newRow("aes-256-ctr") << 1;
}

void MavsecTest::decodeShowsThePlaintext()
{
    QFETCH(int, setting);
    const Setting &how = kSettings[setting];
    QByteArray plain, hidden;
    for (const char *hex : {kHeartbeat, kAttitude, kOldHeartbeat}) {
        plain += bytesOf(hex);
        const QByteArray one = encrypted(bytesOf(hex), how.cipher, how.opensslIv);
        QVERIFY(!one.isEmpty() && one != bytesOf(hex));
        hidden += one;
    }
    QStringList arguments{QStringLiteral("decode"),
                          writeFile("hidden.bin", hidden),
                          QStringLiteral("--json"),
                          QStringLiteral("--framing"),
                          QStringLiteral("mavsec2019"),
                          QStringLiteral("--cipher"),
                          how.cipher,
                          QStringLiteral("--key"),
                          kKey,
                          QStringLiteral("--nonce"),
                          how.nonce};
    if (!how.counter.isEmpty())
        arguments << QStringLiteral("--counter") << how.counter;
    Program inOption(QStringLiteral("skyseal-cli"), arguments);
    Program unprotected(QStringLiteral("skyseal-cli"),
                        {QStringLiteral("decode"), writeFile("plain.bin", plain), QStringLiteral("--json")});
    const QList<QJsonObject> expected = messages(unprotected);
    QCOMPARE(expected.size(), 3);
    QCOMPARE(messages(inOption), expected);

    const qsizetype at = arguments.indexOf(QStringLiteral("--key"));
    arguments[at] = QStringLiteral("--key-file");
    arguments[at + 1] = writeFile("key.hex", kKey.toLatin1() + '\n');
    Program inFile(QStringLiteral("skyseal-cli"), arguments);
    QCOMPARE(messages(inFile), expected);

    Program asPlain(QStringLiteral("skyseal-cli"),
                    {QStringLiteral("decode"), m_folder.filePath(QStringLiteral("hidden.bin")), QStringLiteral("--json")});
    QVERIFY(messages(asPlain) != expected);
}

void MavsecTest::keyFilesAreForTheirOwner()
{
    const QString key = writeFile("open.hex", kKey.toLatin1());
    QVERIFY(QFile::setPermissions(key, QFile::ReadOwner | QFile::WriteOwner | QFile::ReadOther));
    Program decode(QStringLiteral("skyseal-cli"),
                   {QStringLiteral("decode"), writeFile("nothing.bin", {}), QStringLiteral("--framing"),
                    QStringLiteral("mavsec2019"), QStringLiteral("--key-file"), key});
    QCOMPARE(decode.waitForExit(), 3);
    QVERIFY2(decode.errors().contains("open.hex"), decode.errors().constData());
    QVERIFY(!decode.errors().contains(kKey.toLatin1()));
}

void MavsecTest::monitorReadsAndNeverSends_data()
{
    decodeShowsThePlaintext_data();
}

void MavsecTest::monitorReadsAndNeverSends()
{
    QFETCH(int, setting);
    const Setting &how = kSettings[setting];
    const QByteArray heartbeat = encrypted(bytesOf(kHeartbeat), how.cipher, how.opensslIv);
    const QByteArray attitude = encrypted(bytesOf(kAttitude), how.cipher, how.opensslIv);
    QVERIFY(!heartbeat.isEmpty());
    const quint16 port = freeUdpPort();
    QStringList arguments{QStringLiteral("monitor"),
                          QStringLiteral("--link"),
                          QStringLiteral("udpin:127.0.0.1:%1").arg(port),
                          QStringLiteral("--framing"),
                          QStringLiteral("mavsec2019"),
                          QStringLiteral("--cipher"),
                          how.cipher,
                          QStringLiteral("--key-file"),
                          writeFile("key.hex", kKey.toLatin1()),
                          QStringLiteral("--nonce"),
                          how.nonce,
                          QStringLiteral("--json"),
                          QStringLiteral("--no-record")};
    if (!how.counter.isEmpty())
        arguments << QStringLiteral("--counter") << how.counter;
    Program monitor(QStringLiteral("skyseal-cli"), arguments);
    QVERIFY2(!monitor.waitFor(QStringLiteral("link")).isEmpty(), monitor.errors().constData());

    QUdpSocket vehicle;
    QVERIFY(vehicle.bind(QHostAddress::LocalHost, 0));
    QTimer pace;
    connect(&pace, &QTimer::timeout, this, [&] {
        vehicle.writeDatagram(heartbeat, QHostAddress::LocalHost, port);
        vehicle.writeDatagram(attitude, QHostAddress::LocalHost, port);
    });
    pace.start(100);
    const auto turned = [&] {
        for (const QJsonObject &stats : monitor.events(QStringLiteral("stats"))) {
            const QJsonArray vehicles = stats[QLatin1String("vehicles")].toArray();
            if (!vehicles.isEmpty() && vehicles[0][QLatin1String("roll")].toDouble() == 0.25)
                return true;
        }
        return false;
    };
    EVENTUALLY(turned());
    QCOMPARE(monitor.events(QStringLiteral("vehicle")).front()[QLatin1String("type")].toInt(), 2);
    QVERIFY(monitor.events(QStringLiteral("session")).empty());
    // Longer than the interval of the heartbeats and requests of a station.
    const std::size_t seconds = monitor.events(QStringLiteral("stats")).size();
    EVENTUALLY(monitor.events(QStringLiteral("stats")).size() >= seconds + 4);
    QCOMPARE(monitor.terminate(), 0);
    QVERIFY(!vehicle.hasPendingDatagrams());
    QVERIFY(monitor.errors().contains("INSECURE"));
}

void MavsecTest::neverSendsOverTcp()
{
    QTcpServer autopilot;
    QVERIFY(autopilot.listen(QHostAddress::LocalHost));
    Program monitor(QStringLiteral("skyseal-cli"),
                    {QStringLiteral("monitor"), QStringLiteral("--link"),
                     QStringLiteral("tcp:127.0.0.1:%1").arg(autopilot.serverPort()), QStringLiteral("--framing"),
                     QStringLiteral("mavsec2019"), QStringLiteral("--json"), QStringLiteral("--no-record")});
    EVENTUALLY(autopilot.hasPendingConnections());
    QTcpSocket *link = autopilot.nextPendingConnection();
    QTimer pace;
    connect(&pace, &QTimer::timeout, this, [&] { // as the published ChaCha20 makes it
        link->write(QByteArray::fromHex("fd090000070101000000264f51f3421888e52c611b"));
    });
    pace.start(100);
    EVENTUALLY(!monitor.events(QStringLiteral("vehicle")).empty());
    const std::size_t seconds = monitor.events(QStringLiteral("stats")).size();
    EVENTUALLY(monitor.events(QStringLiteral("stats")).size() >= seconds + 4);
    QCOMPARE(monitor.terminate(), 0);
    QCOMPARE(link->bytesAvailable(), 0);
}

void MavsecTest::simulatorIsReadFrameByFrame_data()
{
    decodeShowsThePlaintext_data();
}

/// Each datagram passes this test, which counts its frames.
void MavsecTest::simulatorIsReadFrameByFrame()
{
    QFETCH(int, setting);
    const QString cipher = kSettings[setting].cipher;
    const QStringList secret{QStringLiteral("--framing"),  QStringLiteral("mavsec2019"),
                             QStringLiteral("--cipher"),   cipher,
                             QStringLiteral("--key-file"), writeFile("key.hex", kKey.toLatin1())};
    const quint16 port = freeUdpPort();
    Program monitor(QStringLiteral("skyseal-cli"),
                    QStringList{QStringLiteral("monitor"), QStringLiteral("--link"),
                                QStringLiteral("udpin:127.0.0.1:%1").arg(port), QStringLiteral("--json"),
                                QStringLiteral("--no-record")}
                        + secret);
    QVERIFY2(!monitor.waitFor(QStringLiteral("link")).isEmpty(), monitor.errors().constData());
    QUdpSocket between;
    QVERIFY(between.bind(QHostAddress::LocalHost, 0));
    // PX4 sends telemetry without a request.
    Program sim(QStringLiteral("skyseal-sim"),
                QStringList{QStringLiteral("--link"), QStringLiteral("udpout:127.0.0.1:%1").arg(between.localPort()),
                            QStringLiteral("--autopilot"), QStringLiteral("px4"), QStringLiteral("--json")}
                    + secret);
    qint64 sent = 0;
    bool hasClear = false;
    const auto passOn = [&] {
        while (between.hasPendingDatagrams()) {
            QByteArray datagram(between.pendingDatagramSize(), Qt::Uninitialized);
            between.readDatagram(datagram.data(), datagram.size());
            const ByteView bytes(reinterpret_cast<const std::uint8_t *>(datagram.constData()),
                                 static_cast<std::size_t>(datagram.size()));
            mavlink::scanFrames(bytes, mavlink::Dialect::builtin(), [&](const mavlink::ScanItem &item) {
                sent += item.frame.has_value();
                hasClear = hasClear
                    || (item.frame && item.frame->messageId() == mavlink::Heartbeat::kId
                        && mavlink::Heartbeat::decode(item.frame->payload()).autopilot == mavlink::MAV_AUTOPILOT_PX4);
            });
            between.writeDatagram(datagram, QHostAddress::LocalHost, port);
        }
    };
    connect(&between, &QUdpSocket::readyRead, this, passOn);
    EVENTUALLY(sent >= 200);
    QCOMPARE(sim.terminate(), 0);
    passOn();
    QVERIFY(!hasClear);
    QVERIFY(sim.errors().contains("INSECURE"));
    const auto counted = [&] { return monitor.last(QStringLiteral("stats"))[QLatin1String("mavlink")].toObject(); };
    EVENTUALLY_EQUAL(counted()[QLatin1String("frames")].toInteger(), sent);
    QCOMPARE(counted()[QLatin1String("lost")].toInteger(), 0);
    QCOMPARE(counted()[QLatin1String("bad_crc")].toInteger(), 0);
    const QJsonObject vehicle = monitor.events(QStringLiteral("vehicle")).front();
    QCOMPARE(vehicle[QLatin1String("type")].toInt(), int(mavlink::MAV_TYPE_QUADROTOR));
    QCOMPARE(vehicle[QLatin1String("autopilot")].toInt(), int(mavlink::MAV_AUTOPILOT_PX4));
    QCOMPARE(monitor.terminate(), 0);
}

void MavsecTest::simulatorChangesItsCipher()
{
    QUdpSocket ground;
    QVERIFY(ground.bind(QHostAddress::LocalHost, 0));
    Program sim(QStringLiteral("skyseal-sim"),
                {QStringLiteral("--link"), QStringLiteral("udpout:127.0.0.1:%1").arg(ground.localPort()),
                 QStringLiteral("--framing"), QStringLiteral("mavsec2019"), QStringLiteral("--stdin"),
                 QStringLiteral("--json")});
    std::set<std::uint8_t> types; // of vehicle by the heartbeats so far, as they read in clear
    connect(&ground, &QUdpSocket::readyRead, this, [&] {
        while (ground.hasPendingDatagrams()) {
            QByteArray datagram(ground.pendingDatagramSize(), Qt::Uninitialized);
            ground.readDatagram(datagram.data(), datagram.size());
            const auto frame = mavlink::readFrame(
                {reinterpret_cast<const std::uint8_t *>(datagram.constData()), static_cast<std::size_t>(datagram.size())},
                mavlink::Dialect::builtin());
            if (frame && frame->messageId() == mavlink::Heartbeat::kId)
                types.insert(mavlink::Heartbeat::decode(frame->payload()).type);
        }
    });
    // The published key streams have 0x40 and 0x59 at the place of the type.
    constexpr std::uint8_t kInClear = mavlink::MAV_TYPE_QUADROTOR, kByChaCha = kInClear ^ 0x40, kByAes = kInClear ^ 0x59;
    EVENTUALLY(types == std::set{kInClear});
    const std::pair<const char *, std::uint8_t> kSteps[] = {
        {"chacha20", kByChaCha}, {"aes-256-ctr", kByAes}, {"plain", kInClear}, {"chacha20", kByChaCha}};
    for (const auto &[cipher, type] : kSteps) {
        sim.notify(QLatin1String(cipher));
        const QJsonObject event = sim.waitFor(QStringLiteral("framing"));
        QCOMPARE(event[QLatin1String("encrypted")].toBool(), type != kInClear);
        QCOMPARE(event[QLatin1String("cipher")].toString(), type == kInClear ? QString() : QLatin1String(cipher));
        EVENTUALLY(types.contains(type));
        types.clear(); // what comes from now on was sent after the change
        EVENTUALLY(types == std::set{type});
    }
    sim.notify(QStringLiteral("rot13"));
    EVENTUALLY(sim.errors().contains("plain, chacha20 or aes-256-ctr"));
    types.clear();
    EVENTUALLY(types == std::set{kByChaCha});
    QCOMPARE(sim.terminate(), 0);
}

void MavsecTest::simulatorChecksItsOptions_data()
{
    QTest::addColumn<QString>("options");
    QTest::addColumn<QByteArray>("words");
    QTest::addColumn<int>("status");
    const auto row = [](const char *options, const char *words, int status) {
        QTest::newRow(options) << QString::fromLatin1(options) << QByteArray(words) << status;
    };
    row("--framing inline", "plain or mavsec2019", 2);
    row("--cipher chacha20", "only with --framing mavsec2019", 2);
    row("--stdin", "only with --framing mavsec2019", 2);
    row("--framing mavsec2019 --stdin --nonce 00", "--nonce", 2);
    row("--framing mavsec2019 --cipher rc4", "chacha20 or aes-256-ctr", 2);
    row("--framing mavsec2019 --key-file /nonexistent", "/nonexistent", 3);
}

void MavsecTest::simulatorChecksItsOptions()
{
    QFETCH(QString, options);
    QFETCH(QByteArray, words);
    QFETCH(int, status);
    Program sim(QStringLiteral("skyseal-sim"),
                QStringList{QStringLiteral("--link"), QStringLiteral("udpout:127.0.0.1:9")} + options.split(QLatin1Char(' ')));
    QCOMPARE(sim.waitForExit(), status);
    QVERIFY2(sim.errors().contains(words), sim.errors().constData());
}

SKYSEAL_TEST(MavsecTest)
#include "mavsec_test.moc"
