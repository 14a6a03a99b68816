// skyseal-cli param, mission, fence and rally beside the simulator, over a plain and a sealed link.
#include "tests/support/test_runner.h"
#include "vehicle_command_rig.h"

#include <QtCore/QFile>
#include <QtTest/QTest>

using namespace skyseal::test;

class TransferCommandTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void parametersAreReadAndWritten();
    void parametersAreSavedAndLoaded();
    void parameterFilesAsPeopleHaveThem();
    void missionIsUploadedAndDownloaded();
    void missionWithoutHomeGetsOne();
    void missionOfAnotherStationIsNotOverwritten();
    void homeInAFenceFileIsLeftOut();
    void refusedItemIsNamed();
    void fullDiskKeepsTheOldFile();
    void unknownVehicleIsNotFound();
    void placeToWriteIsCheckedFirst();
    void wrongFilesAreRefused_data();
    void wrongFilesAreRefused();

private:
    RunResult run(const QString &command, const QStringList &more = {}) { return m_vehicle.run(command, more); }
    QString write(const char *name, const QByteArray &content) { return m_vehicle.write(name, content); }

    VehicleCommandRig m_vehicle;
};

void TransferCommandTest::initTestCase()
{
    QVERIFY(m_vehicle.start());
}

void TransferCommandTest::parametersAreReadAndWritten()
{
    const RunResult set = run(QStringLiteral("param set WPNAV_SPEED=625 RTL_ALT=1700"));
    QVERIFY2(set.status == 0, set.err.constData());
    QCOMPARE(set.out, QByteArray("WPNAV_SPEED 625\nRTL_ALT 1700\n"));
    const RunResult get = run(QStringLiteral("param get WPNAV_SPEED --json"));
    QCOMPARE(get.status, 0);
    const auto parameters = eventsIn(get, QStringLiteral("parameter"));
    QCOMPARE(parameters.size(), std::size_t(1));
    const QJsonObject &parameter = parameters[0];
    QCOMPARE(parameter[QLatin1String("name")].toString(), QStringLiteral("WPNAV_SPEED"));
    QCOMPARE(parameter[QLatin1String("value")].toDouble(), 625.);
    const RunResult missing = run(QStringLiteral("param get NO_SUCH_THING"));
    QCOMPARE(missing.status, 1);
    QVERIFY2(missing.err.contains("NO_SUCH_THING: no answer"), missing.err.constData());
    const RunResult list = run(QStringLiteral("param list"));
    QCOMPARE(list.status, 0);
    QVERIFY(list.out.contains("\nWPNAV_SPEED 625\n"));
    QVERIFY(list.out.count('\n') >= 100);
}

void TransferCommandTest::parametersAreSavedAndLoaded()
{
    const QString file = m_vehicle.path(QStringLiteral("all.param"));
    QCOMPARE(run(QStringLiteral("param set RTL_ALT=1800")).status, 0);
    const RunResult saved = run(QStringLiteral("param save ") + file, {QStringLiteral("--format"), QStringLiteral("qgc")});
    QVERIFY2(saved.status == 0, saved.err.constData());
    QCOMPARE(run(QStringLiteral("param set RTL_ALT=1600")).status, 0);
    const RunResult difference = run(QStringLiteral("param diff ") + file);
    QCOMPARE(difference.status, 0);
    QCOMPARE(difference.out, QByteArray("RTL_ALT 1600 (file: 1800)\n"));
    const RunResult loaded = run(QStringLiteral("param load ") + file);
    QVERIFY2(loaded.status == 0, loaded.err.constData());
    QCOMPARE(loaded.out, QByteArray("RTL_ALT 1800\n")); // and no other
    const RunResult foreign = run(QStringLiteral("param load ") + write("foreign.param", "RTL_ALT,1800\nNO_SUCH,1\n"));
    QCOMPARE(foreign.status, 1);
    QVERIFY2(foreign.err.contains("NO_SUCH: the vehicle has no such parameter"), foreign.err.constData());
}

/// A line that cannot be read, and a parameter of another component, are said and cost only themselves.
void TransferCommandTest::parameterFilesAsPeopleHaveThem()
{
    QCOMPARE(run(QStringLiteral("param set RTL_ALT=1600 WPNAV_SPEED=500")).status, 0);
    const QString file = write("people.parm",
                               "RTL_ALT\t  1700   # higher\nRTL_SPEED\n1\t154\tWPNAV_SPEED\t3\t9\n"
                               "WPNAV_SPEED 0x258 @READONLY\nRTL_ALT 1800\n");
    const RunResult strict = run(QStringLiteral("param load ") + file, {QStringLiteral("--strict")});
    QCOMPARE(strict.status, 3);
    QVERIFY(strict.out.isEmpty());
    const RunResult loaded = run(QStringLiteral("param load ") + file);
    QCOMPARE(loaded.status, 1);
    QCOMPARE(loaded.out, QByteArray("RTL_ALT 1800\nWPNAV_SPEED 600\n"));
    for (const QByteArray &line : {QByteArray(":2:1: a name and a value, or QGroundControl's five columns, are expected"),
                                   QByteArray(":5: RTL_ALT occurs again; this line counts"),
                                   QByteArray("154:WPNAV_SPEED: the vehicle has no such parameter")})
        QVERIFY2(loaded.err.contains(line), loaded.err.constData());
}

