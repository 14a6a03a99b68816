// skyseal-cli gateway as people and scripts use it: another ground station, one that knows nothing of sealing, flies through
// it, and skyseal-cli status, switch and revoke act on it while it runs.
#include "tests/engine/udp_end.h"
#include "tests/support/addresses.h"
#include "tests/support/eventually.h"
#include "tests/support/gateway_flight.h"
#include "tests/support/notify_socket.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QFileInfo>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtNetwork/QTcpSocket>
#include <QtNetwork/QUdpSocket>
#include <QtTest/QTest>

#include <csignal>

using namespace skyseal;
using namespace skyseal::test;

namespace {

/// A simulated vehicle behind a gateway that serves one station.
struct ServedStation : GatewayFlight
{
    explicit ServedStation(const QString &options = {}, quint16 port = freeUdpPort())
        : GatewayFlight({QStringLiteral("udpout:127.0.0.1:%1").arg(port) + options}), stationPort(port)
    {
        startSimulatedVehicle();
    }

    const quint16 stationPort;
};

/// The command line of a gateway for the stations that call at `served`.
QStringList gatewayArguments(const Flight &flight, const QString &served)
{
    return {QStringLiteral("gateway"),
            QStringLiteral("--link"),
            QStringLiteral("udpin:127.0.0.1:0"),
            QStringLiteral("--identity"),
            flight.path(QStringLiteral("ground.key")),
            QStringLiteral("--peers"),
            flight.path(QStringLiteral("ground.peers")),
            QStringLiteral("--no-record"),
            QStringLiteral("--serve"),
            served};
}

} // namespace

class GatewayProgramTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void anotherStationFliesWhileSuitesAreSwitched();
    void readerSeesAndCommandsNothing();
    void gatewaySendsNoHeartbeat();
    void metricsAreServed();
    void peerIsRevoked();
    void socketIsOfThisUserAlone();
    void controlSocketReplacesNoFile();
    void withoutAGatewayNothingAnswers();
    void managerHearsOfReadinessAndLife();
    void managerHearsNothingWhileTheReceiverHangs();
    void closedTerminalEndsTheGateway();
    void gatewayOutlivesItsTerminal();
    void takenPortEndsTheGateway();
    void openMetricsAreWarnedOf();
    void openServiceIsWarnedOf_data();
    void openServiceIsWarnedOf();
    void journalHasTheSeverityOfEachReport();
    void commandLineDecidesOnTheRecording();
    void recordingHoldsTheFlight();
};

void GatewayProgramTest::anotherStationFliesWhileSuitesAreSwitched()
{
    ServedStation flight(QStringLiteral(",write=command,name=planner"));
    QVERIFY2(flight.waitForSession(), flight.gateway->errors().constData());
    const auto station = plainStation(flight.stationPort,
                                      {QStringLiteral("--do"),
                                       QStringLiteral("wait ekf_ok==1 60; mode GUIDED; arm; takeoff 5; wait alt_rel>=4.5 60; "
                                                      "land; wait armed==0 90")});
    const int switched = switchWhileFlying(flight, *station, 1);
    QCOMPARE(flight.control({QStringLiteral("switch"), QStringLiteral("rc4")}).status, 1); // not offered
    QVERIFY2(station->waitForExit() == 0, station->errors().constData());
    QVERIFY(switched > 6);
    const QJsonObject mavlink = station->last(QStringLiteral("summary"))[QLatin1String("mavlink")].toObject();
    QVERIFY(mavlink[QLatin1String("frames")].toInt() > 100);
    QCOMPARE(mavlink[QLatin1String("lost")].toInt(-1), 0);
    QCOMPARE(mavlink[QLatin1String("duplicate")].toInt(-1), 0);

    const RunResult status = flight.control({QStringLiteral("status"), QStringLiteral("--json")});
    QCOMPARE(status.status, 0);
    const QJsonObject state = QJsonDocument::fromJson(status.out)[QLatin1String("status")].toObject();
    QCOMPARE(state[QLatin1String("sessions")][0][QLatin1String("peer")].toString(), QStringLiteral("air-1"));
    QCOMPARE(state[QLatin1String("clients")][0][QLatin1String("name")].toString(), QStringLiteral("planner"));
    QVERIFY(state[QLatin1String("clients")][0][QLatin1String("forwarded")].toInt() > 5);
    QVERIFY(flight.control({QStringLiteral("status")}).out.contains("client planner at 127.0.0.1:"));
    QVERIFY2(flight.gateway->terminate() == 0, flight.gateway->errors().constData());
}

