// A flight by script with a simulator on a plain link, and then what became of its recording.
#include "tests/support/run_program.h"
#include "tests/support/eventually.h"
#include "tests/support/free_port.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

using namespace skyseal::test;

namespace {

std::vector<QJsonObject> eventsOf(const QByteArray &output, const char *kind)
{
    std::vector<QJsonObject> out;
    for (const QByteArray &line : output.trimmed().split('\n')) {
        const QJsonObject event = QJsonDocument::fromJson(line).object();
        if (event[QLatin1String("event")].toString() == QLatin1String(kind))
            out.push_back(event);
    }
    return out;
}

} // namespace

class RecordedFlightTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void scriptReportsEachStep();
    void statisticsHaveEveryField();
    void recordingIsSound();
    void recordingDecodes();
    void recordingExports();
    void fullDiskIsReported();
    void recordingReplays();

private:
    QTemporaryDir m_folder;
    QString m_log;
    RunResult m_flight;
};

void RecordedFlightTest::initTestCase()
{
    const QString port = QString::number(freeUdpPort());
    QProcess sim;
    sim.start(
        QStringLiteral(SKYSEAL_BIN_DIR "/skyseal-sim"),
        {QStringLiteral("--link"), QStringLiteral("udpout:127.0.0.1:") + port, QStringLiteral("--rate"), QStringLiteral("5")});
    QVERIFY(sim.waitForStarted(kDeadlineMs));
    m_flight = runProgram(
        "skyseal-cli",
        {QStringLiteral("monitor"), QStringLiteral("--link"), QStringLiteral("udpin:127.0.0.1:") + port,
         QStringLiteral("--secure"), QStringLiteral("off"), QStringLiteral("--json"), QStringLiteral("--record"),
         m_folder.path(), QStringLiteral("--do"),
         QStringLiteral("wait gps_fix>=3 60; mode GUIDED; arm; takeoff 5; wait alt_rel>=4.5 60; land; wait armed==0 90")},
        {}, 180000);
    sim.kill();
    sim.waitForFinished(kDeadlineMs);
    QVERIFY2(m_flight.status == 0, m_flight.err + m_flight.out.right(2000));
    const QStringList logs = QDir(m_folder.path()).entryList({QStringLiteral("*.tlog")}, QDir::Files);
    QCOMPARE(logs.size(), 1);
    m_log = m_folder.filePath(logs[0]);
}

void RecordedFlightTest::scriptReportsEachStep()
{
    const auto steps = eventsOf(m_flight.out, "command");
    QCOMPARE(steps.size(), std::size_t(7));
    for (const QJsonObject &step : steps) {
        const QString result = step[QLatin1String("result")].toString();
        QVERIFY(result == QLatin1String("accepted") || result == QLatin1String("reached"));
        QCOMPARE(step[QLatin1String("sysid")].toInt(), 1);
    }
    QCOMPARE(eventsOf(m_flight.out, "vehicle").size(), std::size_t(1));
    QVERIFY(eventsOf(m_flight.out, "session").empty());
}

void RecordedFlightTest::statisticsHaveEveryField()
{
    const QJsonObject last = eventsOf(m_flight.out, "summary").back();
    for (const char *field : {"frames", "lost", "late", "duplicate", "bad_crc"})
        QVERIFY2(last[QLatin1String("mavlink")].toObject().contains(QLatin1String(field)), field);
    for (const char *field :
         {"suite", "epoch", "rx", "tx", "open_ns_p50", "open_ns_p99", "seal_ns_p50", "seal_ns_p99", "cpu_percent"})
        QVERIFY2(last[QLatin1String("channel")].toObject().contains(QLatin1String(field)), field);
    for (const char *field : {"good", "late", "lost", "replayed", "forged", "malformed", "plaintext_dropped"}) {
        QVERIFY2(last[QLatin1String("channel")][QLatin1String("rx")].toObject().contains(QLatin1String(field)), field);
        QVERIFY2(last[QLatin1String("channel")][QLatin1String("tx")].toObject().contains(QLatin1String(field)), field);
    }
    const QJsonObject vehicle = last[QLatin1String("vehicles")][0].toObject();
    for (const char *field : {"sysid", "mode", "armed", "roll", "pitch", "yaw", "lat", "lon", "alt_rel", "ground_speed",
                              "battery_v", "battery_percent", "gps_fix", "satellites", "ekf_ok", "heartbeat_age"})
        QVERIFY2(vehicle.contains(QLatin1String(field)), field);
    QCOMPARE(last[QLatin1String("channel")][QLatin1String("suite")].toString(), QStringLiteral("none"));
    QCOMPARE(last[QLatin1String("mavlink")][QLatin1String("lost")].toInt(-1), 0);
}