void TransferCommandTest::missionIsUploadedAndDownloaded()
{
    const QByteArray content("QGC WPL 110\n"
                             "0\t1\t0\t16\t0\t0\t0\t0\t47.39774000\t8.54559000\t488.000\t1\n"
                             "1\t0\t3\t22\t0\t0\t0\t0\t0.00000000\t0.00000000\t15.000\t1\n"
                             "2\t0\t3\t16\t0\t0\t0\t0\t47.39804000\t8.54559000\t15.000\t1\n");
    const RunResult sent = run(QStringLiteral("mission upload ") + write("in.waypoints", content));
    QVERIFY2(sent.status == 0, sent.err.constData());
    const QString back = m_vehicle.path(QStringLiteral("out.waypoints"));
    QVERIFY(run(QStringLiteral("mission download ") + back).status == 0);
    QFile file(back);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray read = file.readAll();
    QCOMPARE(read.count('\n'), content.count('\n'));
    QVERIFY2(read.contains("\t47.39804000\t8.54559000\t15\t1"), read.constData());
    const RunResult list = run(QStringLiteral("mission list --json"));
    QCOMPARE(list.out.count("\"event\":\"item\""), qsizetype(3));
    QCOMPARE(run(QStringLiteral("mission clear")).status, 0);
    const RunResult empty = run(QStringLiteral("mission list --json"));
    QCOMPARE(empty.status, 0);
    QVERIFY(empty.out.count("\"event\":\"item\"") <= 1); // at most the home position
}

void TransferCommandTest::missionWithoutHomeGetsOne()
{
    const RunResult sent = run(QStringLiteral("mission upload ")
                               + write("no-home.waypoints",
                                       "QGC WPL 110\n0\t1\t3\t22\t0\t0\t0\t0\t0\t0\t20\t1\n"
                                       "1\t0\t3\t16\t0\t0\t0\t0\t47.398\t8.5456\t20\t1\n"));
    QVERIFY2(sent.status == 0, sent.err.constData());
    QVERIFY2(sent.err.contains("3 items accepted") && sent.err.contains("it was inserted"), sent.err.constData());
    const auto items = eventsIn(run(QStringLiteral("mission list --json")), QStringLiteral("item"));
    QCOMPARE(items.size(), std::size_t(3));
    QCOMPARE(items[0][QLatin1String("command")].toInt(), 16);
    QCOMPARE(items[0][QLatin1String("frame")].toInt(), 0);
    QCOMPARE(items[1][QLatin1String("command")].toInt(), 22);
}

/// Between the download of a mission and the upload of the edited one, another station may upload its own.
void TransferCommandTest::missionOfAnotherStationIsNotOverwritten()
{
    const auto mission = [](const char *altitude) {
        return QByteArray("QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t47.3977\t8.5456\t488\t1\n"
                          "1\t0\t3\t22\t0\t0\t0\t0\t0\t0\t15.37\t1\n"
                          "2\t0\t3\t16\t0.5\t0\t0\t0\t47.3980461\t8.5455917\t")
            + altitude + "\t1\n";
    };
    const auto upload = [&](const char *altitude, const QStringList &more) {
        return run(QStringLiteral("mission upload ") + write("mission.waypoints", mission(altitude)), more);
    };
    QCOMPARE(upload("20.25", {}).status, 0);
    const QString before = m_vehicle.path(QStringLiteral("before.waypoints"));
    QCOMPARE(run(QStringLiteral("mission download ") + before).status, 0);
    const QStringList expecting{QStringLiteral("--expect"), before};
    const RunResult edited = upload("30", expecting);
    QVERIFY2(edited.status == 0, edited.err.constData());
    const RunResult again = upload("40", expecting); // the other one's mission has 30 m by now
    QCOMPARE(again.status, 1);
    QVERIFY2(again.err.contains("nothing was sent: the vehicle has other items than those that were edited"),
             again.err.constData());
    const auto items = eventsIn(run(QStringLiteral("mission list --json")), QStringLiteral("item"));
    QCOMPARE(items.at(2)[QLatin1String("alt")].toDouble(), 30.);
    QCOMPARE(upload("40", {QStringLiteral("--overwrite")}).status, 0);
    QCOMPARE(upload("40", expecting + QStringList{QStringLiteral("--overwrite")}).status, 2);
    QCOMPARE(upload("40", {QStringLiteral("--expect"), m_vehicle.path(QStringLiteral("missing"))}).status, 3);
}