void GatewayProgramTest::readerSeesAndCommandsNothing()
{
    ServedStation flight;
    const auto client = plainStation(flight.stationPort, {QStringLiteral("--do"), QStringLiteral("mode GUIDED; arm")});
    QVERIFY(!client->waitFor(QStringLiteral("vehicle")).isEmpty());
    QCOMPARE(client->waitForExit(), 1); // the script failed
    const QJsonObject step = client->last(QStringLiteral("command"));
    QVERIFY2(step[QLatin1String("result")].toString() != QLatin1String("done"), client->errors().constData());
    QVERIFY(!flight.gateway->waitFor(QStringLiteral("client_denied")).isEmpty());
    const auto told = [](const QJsonObject &text) {
        return text[QLatin1String("text")].toString().startsWith(QLatin1String("Gateway: "));
    };
    client->skipReceivedEvents();
    const std::vector<QJsonObject> texts = client->events(QStringLiteral("statustext"));
    QVERIFY(std::any_of(texts.begin(), texts.end(), told));
}

/// A vehicle would take its heartbeats for those of a pilot, and enter no failsafe when the pilot is gone.
void GatewayProgramTest::gatewaySendsNoHeartbeat()
{
    GatewayFlight flight({QStringLiteral("udpin:127.0.0.1:0")});
    flight.startAgent(loopback("udpin", flight.flight.vehiclePort));
    UdpEnd vehicle(flight.flight.vehiclePort, mavlink::MAV_COMP_ID_AUTOPILOT1);
    const auto requests = [&vehicle] {
        const mavlink::Heartbeat heartbeat{.type = mavlink::MAV_TYPE_QUADROTOR,
                                           .autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA};
        vehicle.send(heartbeat, 1);
        return vehicle.all<mavlink::Timesync>().size();
    };
    EVENTUALLY(requests() >= 4); // one a second, as often as heartbeats are sent
    QVERIFY(!vehicle.newest<mavlink::Heartbeat>());
}

void GatewayProgramTest::metricsAreServed()
{
    ServedStation flight;
    const auto get = [&flight](const char *request) {
        QTcpSocket socket;
        socket.connectToHost(QHostAddress::LocalHost, flight.metricsPort);
        if (!socket.waitForConnected(kDeadlineMs))
            return QByteArray();
        socket.write(request + QByteArray(" HTTP/1.1\r\nHost: localhost\r\n\r\n"));
        while (socket.waitForReadyRead(kDeadlineMs))
            ;
        return socket.readAll();
    };
    QVERIFY(!flight.gateway->waitFor(QStringLiteral("vehicle")).isEmpty());
    const auto shown = [&] { return get("GET /metrics").contains("\nskyseal_vehicle_heard{sysid=\"1\"} 1\n"); };
    EVENTUALLY(shown());
    const QByteArray answer = get("GET /metrics");
    QVERIFY2(answer.startsWith("HTTP/1.1 200 OK\r\nContent-Type: application/openmetrics-text; version=1.0.0"),
             answer.constData());
    QVERIFY(answer.endsWith("# EOF\n"));
    QVERIFY(get("HEAD /metrics").endsWith("\r\n\r\n"));
    QVERIFY(get("GET /").startsWith("HTTP/1.1 404 "));
    QVERIFY(get("POST /metrics").startsWith("HTTP/1.1 405 "));
    QVERIFY(get("nonsense").startsWith("HTTP/1.1 400 "));
}

void GatewayProgramTest::peerIsRevoked()
{
    ServedStation flight;
    QVERIFY(flight.waitForSession());
    const RunResult unknown = flight.control({QStringLiteral("revoke"), QStringLiteral("air-9")});
    QCOMPARE(unknown.status, 1);
    QVERIFY2(unknown.err.contains("air-9"), unknown.err.constData());
    QCOMPARE(flight.control({QStringLiteral("revoke"), QStringLiteral("air-1")}).status, 0);
    const QJsonObject down = flight.gateway->waitFor(QStringLiteral("session"));
    QCOMPARE(down[QLatin1String("state")].toString(), QStringLiteral("down"));
    QCOMPARE(down[QLatin1String("reason")].toString(), QStringLiteral("revoked"));
    QCOMPARE(flight.control({QStringLiteral("switch"), QStringLiteral("aes-256-gcm")}).status, 1); // no session
}

