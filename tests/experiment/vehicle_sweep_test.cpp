// A sweep beside an autopilot that runs already, by the real programs: the flights that it repeats, and that the vehicle is on
// the ground and disarmed after every end. A second link of the simulator shows a monitor what the vehicle does.
#include "tests/experiment/flown_vehicle.h"
#include "tests/support/program.h"
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QTemporaryDir>
#include <QtNetwork/QUdpSocket>
#include <QtTest/QTest>

#include <csignal>

using namespace skyseal::test;

namespace {

QByteArray fileIn(const QTemporaryDir &folder, const char *name)
{
    QFile file(folder.filePath(QLatin1String(name)));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Process id of the agent that the sweep started; 0 without one.
qint64 agentOf(qint64 sweep)
{
    QFile children(QStringLiteral("/proc/%1/task/%1/children").arg(sweep));
    if (!children.open(QIODevice::ReadOnly))
        return 0;
    for (const QByteArray &child : children.readAll().split(' ')) {
        QFile name(QStringLiteral("/proc/%1/comm").arg(QLatin1String(child)));
        if (name.open(QIODevice::ReadOnly) && name.readAll().trimmed() == "skyseal-air")
            return child.toLongLong();
    }
    return 0;
}

} // namespace

class VehicleSweepTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void flightsAreRepeated();
    void launchesFlyAnew();
    void failedFlightEndsTheSweep();
    void interruptedSweepLands_data();
    void interruptedSweepLands();
    void terminatedSweepKeepsItsRuns();
    void landsOverANewLink();
    void staysOnTheGround();
    void callingAutopilotIsFound();
    void unconnectedAutopilotIsFound();
    void lossIsSetBesideTheRelaysLog();
};

/// Two flights of two phases, in each of which both arms are measured once.
void VehicleSweepTest::flightsAreRepeated()
{
    FlownVehicle vehicle;
    QVERIFY(vehicle.sim.waitUntilListening(QStringLiteral("tcpin")));
    QTemporaryDir folder;
    const QString script = QLatin1String(kToFiveMetres)
        + QStringLiteral("; sleep 2 | wait alt_rel>=4.5 5 | land; wait armed==0 90");
    Program sweep(QStringLiteral("skyseal-cli"),
                  vehicle.sweep(script,
                                "--suites none,aes-256-gcm --launches 1 --repeats 2 --seconds 1 --warm-up 0.3 --no-noise "
                                "--impair delay=5")
                      + QStringList{QStringLiteral("--out"), folder.path()});
    EVENTUALLY2(vehicle.isFlying(), sweep.errors().constData());
    QVERIFY2(sweep.waitForExit(4 * kDeadlineMs) == 0, sweep.errors().constData());
    EVENTUALLY(vehicle.isDown());
    QCOMPARE(vehicle.landings(), 2);

    const QJsonObject report = QJsonDocument::fromJson(fileIn(folder, "sweep.json")).object();
    QCOMPARE(report[QLatin1String("plan")][QLatin1String("flight")].toString(), script);
    QCOMPARE(report[QLatin1String("plan")][QLatin1String("phases")].toInt(), 2);
    QList<int> phases;
    QStringList arms;
    for (const QJsonValue sample : report[QLatin1String("samples")].toArray()) {
        phases << sample[QLatin1String("phase")].toInt(-1);
        arms << sample[QLatin1String("suite")].toString();
        QVERIFY2(sample[QLatin1String("problem")].isUndefined(), qPrintable(sample[QLatin1String("problem")].toString()));
        QVERIFY(sample[QLatin1String("values")][QLatin1String("packets")].toDouble() > 0);
        QVERIFY(sample[QLatin1String("values")][QLatin1String("autopilot_cpu")].isDouble());
        QVERIFY(sample[QLatin1String("values")][QLatin1String("agent_cpu")].toDouble() > 0);
        QVERIFY(sample[QLatin1String("values")][QLatin1String("simulator_cpu")].isNull()); // it is not ours
    }
    QCOMPARE(phases, QList<int>({0, 0, 1, 1, 0, 0, 1, 1}));
    for (qsizetype i = 0; i < arms.size(); i += 2)
        QVERIFY(arms[i] != arms[i + 1]);
    const QString source = report[QLatin1String("source")].toString();
    QVERIFY2(source.startsWith(QStringLiteral("the autopilot on tcp:127.0.0.1:%1, skyseal-sim").arg(vehicle.port)),
             qPrintable(source));
    QVERIFY2(source.contains(QLatin1String("system 1 is ArduCopter")), qPrintable(source));
    QVERIFY(!report[QLatin1String("placement")].toString().contains(QLatin1String("simulator")));
    QVERIFY(!report[QLatin1String("setting")][QLatin1String("message_mix")].toString().contains(QLatin1String("simulated")));
    QCOMPARE(fileIn(folder, "sweep.csv").count(source.toUtf8()), 8);
    QVERIFY(fileIn(folder, "report.html").contains(source.toUtf8()));
    QVERIFY(vehicle.sim.running());
}