void TransferCommandTest::homeInAFenceFileIsLeftOut()
{
    const RunResult sent = run(QStringLiteral("fence upload ")
                               + write("fence.waypoints",
                                       "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t47.3977\t8.5456\t488\t1\n"
                                       "1\t0\t3\t5003\t500\t0\t0\t0\t47.3977\t8.5456\t0\t1\n"));
    QVERIFY2(sent.status == 0, sent.err.constData());
    QVERIFY2(sent.err.contains("1 item accepted") && sent.err.contains("it was left out"), sent.err.constData());
    QCOMPARE(run(QStringLiteral("fence clear")).status, 0);
}

void TransferCommandTest::refusedItemIsNamed()
{
    const RunResult refused = run(QStringLiteral("mission upload ")
                                  + write("photo.waypoints",
                                          "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t47.3977\t8.5456\t488\t1\n"
                                          "1\t0\t3\t203\t0\t0\t0\t0\t1\t0\t0\t1\n"));
    QCOMPARE(refused.status, 1);
    QVERIFY2(refused.err.contains("item 1, DO_DIGICAM_CONTROL: command not supported"), refused.err.constData());
}

void TransferCommandTest::fullDiskKeepsTheOldFile()
{
    for (const QString &command : {QStringLiteral("param save "), QStringLiteral("mission download ")}) {
        const QString file = write("backup", "good");
        const RunResult result = runOnFullDisk("skyseal-cli", m_vehicle.arguments(command + file));
        QCOMPARE(result.status, 3);
        QVERIFY2(result.err.contains(file.toUtf8() + ": cannot be written: File too large"), result.err.constData());
        QFile kept(file);
        QVERIFY(kept.open(QIODevice::ReadOnly));
        QCOMPARE(kept.readAll(), QByteArray("good"));
        const QString other = m_vehicle.path(QStringLiteral("other"));
        QCOMPARE(runOnFullDisk("skyseal-cli", m_vehicle.arguments(command + other)).status, 3);
        QVERIFY(!QFile::exists(other));
    }
    for (const QString &command : {QStringLiteral("param get RTL_ALT"), QStringLiteral("param list --json")}) {
        const RunResult result = runIntoFullDisk("skyseal-cli", m_vehicle.arguments(command));
        QCOMPARE(result.status, 3);
        QVERIFY2(result.err.contains("standard output: No space left on device"), result.err.constData());
    }
}

void TransferCommandTest::unknownVehicleIsNotFound()
{
    const RunResult result = run(QStringLiteral("param list --sysid 9 --find-within 2"));
    QCOMPARE(result.status, 1);
    QVERIFY2(result.err.contains("vehicle 9 was not heard"), result.err.constData());
}

void TransferCommandTest::placeToWriteIsCheckedFirst()
{
    const QString file = m_vehicle.path(QStringLiteral("no/such/folder/file"));
    for (const char *command : {"param save ", "mission download "}) {
        const RunResult result = run(QLatin1String(command) + file + QStringLiteral(" --find-within 1000"));
        QCOMPARE(result.status, 3);
        QVERIFY2(result.err.contains(file.toUtf8()), result.err.constData());
    }
}

void TransferCommandTest::wrongFilesAreRefused_data()
{
    QTest::addColumn<QString>("command");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QByteArray>("problem");
    QTest::newRow("parameters") << QStringLiteral("param load") << QByteArray("# parameters\nB\n")
                                << QByteArray(":2:1: a name and a value");
    QTest::newRow("mission") << QStringLiteral("mission upload") << QByteArray("hello") << QByteArray(":1: not a mission file");
    QTest::newRow("fence") << QStringLiteral("fence upload") << QByteArray("QGC WPL 110\n") << QByteArray("no items");
}

void TransferCommandTest::wrongFilesAreRefused()
{
    QFETCH(QString, command);
    QFETCH(QByteArray, content);
    QFETCH(QByteArray, problem);
    const RunResult result = run(command + QLatin1Char(' ') + write("wrong", content));
    QCOMPARE(result.status, 3);
    QVERIFY2(result.err.contains(problem), result.err.constData());
    QCOMPARE(run(command + QLatin1Char(' ') + m_vehicle.path(QStringLiteral("missing"))).status, 3);
}

SKYSEAL_TEST(TransferCommandTest)
#include "transfer_command_test.moc"
