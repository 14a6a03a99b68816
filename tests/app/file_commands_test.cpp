// skyseal-cli ftp and logs beside the simulator behind an agent, over the sealed link.
#include "app/cli/transfer/part_file.h"
#include "tests/support/test_runner.h"
#include "vehicle_command_rig.h"

#include <QtCore/QDir>
#include <QtTest/QTest>

#include <algorithm>
#include <csignal>
#include <random>

using namespace skyseal::test;
using skyseal::app::PartFile;

class FileCommandsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void filesAreWrittenListedReadAndRemoved();
    void missingFilesAreReported();
    void parametersAreAFile();
    void interruptedTransferGoesOn();
    void changedFileIsReadAnew();
    void logsAreListedReadAndErased();
    void vehicleWithoutFilesIsReported();
    void usageIsChecked_data();
    void usageIsChecked();

private:
    RunResult run(const QString &command, const QStringList &more = {}) { return m_vehicle.run(command, more); }
    QString path(const char *name) const { return m_vehicle.path(QLatin1String(name)); }

    VehicleCommandRig m_vehicle;
};

namespace {

QByteArray noise(int size)
{
    std::mt19937 random(1);
    QByteArray out(size, 0);
    std::generate(out.begin(), out.end(), [&random] { return static_cast<char>(random()); });
    return out;
}

QByteArray contentOf(const QString &file)
{
    QFile in(file);
    return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray("not there");
}

} // namespace

void FileCommandsTest::initTestCase()
{
    QVERIFY(m_vehicle.start());
}

void FileCommandsTest::filesAreWrittenListedReadAndRemoved()
{
    const QByteArray content = noise(5000);
    const RunResult sent = run(QStringLiteral("ftp put ") + m_vehicle.write("script.lua", content) + QStringLiteral(" /"));
    QVERIFY2(sent.status == 0, sent.err.constData());
    QVERIFY2(sent.err.contains("/script.lua: 5000 bytes, the checksums agree"), sent.err.constData());

    const RunResult list = run(QStringLiteral("ftp ls"));
    QVERIFY2(list.status == 0, list.err.constData());
    QVERIFY2(list.out.contains("      5000 script.lua\n"), list.out.constData());
    QVERIFY2(list.out.contains("         - APM/\n"), list.out.constData());
    const auto entries = eventsIn(run(QStringLiteral("ftp ls / --json")), QStringLiteral("entry"));
    const auto found = std::ranges::find_if(entries, [](const QJsonObject &entry) {
        return entry[QLatin1String("name")].toString() == QLatin1String("script.lua")
            && entry[QLatin1String("size")].toInt() == 5000 && !entry[QLatin1String("folder")].toBool();
    });
    QVERIFY(found != entries.end());

    const QString back = m_vehicle.write("back.lua", "an older file");
    const RunResult got = run(QStringLiteral("ftp get /script.lua ") + back + QStringLiteral(" --json"));
    QVERIFY2(got.status == 0, got.err.constData());
    QCOMPARE(contentOf(back), content);
    const auto downloaded = eventsIn(got, QStringLiteral("downloaded"));
    QCOMPARE(downloaded.size(), std::size_t(1));
    QCOMPARE(downloaded[0][QLatin1String("bytes")].toInt(), 5000);
    QVERIFY(downloaded[0][QLatin1String("verified")].toBool());

    // Two programs, one after the other, that remove files: each its own.
    QCOMPARE(run(QStringLiteral("ftp put ") + back + QStringLiteral(" /other.lua")).status, 0);
    QCOMPARE(run(QStringLiteral("ftp rm /script.lua")).status, 0);
    QCOMPARE(run(QStringLiteral("ftp rm /other.lua")).status, 0);
    const RunResult empty = run(QStringLiteral("ftp ls"));
    QVERIFY2(empty.status == 0 && !empty.out.contains(".lua"), empty.out.constData());
}

void FileCommandsTest::missingFilesAreReported()
{
    const RunResult got = run(QStringLiteral("ftp get /none ") + path("none"));
    QCOMPARE(got.status, 1);
    QVERIFY2(got.err.contains("/none: no such file or folder"), got.err.constData());
    QVERIFY(!QFile::exists(path("none")));
    const RunResult removed = run(QStringLiteral("ftp rm /none"));
    QCOMPARE(removed.status, 1);
    QVERIFY2(removed.err.contains("/none: no such file or folder"), removed.err.constData());
    QCOMPARE(run(QStringLiteral("ftp ls /none")).status, 1);
    const RunResult log = run(QStringLiteral("logs get 999 ") + path("none"));
    QCOMPARE(log.status, 1);
    QVERIFY2(log.err.contains("log 999: the vehicle has no such log"), log.err.constData());
    QVERIFY(!QFile::exists(path("none")));
}

