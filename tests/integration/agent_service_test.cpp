// The agent as a service: its configuration file, reload without losing a session, readiness and watchdog, and --check.
#include "tests/support/flight.h"
#include "tests/support/json_values.h"
#include "tests/support/notify_socket.h"
#include "tests/support/run_program.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QScopeGuard>
#include <QtNetwork/QTcpServer>
#include <QtTest/QTest>

#include <csignal>
#include <unistd.h>

using namespace skyseal::test;

namespace {

/// A flight whose agent has its options in a file.
class ConfiguredFlight
{
public:
    ConfiguredFlight() { configure({}); }

    void configure(const QByteArray &more, const QByteArray &without = {})
    {
        QFile file(path());
        if (!flight.ready() || !file.open(QIODevice::WriteOnly | QIODevice::Truncate))
            qFatal("no configuration");
        const auto line = [&](const QByteArray &name, const QString &value) {
            if (name != without)
                file.write(name + " = " + value.toUtf8() + '\n');
        };
        line("vehicle", QStringLiteral("udpin:%1").arg(flight.vehiclePort));
        line("ground", QStringLiteral("udpout:127.0.0.1:%1").arg(flight.groundPort));
        line("identity", flight.path(QStringLiteral("air.key")));
        line("peers", flight.path(QStringLiteral("air.peers")));
        file.write(more);
        file.close();
        file.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
    }
    QString path() const { return flight.path(QStringLiteral("air.conf")); }
    QStringList arguments() const { return {QStringLiteral("--config"), path()}; }

    Flight flight;
};

RunResult checked(const ConfiguredFlight &configured)
{
    return runProgram("skyseal-air", configured.arguments() << QStringLiteral("--check"));
}

void writePrivate(const QString &path, const QByteArray &content)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly | QIODevice::Truncate) || file.write(content) != content.size()
        || !file.setPermissions(QFile::ReadOwner | QFile::WriteOwner))
        qFatal("no file %s", qPrintable(path));
}

QByteArray contentOfFile(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// setpriv(1) and its arguments before the program: the superuser's rights in files are gone, as other users have none.
QStringList withoutPrivileges()
{
    return {QStringLiteral("setpriv"), QStringLiteral("--inh-caps=-all"), QStringLiteral("--bounding-set=-all")};
}

} // namespace

class AgentServiceTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void optionsStandInTheFile();
    void wrongLineIsNamedByItsNumber();
    void reloadChangesSuitesAndKeepsTheSession();
    void wrongConfigurationChangesNothing();
    void managerHearsOfReadinessLifeAndEnd();
    void agentWithoutItsPortIsNotReady();
    void checkFindsNothingWrong();
    void checkSaysWhatIsWrong_data();
    void checkSaysWhatIsWrong();
    void checkFindsPortsInUse();
    void checkFindsThatNobodyIsPilot();
    void checkFindsMissingPermissions_data();
    void checkFindsMissingPermissions();
    void checkExplainsTheFirstStart();
};

void AgentServiceTest::optionsStandInTheFile()
{
    ConfiguredFlight configured;
    Program air(QStringLiteral("skyseal-air"), configured.arguments());
    Program monitor(QStringLiteral("skyseal-cli"), configured.flight.monitorArguments());
    QVERIFY2(!monitor.waitFor(QStringLiteral("session"), isUp).isEmpty(), air.errors().constData());
}

void AgentServiceTest::wrongLineIsNamedByItsNumber()
{
    ConfiguredFlight configured;
    configured.configure("\nsutes = all\n");
    const RunResult result = runProgram("skyseal-air", configured.arguments());
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains("air.conf:6: no option is named 'sutes'"), result.err.constData());
}