void GatewayProgramTest::socketIsOfThisUserAlone()
{
    ServedStation flight;
    QVERIFY(!flight.gateway->waitFor(QStringLiteral("link")).isEmpty());
    EVENTUALLY(QFileInfo::exists(flight.socket));
    const auto others = QFile::ReadGroup | QFile::WriteGroup | QFile::ReadOther | QFile::WriteOther;
    QVERIFY(!(QFile::permissions(flight.socket) & others));
    flight.gateway->kill(); // leaves the socket behind
    flight.startGateway();
    const auto answers = [&flight] { return flight.control({QStringLiteral("status")}).status == 0; };
    EVENTUALLY(answers());
}

void GatewayProgramTest::controlSocketReplacesNoFile()
{
    Flight flight;
    QVERIFY(flight.ready());
    const QString key = flight.path(QStringLiteral("ground.key"));
    const RunResult result = runProgram("skyseal-cli",
                                        gatewayArguments(flight, QStringLiteral("udpin:0"))
                                            + QStringList{QStringLiteral("--control"), QStringLiteral("unix:") + key});
    QCOMPARE(result.status, 3);
    QVERIFY2(result.err.contains("is not a socket"), result.err.constData());
    QVERIFY(QFileInfo(key).isFile());
}

void GatewayProgramTest::withoutAGatewayNothingAnswers()
{
    const RunResult result = runProgram(
        "skyseal-cli", {QStringLiteral("status"), QStringLiteral("--control"), QStringLiteral("unix:/nonexistent/s")});
    QCOMPARE(result.status, 3);
    QVERIFY2(result.err.contains("/nonexistent/s"), result.err.constData());
}

void GatewayProgramTest::managerHearsOfReadinessAndLife()
{
    Flight flight;
    QVERIFY(flight.ready());
    NotifySocket manager; // of the programs that start from now on
    qputenv("WATCHDOG_USEC", "2000000");
    Program gateway(QStringLiteral("skyseal-cli"), gatewayArguments(flight, QStringLiteral("udpin:0")));
    EVENTUALLY_EQUAL(manager.count("READY=1"), 1);
    EVENTUALLY(manager.count("WATCHDOG=1") >= 2);
    QCOMPARE(gateway.terminate(), 0);
    EVENTUALLY_EQUAL(manager.count("STOPPING=1"), 1);
    QCOMPARE(manager.count("READY=1"), 1);
}

/// The thread of links and sessions hangs, and the one that tells the manager runs on.
void GatewayProgramTest::managerHearsNothingWhileTheReceiverHangs()
{
    NotifySocket manager;
    qputenv("WATCHDOG_USEC", "1000000");
    const QString hang = manager.path(QStringLiteral("hang"));
    qputenv("HANG_WHEN", hang.toLocal8Bit());
    qputenv("LD_PRELOAD", SKYSEAL_HANGING_RECEIVER);
    GatewayFlight flight({QStringLiteral("udpin:0")});
    EVENTUALLY(manager.count("WATCHDOG=1") >= 2);
    qunsetenv("LD_PRELOAD");

    QFile file(hang);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QUdpSocket().writeDatagram("x", 1, QHostAddress::LocalHost, flight.flight.groundPort);
    EVENTUALLY(QFile::exists(hang + QStringLiteral(".hangs")));
    const int before = manager.count("WATCHDOG=1");
    QVERIFY(!QTest::qWaitFor([&] { return manager.count("WATCHDOG=1") > before + 1; }, 2500)); // one was on its way
    QCOMPARE(flight.control({QStringLiteral("status")}).status, 0);                            // the main thread answers
    QVERIFY(flight.gateway->running());
}

/// In order: the agent hears of it.
void GatewayProgramTest::closedTerminalEndsTheGateway()
{
    GatewayFlight flight({QStringLiteral("udpin:0")});
    flight.startAgent(loopback("udpin", flight.flight.vehiclePort));
    QVERIFY2(flight.waitForSession(), flight.gateway->errors().constData());
    QCOMPARE(::kill(static_cast<pid_t>(flight.gateway->pid()), SIGHUP), 0);
    QCOMPARE(flight.gateway->waitForExit(), 0);
    const auto isClosed = [](const QJsonObject &session) {
        return session[QLatin1String("reason")].toString() == QLatin1String("peer-closed");
    };
    QVERIFY2(!flight.air->waitFor(QStringLiteral("session"), isClosed).isEmpty(), flight.air->errors().constData());
}