void RecordedFlightTest::recordingIsSound()
{
    const RunResult verified = runProgram("skyseal-cli",
                                          {QStringLiteral("log"), QStringLiteral("verify"), m_log, QStringLiteral("--json")});
    QCOMPARE(verified.status, 0);
    const auto received =
        eventsOf(m_flight.out, "summary").back()[QLatin1String("mavlink")][QLatin1String("frames")].toInteger();
    QVERIFY(QJsonDocument::fromJson(verified.out)[QLatin1String("frames")].toInteger() >= received); // ours are there, too

    QFile file(m_log);
    QVERIFY(file.open(QIODevice::ReadOnly));
    // Of the first frame, behind its time: a time that is a little off is none the less a time.
    QByteArray damaged = file.readAll();
    constexpr qsizetype kFrame = 8, kHeader = 10;
    QCOMPARE(static_cast<quint8>(damaged[kFrame]), quint8(0xfd));
    const qsizetype checksum = kFrame + kHeader + static_cast<quint8>(damaged[kFrame + 1]);
    damaged[checksum] = static_cast<char>(damaged[checksum] ^ 0x55);
    const RunResult refused = runProgram("skyseal-cli", {QStringLiteral("log"), QStringLiteral("verify"), QStringLiteral("-")},
                                         damaged);
    QCOMPARE(refused.status, 1);
    QVERIFY(refused.out.contains("damaged"));
}

void RecordedFlightTest::recordingDecodes()
{
    const RunResult decoded = runProgram("skyseal-cli", {QStringLiteral("decode"), m_log, QStringLiteral("--json")});
    QCOMPARE(decoded.status, 0);
    bool ours = false, theirs = false;
    for (const QJsonObject &message : eventsOf(decoded.out, "message")) {
        ours = ours || message[QLatin1String("sysid")].toInt() == 255;
        theirs = theirs || message[QLatin1String("sysid")].toInt() == 1;
    }
    QVERIFY(ours && theirs);
    QVERIFY(eventsOf(decoded.out, "bad").empty());
}

void RecordedFlightTest::recordingExports()
{
    const QString table = m_folder.filePath(QStringLiteral("flight.csv"));
    QCOMPARE(runProgram("skyseal-cli", {QStringLiteral("log"), QStringLiteral("export"), m_log, QStringLiteral("--out"), table})
                 .status,
             0);
    QFile file(table);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArrayList lines = file.readAll().trimmed().split('\n');
    QVERIFY(lines.size() > 20);
    const QByteArrayList head = lines[0].split(',');
    QCOMPARE(head[0], QByteArray("time"));
    const qsizetype altitude = head.indexOf("alt_rel");
    QVERIFY(altitude > 0);
    double highest = 0;
    for (const QByteArray &line : lines.mid(1)) {
        const QByteArrayList row = line.split(',');
        QCOMPARE(row.size(), head.size());
        highest = qMax(highest, row[altitude].toDouble());
    }
    QVERIFY(highest >= 4.5);
}

void RecordedFlightTest::fullDiskIsReported()
{
    const QString table = m_folder.filePath(QStringLiteral("backup.csv"));
    // A row a second, less than libraries keep until the end, and each row.
    for (const QString &every : {QStringLiteral("30"), QStringLiteral("0")}) {
        const QStringList arguments{QStringLiteral("log"),
                                    QStringLiteral("export"),
                                    m_log,
                                    QStringLiteral("--every"),
                                    every,
                                    QStringLiteral("--out"),
                                    table};
        const RunResult none = runOnFullDisk("skyseal-cli", arguments);
        QCOMPARE(none.status, 3);
        QVERIFY2(none.err.contains("backup.csv: cannot be written: File too large"), none.err.constData());
        QVERIFY2(!none.err.contains("row"), none.err.constData());
        QVERIFY(!QFile::exists(table));
        QCOMPARE(runProgram("skyseal-cli", arguments).status, 0);
        const qint64 size = QFileInfo(table).size();
        QVERIFY(size > 0);
        QCOMPARE(runOnFullDisk("skyseal-cli", arguments).status, 3);
        QCOMPARE(QFileInfo(table).size(), size);
        const RunResult printed = runIntoFullDisk("skyseal-cli", arguments.mid(0, 5));
        QCOMPARE(printed.status, 3);
        QVERIFY2(printed.err.contains("standard output: No space left on device"), printed.err.constData());
        QVERIFY2(!printed.err.contains("row"), printed.err.constData());
        QVERIFY(QFile::remove(table));
    }
    for (const char *command : {"log info", "log verify", "decode"}) {
        const RunResult result = runIntoFullDisk("skyseal-cli", words(command) + QStringList{m_log});
        QVERIFY2(result.status == 3, command);
        QVERIFY2(result.err.contains("standard output: No space left on device"), result.err.constData());
    }
}

void RecordedFlightTest::recordingReplays()
{
    // At its own pace, so only its beginning.
    const RunResult replayed = runProgram("skyseal-cli",
                                          {QStringLiteral("monitor"), QStringLiteral("--link"), QStringLiteral("tlog:") + m_log,
                                           QStringLiteral("--secure"), QStringLiteral("off"), QStringLiteral("--record"),
                                           m_folder.filePath(QStringLiteral("again")), QStringLiteral("--json"),
                                           QStringLiteral("--duration"), QStringLiteral("3")});
    QCOMPARE(replayed.status, 0);
    QCOMPARE(eventsOf(replayed.out, "vehicle").size(), std::size_t(1));
    QVERIFY(!QDir(m_folder.filePath(QStringLiteral("again"))).exists()
            || QDir(m_folder.filePath(QStringLiteral("again"))).isEmpty());
}

SKYSEAL_TEST(RecordedFlightTest)
#include "recorded_flight_test.moc"