void VehicleSweepTest::launchesFlyAnew()
{
    FlownVehicle vehicle;
    QVERIFY(vehicle.sim.waitUntilListening(QStringLiteral("tcpin")));
    QTemporaryDir folder;
    Program sweep(
        QStringLiteral("skyseal-cli"),
        vehicle.sweep(QLatin1String(kToFiveMetres), "--suites aes-256-gcm --launches 2 --seconds 1 --warm-up 0.3 --no-noise")
            + QStringList{QStringLiteral("--out"), folder.path()});
    QVERIFY2(sweep.waitForExit(4 * kDeadlineMs) == 0, sweep.errors().constData());
    EVENTUALLY_EQUAL(vehicle.landings(), 2);
    const QJsonObject report = QJsonDocument::fromJson(fileIn(folder, "sweep.json")).object();
    QCOMPARE(report[QLatin1String("samples")].toArray().size(), 2);
    QVERIFY(report[QLatin1String("source")].toString().startsWith(QLatin1String("the autopilot on tcp:")));
}

void VehicleSweepTest::failedFlightEndsTheSweep()
{
    FlownVehicle vehicle;
    QVERIFY(vehicle.sim.waitUntilListening(QStringLiteral("tcpin")));
    Program sweep(QStringLiteral("skyseal-cli"),
                  vehicle.sweep(QLatin1String(kToFiveMetres) + QStringLiteral("; wait alt_rel>=500 3; land"),
                                "--suites aes-256-gcm,chacha20 --launches 1 --repeats 3 --seconds 1 --no-noise"));
    EVENTUALLY2(vehicle.isFlying(), sweep.errors().constData());
    QCOMPARE(sweep.waitForExit(2 * kDeadlineMs), 1);
    const QString reason = QStringLiteral("flight 1 failed at 'wait alt_rel>=500 3': timeout, alt_rel is ");
    QCOMPARE(int(sweep.events(QStringLiteral("run")).size()), 1);
    QVERIFY(sweep.last(QStringLiteral("run"))[QLatin1String("problem")].toString().startsWith(reason));
    const QString problem = sweep.last(QStringLiteral("end"))[QLatin1String("problem")].toString();
    QVERIFY2(problem.startsWith(reason), qPrintable(problem));
    EVENTUALLY(vehicle.isDown());
}

void VehicleSweepTest::interruptedSweepLands_data()
{
    QTest::addColumn<int>("signal");
    QTest::addColumn<int>("launches");
    QTest::newRow("Ctrl+C") << SIGINT << 1;
    QTest::newRow("Ctrl+C, of a launch") << SIGINT << 2;
    QTest::newRow("the terminal is closed") << SIGHUP << 1;
    QTest::newRow("SIGTERM") << SIGTERM << 1;
    QTest::newRow("SIGTERM, of a launch") << SIGTERM << 2;
}

/// In the middle of a run.
void VehicleSweepTest::interruptedSweepLands()
{
    QFETCH(int, signal);
    QFETCH(int, launches);
    FlownVehicle vehicle;
    QVERIFY(vehicle.sim.waitUntilListening(QStringLiteral("tcpin")));
    Program sweep(QStringLiteral("skyseal-cli"),
                  vehicle.sweep(QLatin1String(kToFiveMetres), "--suites none,aes-256-gcm --seconds 600 --no-noise --launches")
                      + QStringList{QString::number(launches)});
    EVENTUALLY2(vehicle.isFlying(), sweep.errors().constData());
    QCOMPARE(::kill(static_cast<pid_t>(sweep.pid()), signal), 0);
    QCOMPARE(sweep.waitForExit(2 * kDeadlineMs), 1);
    EVENTUALLY(vehicle.isDown());
    QVERIFY(sweep.errors().contains("the vehicle is brought down first"));
    QCOMPARE(sweep.last(QStringLiteral("end"))[QLatin1String("problem")].toString(), QStringLiteral("cancelled"));
}