void AgentServiceTest::reloadChangesSuitesAndKeepsTheSession()
{
    ConfiguredFlight configured;
    Program sim(QStringLiteral("skyseal-sim"), configured.flight.simArguments());
    Program air(QStringLiteral("skyseal-air"), configured.arguments());
    Program monitor(QStringLiteral("skyseal-cli"), configured.flight.monitorArguments());
    QVERIFY(!monitor.waitFor(QStringLiteral("session"), isUp).isEmpty());
    QVERIFY(!monitor.waitFor(QStringLiteral("vehicle")).isEmpty());

    configured.configure("suites = aes-256-gcm,aes-256-ctr\nmax-age = 7\n");
    QCOMPARE(::kill(static_cast<pid_t>(air.pid()), SIGHUP), 0);
    const QJsonObject change = monitor.waitFor(QStringLiteral("switch"));
    QCOMPARE(change[QLatin1String("result")].toString(), QStringLiteral("committed"));
    QCOMPARE(change[QLatin1String("to")].toString(), QStringLiteral("aes-256-gcm"));
    EVENTUALLY(air.errors().contains("after a restart: --max-age\n"));
    monitor.skipReceivedEvents();
    QVERIFY(!monitor.waitFor(QStringLiteral("stats")).isEmpty());
    QCOMPARE(monitor.events(QStringLiteral("session")).size(), std::size_t(1)); // neither ended nor came up again
    QCOMPARE(monitor.terminate(), 0);
    const QJsonObject mavlink = monitor.last(QStringLiteral("summary"))[QLatin1String("mavlink")].toObject();
    QCOMPARE(mavlink[QLatin1String("lost")].toInt(-1), 0);
}

void AgentServiceTest::wrongConfigurationChangesNothing()
{
    ConfiguredFlight configured;
    Program air(QStringLiteral("skyseal-air"), configured.arguments());
    Program monitor(QStringLiteral("skyseal-cli"), configured.flight.monitorArguments());
    QVERIFY(!monitor.waitFor(QStringLiteral("session"), isUp).isEmpty());
    configured.configure("suites = none\n");
    QCOMPARE(::kill(static_cast<pid_t>(air.pid()), SIGHUP), 0);
    EVENTUALLY(air.errors().contains("the previous one stays in force"));
    QVERIFY(air.running());
    monitor.skipReceivedEvents();
    QVERIFY(!monitor.waitFor(QStringLiteral("stats")).isEmpty());
    QVERIFY(monitor.events(QStringLiteral("switch")).empty());
}

void AgentServiceTest::managerHearsOfReadinessLifeAndEnd()
{
    NotifySocket manager;
    qputenv("WATCHDOG_USEC", "200000");
    ConfiguredFlight configured;
    Program air(QStringLiteral("skyseal-air"), configured.arguments());
    EVENTUALLY_EQUAL(manager.count("READY=1"), 1);
    EVENTUALLY(manager.count("WATCHDOG=1") >= 3);
    QCOMPARE(::kill(static_cast<pid_t>(air.pid()), SIGSTOP), 0); // hangs
    const int before = manager.count("WATCHDOG=1");
    QVERIFY(!QTest::qWaitFor([&] { return manager.count("WATCHDOG=1") > before + 1; }, 500));
    QCOMPARE(::kill(static_cast<pid_t>(air.pid()), SIGCONT), 0);
    EVENTUALLY(manager.count("WATCHDOG=1") > before + 1);
    QCOMPARE(manager.count("STOPPING=1"), 0);
    QCOMPARE(air.terminate(), 0);
    EVENTUALLY_EQUAL(manager.count("STOPPING=1"), 1);
    QCOMPARE(manager.count("READY=1"), 1);
}

void AgentServiceTest::agentWithoutItsPortIsNotReady()
{
    ConfiguredFlight configured;
    Program first(QStringLiteral("skyseal-air"), configured.arguments() << QStringLiteral("--json"));
    QVERIFY(!first.waitFor(QStringLiteral("stats")).isEmpty());
    NotifySocket manager;
    const RunResult second = runProgram("skyseal-air", configured.arguments());
    QCOMPARE(second.status, 3);
    QVERIFY2(second.err.contains("udpin:127.0.0.1"), second.err.constData());
    QCOMPARE(manager.count("READY=1"), 0);
}