/// As nohup(1) starts it.
void GatewayProgramTest::gatewayOutlivesItsTerminal()
{
    Flight flight;
    QVERIFY(flight.ready());
    Program gateway(QStringLiteral("/bin/sh"),
                    QStringList{QStringLiteral("-c"), QStringLiteral("trap '' HUP; exec \"$@\""), QStringLiteral("sh"),
                                QStringLiteral(SKYSEAL_BIN_DIR "/skyseal-cli")}
                        + gatewayArguments(flight, QStringLiteral("udpin:0")) + QStringList{QStringLiteral("--json")});
    QVERIFY2(!gateway.waitFor(QStringLiteral("stats")).isEmpty(), gateway.errors().constData());
    QCOMPARE(::kill(static_cast<pid_t>(gateway.pid()), SIGHUP), 0);
    gateway.skipReceivedEvents();
    for (int second = 0; second < 2; ++second)
        QVERIFY2(!gateway.waitFor(QStringLiteral("stats")).isEmpty(), gateway.errors().constData());
    QCOMPARE(gateway.terminate(), 0);
}

void GatewayProgramTest::takenPortEndsTheGateway()
{
    Flight flight;
    QVERIFY(flight.ready());
    Program other(QStringLiteral("skyseal-cli"), flight.monitorArguments());
    QVERIFY(other.waitUntilListening(QStringLiteral("udpin")));
    NotifySocket manager;
    const RunResult result = runProgram("skyseal-cli",
                                        gatewayArguments(flight, QStringLiteral("udpin:%1").arg(flight.groundPort)));
    QCOMPARE(result.status, 3);
    QVERIFY2(result.err.contains("udpin:127.0.0.1"), result.err.constData());
    QCOMPARE(manager.count("READY=1"), 0);
}

/// The address belongs to documentation (RFC 5737), so that nothing is opened to others.
void GatewayProgramTest::openMetricsAreWarnedOf()
{
    Flight flight;
    QVERIFY(flight.ready());
    const auto run = [&flight](const char *address) {
        return runProgram("skyseal-cli",
                          gatewayArguments(flight, QStringLiteral("udpin:0"))
                              + QStringList{QStringLiteral("--metrics"), QLatin1String(address), QStringLiteral("--duration"),
                                            QStringLiteral("0.1")});
    };
    const RunResult open = run("192.0.2.1:9464");
    QCOMPARE(open.status, 3);
    QVERIFY2(open.err.contains("192.0.2.1:9464: open to other machines"), open.err.constData());
    const RunResult own = run(":0");
    QCOMPARE(own.status, 0);
    QVERIFY2(!own.err.contains("open to other machines"), own.err.constData());
}

void GatewayProgramTest::openServiceIsWarnedOf_data()
{
    QTest::addColumn<QString>("served");
    QTest::addColumn<QByteArray>("warning"); // empty: none
    const QByteArray open = "skyseal-cli gateway: all: not sealed, and open to other machines: ";
    const QByteArray anyone = open + "anyone who reaches this address can ";
    QTest::newRow("on loopback") << QStringLiteral("udpin:0,name=all,write=all") << QByteArray();
    QTest::newRow("listens") << QStringLiteral("udpin:192.0.2.1:14550,name=all") << anyone + "see the vehicles\n";
    QTest::newRow("listens for writers") << QStringLiteral("tcpin:192.0.2.1:5760,name=all,write=mission,rc")
                                         << anyone + "see the vehicles and send (write=mission,rc)\n";
    QTest::newRow("listens for a network") << QStringLiteral("udpin:192.0.2.1:14550,name=all,write=all,from=192.0.2.0/24")
                                           << open + "others can see the vehicles and send (write=all)\n";
    QTest::newRow("sends to a host") << QStringLiteral("udpout:192.0.2.1:14550,name=all")
                                     << open + "others can see the vehicles\n";
}

/// The address belongs to documentation (RFC 5737), so that nothing is opened to others.
void GatewayProgramTest::openServiceIsWarnedOf()
{
    QFETCH(QString, served);
    QFETCH(QByteArray, warning);
    Flight flight;
    QVERIFY(flight.ready());
    const RunResult result = runProgram(
        "skyseal-cli", gatewayArguments(flight, served) + QStringList{QStringLiteral("--duration"), QStringLiteral("0.1")});
    QVERIFY2(warning.isEmpty() ? !result.err.contains("open to other machines") : result.err.startsWith(warning),
             result.err.constData());
}