/// SIGTERM in flight: the vehicle is brought down, the sweep's programs have ended, and the runs until then can be reported.
void VehicleSweepTest::terminatedSweepKeepsItsRuns()
{
    FlownVehicle vehicle;
    QVERIFY(vehicle.sim.waitUntilListening(QStringLiteral("tcpin")));
    QTemporaryDir folder;
    const QString out = folder.filePath(QStringLiteral("out"));
    Program sweep(
        QStringLiteral("skyseal-cli"),
        vehicle.sweep(QLatin1String(kToFiveMetres),
                      "--suites none,aes-256-gcm --launches 1 --repeats 50 --seconds 0.5 --warm-up 0.1 --no-noise --out")
            + QStringList{out});
    QVERIFY2(!sweep.waitFor(QStringLiteral("run")).isEmpty(), sweep.errors().constData());
    const qint64 agent = agentOf(sweep.pid());
    QVERIFY(agent > 0);
    QCOMPARE(::kill(static_cast<pid_t>(sweep.pid()), SIGTERM), 0);
    QCOMPARE(sweep.waitForExit(2 * kDeadlineMs), 1);
    EVENTUALLY(vehicle.isDown());
    QVERIFY(::kill(static_cast<pid_t>(agent), 0) != 0);
    const auto runs = static_cast<qsizetype>(sweep.events(QStringLiteral("run")).size());
    const RunResult report = runProgram(
        "skyseal-cli", {QStringLiteral("report"), out, QStringLiteral("--out"), folder.filePath(QStringLiteral("again"))}, {},
        2 * kDeadlineMs);
    QVERIFY2(report.status == 0, report.err.constData());
    const QJsonObject kept = QJsonDocument::fromJson(fileIn(folder, "again/sweep.json")).object();
    QVERIFY(runs >= 1 && !kept[QLatin1String("complete")].toBool(true));
    QCOMPARE(kept[QLatin1String("samples")].toArray().size(), runs);
    QVERIFY(fileIn(folder, "again/report.html").contains("This sweep is incomplete"));
}

/// The agent is killed in flight: the sweep starts another one to land.
void VehicleSweepTest::landsOverANewLink()
{
    FlownVehicle vehicle;
    QVERIFY(vehicle.sim.waitUntilListening(QStringLiteral("tcpin")));
    Program sweep(QStringLiteral("skyseal-cli"),
                  vehicle.sweep(QLatin1String(kToFiveMetres), "--suites aes-256-gcm --seconds 600 --no-noise --launches 1"));
    EVENTUALLY2(vehicle.isFlying(), sweep.errors().constData());
    const qint64 agent = agentOf(sweep.pid());
    QVERIFY(agent > 0);
    QCOMPARE(::kill(static_cast<pid_t>(agent), SIGKILL), 0);
    QCOMPARE(sweep.waitForExit(2 * kDeadlineMs), 1);
    EVENTUALLY(vehicle.isDown());
    const QString problem = sweep.last(QStringLiteral("end"))[QLatin1String("problem")].toString();
    QVERIFY2(problem.startsWith(QLatin1String("skyseal-air ended by itself"))
                 && !problem.contains(QLatin1String("MAY STILL FLY")),
             qPrintable(problem));
}