void FileCommandsTest::parametersAreAFile()
{
    const QString file = path("param.pck");
    const RunResult got = run(QStringLiteral("ftp get @PARAM/param.pck ") + file);
    QVERIFY2(got.status == 0, got.err.constData());
    QVERIFY(contentOf(file).startsWith("\x1b\x67"));
    QVERIFY2(got.err.contains("without a checksum"), got.err.constData());
    const QByteArray content = contentOf(file);
    const RunResult full = runOnFullDisk("skyseal-cli",
                                         m_vehicle.arguments(QStringLiteral("ftp get @PARAM/param.pck ") + file));
    QCOMPARE(full.status, 3);
    QVERIFY2(full.err.contains("param.pck: cannot be written: File too large"), full.err.constData());
    QCOMPARE(contentOf(file), content);
}

void FileCommandsTest::interruptedTransferGoesOn()
{
    const QString big = m_vehicle.write("big", noise(300'000));
    QCOMPARE(run(QStringLiteral("ftp put ") + big + QStringLiteral(" /big")).status, 0);
    QVERIFY(QDir().mkdir(path("place")));
    const QString target = path("place/big");
    Program get(QStringLiteral("skyseal-cli"),
                m_vehicle.arguments(QStringLiteral("ftp get /big ") + target, {QStringLiteral("--json")}));
    const QJsonObject progress = get.waitFor(QStringLiteral("progress"));
    QVERIFY2(!progress.isEmpty(), get.errors().constData());
    QCOMPARE(progress[QLatin1String("total")].toInt(), 300'000);
    QVERIFY(progress[QLatin1String("done")].toInt() < 300'000);
    QCOMPARE(::kill(static_cast<pid_t>(get.pid()), SIGINT), 0);
    QCOMPARE(get.waitForExit(), 1);
    const auto files = [this] { return QDir(path("place")).entryList(QDir::Files | QDir::Hidden); };
    QCOMPARE(files(), QStringList{QStringLiteral("big.part")});
    // The file that the vehicle still has open stands in nobody's way.
    const RunResult again = run(QStringLiteral("ftp get /big ") + target + QStringLiteral(" --json"));
    QVERIFY2(again.status == 0, again.err.constData());
    const auto resumed = eventsIn(again, QStringLiteral("resumed"));
    QCOMPARE(resumed.size(), std::size_t(1));
    QVERIFY(resumed[0][QLatin1String("bytes")].toInt() >= progress[QLatin1String("done")].toInt());
    QCOMPARE(contentOf(target), contentOf(big));
    QCOMPARE(files(), QStringList{QStringLiteral("big")});
    QCOMPARE(run(QStringLiteral("ftp rm /big")).status, 0);
}

void FileCommandsTest::changedFileIsReadAnew()
{
    const QByteArray content = noise(5000);
    QCOMPARE(run(QStringLiteral("ftp put ") + m_vehicle.write("changed", content) + QStringLiteral(" /changed")).status, 0);
    const QString target = path("changed.copy");
    const auto keepOldPart = [&target] {
        PartFile part(target.toStdString(), "vehicle 1 file /changed");
        part.begin(5000, 0);
        part.append(0, skyseal::Bytes(239, 1));
    };
    keepOldPart();
    const RunResult told = run(QStringLiteral("ftp get /changed ") + target + QStringLiteral(" --json"));
    QVERIFY2(told.status == 0, told.err.constData());
    const auto resumed = eventsIn(told, QStringLiteral("resumed")), restarted = eventsIn(told, QStringLiteral("restarted"));
    QCOMPARE(resumed.size(), std::size_t(1));
    QCOMPARE(resumed[0][QLatin1String("bytes")].toInt(), 239);
    QCOMPARE(restarted.size(), std::size_t(1));
    QCOMPARE(restarted[0][QLatin1String("reason")].toString(), QStringLiteral("the checksums of both ends differ"));
    for (const QJsonObject &event : {resumed[0], restarted[0]})
        QCOMPARE(event[QLatin1String("file")].toString(), target + QStringLiteral(".part"));
    QCOMPARE(contentOf(target), content);
    QVERIFY(QFile::remove(target));
    keepOldPart();
    const RunResult got = run(QStringLiteral("ftp get /changed ") + target);
    QVERIFY2(got.status == 0, got.err.constData());
    QVERIFY2(got.err.contains("goes on from 239 bytes"), got.err.constData());
    QVERIFY2(got.err.contains("starts anew: the checksums of both ends differ"), got.err.constData());
    QCOMPARE(contentOf(target), content);
    QVERIFY(!QFile::exists(target + QStringLiteral(".part")));
    const QString foreign = m_vehicle.write("changed.copy.part", "somebody else's");
    QCOMPARE(run(QStringLiteral("ftp get /changed ") + target).status, 0);
    QCOMPARE(contentOf(foreign), QByteArray("somebody else's"));
    QCOMPARE(run(QStringLiteral("ftp rm /changed")).status, 0);
}

void FileCommandsTest::logsAreListedReadAndErased()
{
    const RunResult none = run(QStringLiteral("logs list"));
    QVERIFY2(none.status == 0 && none.out.isEmpty(), none.err.constData());
    const RunResult flown = m_vehicle.fly(QStringLiteral("wait ekf_ok==1 60; arm; disarm"));
    QVERIFY2(flown.status == 0, flown.err.constData());
    const auto logs = eventsIn(run(QStringLiteral("logs list --json")), QStringLiteral("log"));
    QCOMPARE(logs.size(), std::size_t(1));
    QCOMPARE(logs[0][QLatin1String("id")].toInt(), 1);
    const int size = logs[0][QLatin1String("bytes")].toInt();
    QVERIFY(size > 1000);
    const QString file = path("flight.bin");
    const RunResult got = run(QStringLiteral("logs get 1 ") + file);
    QVERIFY2(got.status == 0, got.err.constData());
    QCOMPARE(QFile(file).size(), qint64(size));
    const RunResult byFile = run(QStringLiteral("ftp get /APM/LOGS/00000001.BIN ") + path("same.bin"));
    QVERIFY2(byFile.status == 0, byFile.err.constData());
    QCOMPARE(contentOf(path("same.bin")), contentOf(file));
    const RunResult erased = run(QStringLiteral("logs erase --all"));
    QVERIFY2(erased.status == 0, erased.err.constData());
    QVERIFY(run(QStringLiteral("logs list")).out.isEmpty());
}

void FileCommandsTest::vehicleWithoutFilesIsReported()
{
    QCOMPARE(run(QStringLiteral("param set BRD_OPTIONS=2")).status, 0); // ArduPilot: MAVLink FTP is off
    const RunResult list = run(QStringLiteral("ftp ls"));
    QCOMPARE(list.status, 1);
    QVERIFY2(list.err.contains("/: no answer to"), list.err.constData());
    const RunResult parameters = run(QStringLiteral("param list")); // by messages instead
    QVERIFY2(parameters.status == 0, parameters.err.constData());
    QVERIFY(parameters.out.contains("\nBRD_OPTIONS 2\n"));
    QCOMPARE(run(QStringLiteral("param set BRD_OPTIONS=0")).status, 0);
    QCOMPARE(run(QStringLiteral("ftp ls")).status, 0);
}

void FileCommandsTest::usageIsChecked_data()
{
    QTest::addColumn<QString>("command");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("problem");
    const auto row = [](const char *command, int status, const char *problem) {
        QTest::newRow(command) << QString::fromLatin1(command) << status << QByteArray(problem);
    };
    row("ftp copy", 2, "ls, get, put or rm is expected");
    row("ftp get", 2, "argument");
    row("ftp get /folder/", 2, "names no file");
    row("ftp put file", 2, "argument");
    row("ftp put /no/such/file /a", 3, "/no/such/file");
    row("ftp get /a /no/such/folder/a", 3, "/no/such/folder/a");
    row("ftp rm", 2, "argument");
    row("logs show", 2, "list, get or erase is expected");
    row("logs get newest", 2, "the number of a log is expected");
    row("logs get 70000", 2, "the number of a log is expected");
    row("logs get 1 /no/such/folder/a", 3, "/no/such/folder/a");
    row("logs erase", 2, "--all is required");
}

void FileCommandsTest::usageIsChecked()
{
    QFETCH(QString, command);
    QFETCH(int, status);
    QFETCH(QByteArray, problem);
    const RunResult result = run(command);
    QCOMPARE(result.status, status);
    QVERIFY2(result.err.contains(problem), result.err.constData());
}

SKYSEAL_TEST(FileCommandsTest)
#include "file_commands_test.moc"
