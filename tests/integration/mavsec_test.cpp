// --framing mavsec2019: decode and monitor show frames that the openssl program encrypted, and the monitor never sends a byte
// to their source.
#include "core/base/hex.h"
#include "core/mavlink/crc.h"
#include "core/mavlink/frame_scanner.h"
#include "tests/support/eventually.h"
#include "tests/support/program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QProcess>
#include <QtCore/QStandardPaths>
#include <QtCore/QTemporaryDir>
#include <QtCore/QTimer>
#include <QtNetwork/QTcpServer>
#include <QtNetwork/QTcpSocket>
#include <QtNetwork/QUdpSocket>
#include <QtTest/QTest>

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
    openssl.waitForFinished();
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

private:
    QString writeFile(const char *name, const QByteArray &content);
    QTemporaryDir m_folder;
};

void MavsecTest::initTestCase()
{
    if (QStandardPaths::findExecutable(QStringLiteral("openssl")).isEmpty())
        QSKIP("the openssl program is not installed: frames of another implementation are not checked");
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

SKYSEAL_TEST(MavsecTest)
#include "mavsec_test.moc"