/// Without a script nothing is commanded.
void VehicleSweepTest::staysOnTheGround()
{
    FlownVehicle vehicle;
    QVERIFY(vehicle.sim.waitUntilListening(QStringLiteral("tcpin")));
    Program sweep(QStringLiteral("skyseal-cli"),
                  QStringList{QStringLiteral("sweep"), QStringLiteral("--vehicle"),
                              QStringLiteral("tcp:127.0.0.1:%1").arg(vehicle.port), QStringLiteral("--json")}
                      + words("--suites none,chacha20-poly1305 --launches 1 --seconds 1 --warm-up 0.3 --no-noise"));
    QVERIFY2(sweep.waitForExit(2 * kDeadlineMs) == 0, sweep.errors().constData());
    QCOMPARE(int(sweep.events(QStringLiteral("run")).size()), 2);
    QJsonObject begun; // Other instruments learn of a run before it begins.
    for (const QJsonObject &event : sweep.events()) {
        const QString kind = event[QLatin1String("event")].toString();
        if (kind == QLatin1String("begin")) {
            QVERIFY(begun.isEmpty());
            begun = event;
        } else if (kind == QLatin1String("run")) {
            for (const char *key : {"suite", "load", "condition", "order"}) {
                QVERIFY2(begun.contains(QLatin1String(key)), key);
                QCOMPARE(event[QLatin1String(key)], begun[QLatin1String(key)]);
            }
            begun = {};
        }
    }
    QVERIFY(vehicle.isDown());
    QCOMPARE(vehicle.landings(), 0);
}

/// It connects to the agent, and not the other way round.
void VehicleSweepTest::callingAutopilotIsFound()
{
    const quint16 port = freeTcpPort();
    Program sim(QStringLiteral("skyseal-sim"),
                QStringLiteral("--link tcp:127.0.0.1:%1 --json").arg(port).split(QLatin1Char(' ')));
    Program sweep(QStringLiteral("skyseal-cli"),
                  QStringList{QStringLiteral("sweep"), QStringLiteral("--vehicle"),
                              QStringLiteral("tcpin:127.0.0.1:%1").arg(port), QStringLiteral("--json")}
                      + words("--suites chacha20-poly1305 --launches 1 --seconds 1 --warm-up 0.5 --no-noise"));
    QVERIFY2(sweep.waitForExit(2 * kDeadlineMs) == 0, sweep.errors().constData());
    const QJsonObject run = sweep.last(QStringLiteral("run"));
    QVERIFY(run[QLatin1String("values")][QLatin1String("autopilot_cpu")].isDouble());
    const QString source = sweep.last(QStringLiteral("end"))[QLatin1String("source")].toString();
    QVERIFY2(source.startsWith(QStringLiteral("the autopilot on tcpin:127.0.0.1:%1, skyseal-sim").arg(port)),
             qPrintable(source));
}

/// It sends datagrams to the agent from a socket that is not connected: here this test, on behalf of the simulator.
void VehicleSweepTest::unconnectedAutopilotIsFound()
{
    const quint16 port = freeUdpPort();
    QUdpSocket fromSimulator, toAgent;
    QVERIFY(fromSimulator.bind(QHostAddress::LocalHost) && toAgent.bind(QHostAddress::LocalHost));
    QHostAddress simulator;
    quint16 simulatorPort = 0;
    QByteArray datagram(65536, '\0');
    connect(&fromSimulator, &QUdpSocket::readyRead, this, [&] {
        while (fromSimulator.hasPendingDatagrams()) {
            const qint64 size = fromSimulator.readDatagram(datagram.data(), datagram.size(), &simulator, &simulatorPort);
            if (size > 0)
                toAgent.writeDatagram(datagram.constData(), size, QHostAddress::LocalHost, port);
        }
    });
    connect(&toAgent, &QUdpSocket::readyRead, this, [&] {
        while (toAgent.hasPendingDatagrams()) {
            const qint64 size = toAgent.readDatagram(datagram.data(), datagram.size());
            if (size > 0)
                fromSimulator.writeDatagram(datagram.constData(), size, simulator, simulatorPort);
        }
    });
    Program sim(QStringLiteral("skyseal-sim"),
                QStringLiteral("--link udpout:127.0.0.1:%1").arg(fromSimulator.localPort()).split(QLatin1Char(' ')));
    Program sweep(QStringLiteral("skyseal-cli"),
                  QStringList{QStringLiteral("sweep"), QStringLiteral("--vehicle"),
                              QStringLiteral("udpin:127.0.0.1:%1").arg(port), QStringLiteral("--json")}
                      + words("--suites chacha20-poly1305 --launches 1 --repeats 1 --seconds 1 --warm-up 1 --no-noise"));
    QVERIFY2(QTest::qWaitFor([&] { return !sweep.running(); }, 2 * kDeadlineMs), sweep.errors().constData());
    QVERIFY2(sweep.waitForExit() == 0, sweep.errors().constData());
    QVERIFY(sweep.last(QStringLiteral("run"))[QLatin1String("values")][QLatin1String("autopilot_cpu")].isDouble());
    QFile name(QStringLiteral("/proc/self/comm"));
    QVERIFY(name.open(QIODevice::ReadOnly));
    const QString source = sweep.last(QStringLiteral("end"))[QLatin1String("source")].toString();
    QVERIFY2(source.startsWith(QStringLiteral("the autopilot on udpin:127.0.0.1:%1, ").arg(port)
                               + QString::fromUtf8(name.readAll().trimmed())),
             qPrintable(source));
}