void AgentServiceTest::checkFindsNothingWrong()
{
    ConfiguredFlight configured;
    const RunResult result = checked(configured);
    QVERIFY2(result.status == 0, (result.out + result.err).constData());
    QCOMPARE(result.out, QByteArray("the configuration is valid\n"));
}

void AgentServiceTest::checkSaysWhatIsWrong_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("device") << QByteArray("vehicle = serial:/dev/nonexistent:57600")
                            << QByteArray("/dev/nonexistent: No such file");
    QTest::newRow("no serial port") << QByteArray("vehicle = serial:/dev/null:57600")
                                    << QByteArray("/dev/null is not a serial port");
    QTest::newRow("host") << QByteArray("ground = udpout:station.invalid:14550") << QByteArray("station.invalid is not known");
    QTest::newRow("key") << QByteArray("identity = /nonexistent/air.key") << QByteArray("/nonexistent/air.key");
    QTest::newRow("signing key") << QByteArray("vehicle-signing = /nonexistent/vehicle.signing")
                                 << QByteArray("/nonexistent/vehicle.signing does not exist: skyseal-air --signing setup");
    QTest::newRow("signing key of others") << QByteArray("vehicle-signing = /dev/null") << QByteArray("/dev/null");
}

void AgentServiceTest::checkSaysWhatIsWrong()
{
    QFETCH(QByteArray, line);
    QFETCH(QByteArray, said);
    ConfiguredFlight configured;
    configured.configure(line + '\n', line.left(line.indexOf(' ')));
    const RunResult result = checked(configured);
    QVERIFY2(result.status == 1, result.err.constData());
    QVERIFY2(result.out.contains(said), result.out.constData());
}

/// Of the agent itself, while it runs, and of a program that accepts connections.
void AgentServiceTest::checkFindsPortsInUse()
{
    ConfiguredFlight configured;
    const QByteArray reason = "; another program, such as a running agent, may use the port";
    Program running(QStringLiteral("skyseal-air"), configured.arguments() << QStringLiteral("--json"));
    QVERIFY2(!running.waitFor(QStringLiteral("stats")).isEmpty(), running.errors().constData());
    const RunResult datagrams = checked(configured);
    QCOMPARE(datagrams.status, 1);
    QVERIFY2(datagrams.out.startsWith("udpin:127.0.0.1:" + QByteArray::number(configured.flight.vehiclePort) + ": ")
                 && datagrams.out.endsWith(reason + '\n') && datagrams.out.count('\n') == 1,
             datagrams.out.constData());
    QCOMPARE(running.terminate(), 0);
    QCOMPARE(checked(configured).status, 0);

    QTcpServer server;
    QVERIFY(server.listen(QHostAddress::LocalHost));
    const QByteArray url = "tcpin:127.0.0.1:" + QByteArray::number(server.serverPort());
    configured.configure("vehicle = " + url + '\n', "vehicle");
    const RunResult stream = checked(configured);
    QCOMPARE(stream.status, 1);
    QVERIFY2(stream.out.startsWith(url + ": ") && stream.out.endsWith(reason + '\n'), stream.out.constData());
    server.close();
    QCOMPARE(checked(configured).status, 0);
}

void AgentServiceTest::checkFindsThatNobodyIsPilot()
{
    ConfiguredFlight configured;
    const QString peers = configured.flight.path(QStringLiteral("air.peers"));
    QByteArray list = contentOfFile(peers);
    QVERIFY2(list.contains(" pilot "), list.constData());
    writePrivate(peers, list.replace(" pilot ", " observer "));
    const RunResult result = checked(configured);
    QCOMPARE(result.status, 1);
    QCOMPARE(result.out, peers.toUtf8() + ": no station is a pilot, so none can command the vehicle\n");
}