/// Of the gateway and of the agent, whose stderr is the journal as far as they can tell (sd-daemon(3)).
void GatewayProgramTest::journalHasTheSeverityOfEachReport()
{
    Flight flight;
    QVERIFY(flight.ready());
    const auto start = [](const char *name, const QStringList &arguments) {
        const QString line = QStringLiteral(
            "JOURNAL_STREAM=$(stat -L -c %d:%i /proc/self/fd/2); export JOURNAL_STREAM; exec \"$@\"");
        return std::make_unique<Program>(QStringLiteral("/bin/sh"),
                                         QStringList{QStringLiteral("-c"), line, QStringLiteral("sh"),
                                                     QStringLiteral(SKYSEAL_BIN_DIR "/") + QLatin1String(name)}
                                             + arguments);
    };
    QStringList ofAgent = flight.airArguments(), ofGateway = gatewayArguments(flight, QStringLiteral("udpin:0"));
    ofAgent.removeAll(QStringLiteral("--json"));
    ofGateway.replaceInStrings(QStringLiteral("udpin:127.0.0.1:0"),
                               QStringLiteral("udpin:127.0.0.1:%1").arg(flight.groundPort));
    const auto agent = start("skyseal-air", ofAgent), gateway = start("skyseal-cli", ofGateway);
    EVENTUALLY(gateway->errors().contains("\n<6>Sealed link to air-1 at "));
    EVENTUALLY(agent->errors().contains("\n<6>Sealed link to ground at "));
    QCOMPARE(gateway->terminate(), 0);
    EVENTUALLY(agent->errors().contains("\n<4>Sealed link to ground ended: "));

    const auto again = start("skyseal-cli", ofGateway);
    EVENTUALLY(again->errors().contains("\n<6>Sealed link to air-1 at "));
    QCOMPARE(agent->terminate(), 0);
    EVENTUALLY(again->errors().contains("\n<4>Sealed link to air-1 ended: "));
    const auto third = start("skyseal-cli", ofGateway); // its port is taken
    QCOMPARE(third->waitForExit(), 3);
    QVERIFY2(third->errors().contains("<3>skyseal-cli gateway: "), third->errors().constData());
}

/// The configuration says no-record = yes.
void GatewayProgramTest::commandLineDecidesOnTheRecording()
{
    Flight flight;
    QVERIFY(flight.ready());
    QFile config(flight.path(QStringLiteral("gateway.conf")));
    QVERIFY(config.open(QIODevice::WriteOnly) && config.write("no-record = yes\n") > 0);
    config.close();
    QVERIFY(config.setPermissions(QFile::ReadOwner | QFile::WriteOwner));
    const QString folder = flight.path(QStringLiteral("logs"));
    QStringList arguments = gatewayArguments(flight, QStringLiteral("udpin:0"));
    arguments.removeAll(QStringLiteral("--no-record"));
    const RunResult result = runProgram("skyseal-cli",
                                        arguments
                                            + QStringList{QStringLiteral("--config"), config.fileName(),
                                                          QStringLiteral("--record"), folder, QStringLiteral("--duration"),
                                                          QStringLiteral("0.1")});
    QVERIFY2(result.status == 0, result.err.constData());
    QVERIFY2(result.err.contains("recording to " + folder.toUtf8()), result.err.constData());
}

void GatewayProgramTest::recordingHoldsTheFlight()
{
    Flight flight;
    QVERIFY(flight.ready());
    QStringList arguments = gatewayArguments(flight, QStringLiteral("udpin:0"));
    arguments.removeAll(QStringLiteral("--no-record"));
    arguments.replaceInStrings(QStringLiteral("udpin:127.0.0.1:0"),
                               QStringLiteral("udpin:127.0.0.1:%1").arg(flight.groundPort));
    const QDir folder(flight.path(QStringLiteral("logs")));
    Program gateway(QStringLiteral("skyseal-cli"),
                    arguments << QStringLiteral("--json") << QStringLiteral("--record") << folder.path());
    Program agent(QStringLiteral("skyseal-air"), flight.airArguments());
    Program vehicle(QStringLiteral("skyseal-sim"), flight.simArguments());
    QVERIFY2(!gateway.waitFor(QStringLiteral("vehicle")).isEmpty(), gateway.errors().constData());
    QCOMPARE(gateway.terminate(), 0);

    const QStringList recordings = folder.entryList({QStringLiteral("*.tlog")});
    QCOMPARE(recordings.size(), 1);
    const RunResult info = runProgram(
        "skyseal-cli",
        {QStringLiteral("log"), QStringLiteral("info"), QStringLiteral("--json"), folder.filePath(recordings.front())});
    const QJsonObject content = QJsonDocument::fromJson(info.out).object();
    QVERIFY2(content[QLatin1String("sound")].toBool(), info.out.constData());
    QVERIFY(content[QLatin1String("messages")][QLatin1String("HEARTBEAT")].toInt() > 0);
}

SKYSEAL_TEST(GatewayProgramTest)
#include "gateway_program_test.moc"