/// Over several launches, in records and in clear frames.
void VehicleSweepTest::lossIsSetBesideTheRelaysLog()
{
    FlownVehicle vehicle;
    QVERIFY(vehicle.sim.waitUntilListening(QStringLiteral("tcpin")));
    QTemporaryDir folder;
    const QString out = folder.filePath(QStringLiteral("out"));
    Program sweep(QStringLiteral("skyseal-cli"),
                  QStringList{QStringLiteral("sweep"), QStringLiteral("--vehicle"),
                              QStringLiteral("tcp:127.0.0.1:%1").arg(vehicle.port), QStringLiteral("--out"), out}
                      + words("--suites none,aes-256-gcm --launches 2 --repeats 1 --seconds 3 --warm-up 0.5 --no-noise "
                              "--impair loss=0.2"));
    QVERIFY2(sweep.waitForExit(2 * kDeadlineMs) == 0, sweep.errors().constData());
    const QByteArray json = fileIn(folder, "out/sweep.json"), page = fileIn(folder, "out/report.html");
    const QJsonArray samples = QJsonDocument::fromJson(json).object()[QLatin1String("samples")].toArray();
    QCOMPARE(samples.size(), 4);
    qint64 dropped = 0, differences = 0;
    for (const QJsonValue sample : samples) {
        const bool plain = sample[QLatin1String("suite")] == QLatin1String("none");
        const QJsonValue relay = sample[QLatin1String("relay")], counted = sample[QLatin1String("counted")];
        const auto number = [&relay](const char *key) { return relay[QLatin1String(key)].toInteger(-1000); };
        const auto grown = [&counted](std::initializer_list<const char *> path) {
            const auto at = [&](const char *edge) {
                QJsonValue value = counted[QLatin1String(edge)];
                for (const char *key : path)
                    value = value[QLatin1String(key)];
                return value.toInteger();
            };
            return at("end") - at("begin");
        };
        QCOMPARE(relay[QLatin1String("unit")].toString(), plain ? QStringLiteral("frames") : QStringLiteral("records"));
        QCOMPARE(number("lost"), plain ? grown({"mavlink", "lost"}) : grown({"rx", "lost"}));
        QCOMPARE(number("received"), plain ? grown({"mavlink", "frames"}) : grown({"rx", "good"}));
        QCOMPARE(number("dropped"), grown({"relay", "to_station", plain ? "frames" : "records"}));
        QCOMPARE(number("difference"), number("lost") - number("dropped"));
        QVERIFY(grown({"relay", "to_station", "datagrams"}) > 0);
        dropped += number("dropped");
        differences += std::abs(number("difference"));
    }
    // What is in transit at an edge, or dropped while a busy machine delays the reading of the log.
    qInfo("dropped %lld, differences %lld", static_cast<long long>(dropped), static_cast<long long>(differences));
    QVERIFY2(dropped >= 40 && differences <= dropped / 4, QByteArray::number(differences).constData());
    QVERIFY(page.contains("Loss against the relay's log"));
    const QByteArray csv = fileIn(folder, "out/sweep.csv");
    QCOMPARE(csv.count(",records,"), 2);
    QCOMPARE(csv.count(",frames,"), 2);
    const RunResult again = runProgram(
        "skyseal-cli", {QStringLiteral("report"), out, QStringLiteral("--out"), folder.filePath(QStringLiteral("again"))}, {},
        2 * kDeadlineMs);
    QVERIFY2(again.status == 0, again.err.constData());
    QVERIFY(fileIn(folder, "again/sweep.json") == json);
    QVERIFY(fileIn(folder, "again/report.html") == page);
}

SKYSEAL_TEST(VehicleSweepTest)
#include "vehicle_sweep_test.moc"