void AgentServiceTest::checkFindsMissingPermissions_data()
{
    QTest::addColumn<QByteArray>("line"); // FOLDER is that of the flight; in FOLDER/locked nothing can be written
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("device") << QByteArray("vehicle = serial:FOLDER/device:57600")
                            << QByteArray("FOLDER/device: this user has no permission to open it; add the user to the group "
                                          "dialout\n");
    QTest::newRow("list of peers") << QByteArray("peers = FOLDER/locked/air.peers")
                                   << QByteArray("FOLDER/locked is not writable, but holds the handshake counters and the list "
                                                 "of peers\n");
    QTest::newRow("signing key") << QByteArray("vehicle-signing = FOLDER/locked/vehicle.signing")
                                 << QByteArray("FOLDER/locked is not writable, but holds the timestamp of the signatures\n");
}

void AgentServiceTest::checkFindsMissingPermissions()
{
    SKYSEAL_REQUIRES("setpriv");
    QFETCH(QByteArray, line);
    QFETCH(QByteArray, said);
    const bool isSuperuser = ::geteuid() == 0;
    const QStringList bare = withoutPrivileges();
    ConfiguredFlight configured;
    const QString locked = configured.flight.path(QStringLiteral("locked"));
    const QString device = configured.flight.path(QStringLiteral("device"));
    QVERIFY(QDir().mkdir(locked));
    writePrivate(device, {});
    writePrivate(locked + QStringLiteral("/air.peers"), contentOfFile(configured.flight.path(QStringLiteral("air.peers"))));
    writePrivate(locked + QStringLiteral("/vehicle.signing"), QByteArray(64, '5'));
    QVERIFY(QFile::setPermissions(device, QFile::Permissions())
            && QFile::setPermissions(locked, QFile::ReadOwner | QFile::ExeOwner));
    const auto unlock = qScopeGuard(
        [&] { QFile::setPermissions(locked, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner); });
    const QByteArray folder = QFileInfo(locked).path().toUtf8();
    configured.configure(QByteArray(line).replace("FOLDER", folder) + '\n', line.left(line.indexOf(' ')));
    QStringList arguments = configured.arguments() << QStringLiteral("--check");
    QString program = QStringLiteral(SKYSEAL_BIN_DIR "/skyseal-air");
    if (isSuperuser) {
        arguments = bare.mid(1) << program << arguments;
        program = bare[0];
    }
    const RunResult result = runToItsEnd(program, arguments);
    QVERIFY2(result.status == 1, (result.out + result.err).constData());
    QCOMPARE(result.out, said.replace("FOLDER", folder));
}

/// Without a known station the configuration is valid, since the first one is paired with the running agent.
void AgentServiceTest::checkExplainsTheFirstStart()
{
    ConfiguredFlight configured;
    const QString peers = configured.flight.path(QStringLiteral("air.peers"));
    const QByteArray advice = "no station is known yet, start the agent and pair one with skyseal-air --pair --identity "
        + configured.flight.path(QStringLiteral("air.key")).toUtf8();
    writePrivate(peers, "# nobody yet\n");
    const RunResult empty = checked(configured);
    QVERIFY2(empty.status == 0, (empty.out + empty.err).constData());
    QVERIFY2(empty.err.contains(peers.toUtf8() + ": " + advice), empty.err.constData());
    QVERIFY(QFile::remove(peers));
    const RunResult missing = checked(configured);
    QVERIFY2(missing.status == 0, (missing.out + missing.err).constData());
    QVERIFY2(missing.err.contains(peers.toUtf8() + ": the start creates it; " + advice), missing.err.constData());
    QVERIFY(!QFile::exists(peers)); // by the start, not by the check
}

SKYSEAL_TEST(AgentServiceTest)
#include "agent_service_test.moc"
