// MAVProxy, a ground station that we did not write, through the gateway to the simulated vehicle and to an ArduCopter: it reads
// and sets parameters, transfers a mission up and down and flies while the cipher is switched every two seconds. A second one,
// which may only read, sees the whole flight, and commands nothing.
//
// SKYSEAL_MAVPROXY names mavproxy.py, which python3 must be able to run; without it the test is skipped. README.md, "With
// ArduPilot SITL", says how to get it from its sources. Without ARDUPILOT_SITL (see Sitl) the rows of ArduCopter are skipped.
#include "tests/support/eventually.h"
#include "tests/support/gateway_flight.h"
#include "tests/support/sitl.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtCore/QProcess>
#include <QtCore/QRegularExpression>
#include <QtCore/QTimer>
#include <QtTest/QTest>

#include <cmath>

using namespace skyseal::test;

namespace {

/// MAVProxy with its console on pipes.
class MavProxy
{
public:
    /// `gateway`: its TCP port.
    explicit MavProxy(quint16 gateway, const QStringList &options = {})
    {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("HOME"), m_home.path()); // its settings and logs
        m_process.setProcessEnvironment(environment);
        m_process.setProcessChannelMode(QProcess::MergedChannels);
        m_process.setWorkingDirectory(m_home.path());
        // Without its terrain module, which downloads heights for an ArduCopter and hangs where it cannot.
        const QStringList arguments{qEnvironmentVariable("SKYSEAL_MAVPROXY"), QStringLiteral("--dialect=ardupilotmega"),
                                    QStringLiteral("--default-modules=log,wp,rally,fence,ftp,param,arm,mode,rc,misc,cmdlong"),
                                    QStringLiteral("--master=tcp:127.0.0.1:%1").arg(gateway)};
        m_process.start(QStringLiteral("python3"), arguments + options);
    }
    ~MavProxy()
    {
        m_process.kill();
        m_process.waitForFinished(kDeadlineMs);
    }
    MavProxy(const MavProxy &) = delete;
    MavProxy &operator=(const MavProxy &) = delete;

    void type(const QByteArray &command) { m_process.write(command + '\n'); }
    /// Waits for a text behind the one that was found last; longer than other tests, since MAVProxy tries some ways in turn.
    bool says(const QByteArray &text)
    {
        const auto isSaid = [&] {
            m_said += m_process.readAll();
            const qsizetype found = m_said.indexOf(text, m_found);
            if (found >= 0)
                m_found = found + text.size();
            return found >= 0;
        };
        return QTest::qWaitFor(isSaid, 3 * kDeadlineMs);
    }
    /// Types a command until its outcome is said: a vehicle may not be ready for it.
    bool achieves(const QByteArray &command, const QByteArray &outcome)
    {
        QTimer again;
        QObject::connect(&again, &QTimer::timeout, &again, [&] { type(command); });
        again.start(2000);
        type(command);
        return says(outcome);
    }
    /// Everything so far.
    QByteArray said() const { return m_said; }
    /// Its newest words, for a report.
    QByteArray words() const { return m_said.right(2000); }
    /// Its account of the link: packets and lost packets.
    bool hasLostNothing()
    {
        type("link");
        const bool lostNothing = says(" 0 lost, 0.0% loss");
        const auto account =
            QRegularExpression(QStringLiteral("\\d+ packets[^\n]*")).globalMatch(QString::fromUtf8(m_said.right(500)));
        for (auto next = account; next.hasNext();)
            qInfo("MAVProxy: %s", qPrintable(next.next().captured()));
        return lostNothing;
    }
    QString path(const char *name) const { return m_home.filePath(QLatin1String(name)); }

private:
    QTemporaryDir m_home;
    QProcess m_process;
    QByteArray m_said;
    qsizetype m_found = 0;
};

constexpr const char *kMission = "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t-35.363261\t149.165230\t584\t1\n"
                                 "1\t0\t3\t22\t0\t0\t0\t0\t-35.363261\t149.165230\t20\t1\n"
                                 "2\t0\t3\t16\t0\t0\t0\t0\t-35.362000\t149.165300\t20\t1\n";
constexpr const char *kFence = "QGC WPL 110\n0\t0\t0\t5001\t3\t0\t0\t0\t-35.365\t149.163\t0\t1\n"
                               "1\t0\t0\t5001\t3\t0\t0\t0\t-35.361\t149.163\t0\t1\n"
                               "2\t0\t0\t5001\t3\t0\t0\t0\t-35.361\t149.168\t0\t1\n";
constexpr const char *kRallyPoints = "QGC WPL 110\n0\t0\t3\t5100\t0\t0\t0\t0\t-35.363\t149.166\t25\t1\n";

/// Returns the path.
QByteArray write(const QString &path, const char *content)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) <= 0)
        qFatal("cannot write %s", qPrintable(path));
    return path.toUtf8();
}

/// Switches the suites of a gateway in turn, every two seconds.
class Switching
{
public:
    explicit Switching(const GatewayFlight &flight)
    {
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this, &flight] {
            const QString suite = GatewayFlight::suites()[switched++ % GatewayFlight::suites().size()];
            const RunResult result = flight.control({QStringLiteral("switch"), suite});
            if (result.status != 0) {
                ++failed;
                qWarning("%s: %s", qPrintable(suite), (result.out + result.err).constData());
            }
        });
        m_timer.start(2000);
    }
    int switched = 0, failed = 0;

private:
    QTimer m_timer;
};

/// The items of a plan file behind its first one, which is home: command, frame, parameters, position.
std::vector<std::vector<double>> itemsOf(const QByteArray &plan)
{
    std::vector<std::vector<double>> out;
    const QByteArrayList lines = plan.trimmed().split('\n').mid(2);
    for (const QByteArray &line : lines) {
        const QByteArrayList fields = line.simplified().split(' ');
        std::vector<double> item;
        for (const int column : {2, 3, 4, 5, 6, 7, 8, 9, 10})
            item.push_back(std::round(fields.value(column).toDouble() * 1e6) / 1e6);
        out.push_back(item);
    }
    return out;
}

QByteArray savedPlan(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class MavproxyTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void pilotFliesWhileCiphersSwitch_data() { vehicles(); }
    void pilotFliesWhileCiphersSwitch();
    void simulatedVehicleHasFenceRallyPointsAndVersion();
    void readerCommandsNothing_data() { vehicles(); }
    void readerCommandsNothing();

private:
    static void vehicles()
    {
        QTest::addColumn<bool>("isArduCopter");
        QTest::newRow("simulated vehicle") << false;
        QTest::newRow("ArduCopter") << true;
    }
    /// The vehicle of this row, behind an agent that is connected to the gateway. Returns false if it is missing.
    bool start(GatewayFlight &flight)
    {
        QFETCH(bool, isArduCopter);
        if (isArduCopter) {
            const quint16 port = freeTcpPort();
            m_autopilot = m_sitl.start(port, 2);
            flight.startAgent(QStringLiteral("tcp:127.0.0.1:%1").arg(port));
        } else {
            flight.startSimulatedVehicle();
        }
        return flight.waitForSession();
    }

    Sitl m_sitl;
    std::unique_ptr<Program> m_autopilot;
};

void MavproxyTest::initTestCase()
{
    SKYSEAL_REQUIRES("mavproxy");
}

/// A second MAVProxy, which may only read, sees the flight of the first.
void MavproxyTest::pilotFliesWhileCiphersSwitch()
{
    QFETCH(bool, isArduCopter);
    if (isArduCopter)
        SKYSEAL_REQUIRES("arducopter");
    const quint16 port = freeTcpPort(), readerPort = freeTcpPort();
    GatewayFlight flight({QStringLiteral("tcpin:%1,write=all").arg(port), QStringLiteral("tcpin:%1").arg(readerPort)});
    QVERIFY(start(flight));
    MavProxy pilot(port), reader(readerPort, {QStringLiteral("--streamrate=-1")}); // the rates are the pilot's
    Switching switching(flight);
    QVERIFY2(pilot.says("Received ") && pilot.says(" parameters"), pilot.words().constData());
    QVERIFY2(reader.says("Received ") && reader.says(" parameters"), reader.words().constData());
    pilot.type("param set WPNAV_SPEED 600");
    QVERIFY2(pilot.achieves("param show WPNAV_SPEED", "WPNAV_SPEED      600.0"), pilot.words().constData());

    pilot.type("wp load " + write(pilot.path("flight.txt"), kMission));
    QVERIFY2(pilot.says("Sent all 3 waypoints") && pilot.says("TYPE_MISSION: ACCEPTED"), pilot.words().constData());
    pilot.type("wp save " + pilot.path("down.txt").toUtf8());
    QVERIFY2(pilot.says("Saved 3 waypoints"), pilot.words().constData());
    QCOMPARE(itemsOf(savedPlan(pilot.path("down.txt"))), itemsOf(kMission));
    reader.type("wp save " + reader.path("down.txt").toUtf8());
    QVERIFY2(reader.says("Saved 3 waypoints"), reader.words().constData());
    QCOMPARE(itemsOf(savedPlan(reader.path("down.txt"))), itemsOf(kMission));

    QVERIFY2(pilot.achieves("mode GUIDED", "Mode GUIDED"), pilot.words().constData());
    QVERIFY2(pilot.achieves("arm throttle", "ARMED"), pilot.words().constData());
    QVERIFY2(pilot.achieves("takeoff 12", "NAV_TAKEOFF: ACCEPTED"), pilot.words().constData());
    QVERIFY2(pilot.says("height "), pilot.words().constData());
    QVERIFY2(pilot.achieves("mode LAND", "Mode LAND"), pilot.words().constData());
    QVERIFY2(pilot.says("DISARMED"), pilot.words().constData());
    for (const char *step : {"Mode GUIDED", "ARMED", "height ", "Mode LAND", "DISARMED"})
        QVERIFY2(reader.says(step), reader.words().constData());
    QVERIFY2(pilot.hasLostNothing(), pilot.words().constData());
    QVERIFY2(reader.hasLostNothing(), reader.words().constData());
    QVERIFY(switching.switched > 5);
    QCOMPARE(switching.failed, 0);
    const QJsonObject received =
        flight.gateway->last(QStringLiteral("stats"))[QLatin1String("channel")][QLatin1String("rx")].toObject();
    qInfo("%d switches; of the records of the agent %d good, %d lost", switching.switched,
          received[QLatin1String("good")].toInt(), received[QLatin1String("lost")].toInt(-1));
    QCOMPARE(received[QLatin1String("lost")].toInt(-1), 0);
}

void MavproxyTest::simulatedVehicleHasFenceRallyPointsAndVersion()
{
    const quint16 port = freeTcpPort();
    GatewayFlight flight({QStringLiteral("tcpin:%1,write=all").arg(port)});
    flight.startSimulatedVehicle();
    QVERIFY(flight.waitForSession());
    MavProxy pilot(port);
    QVERIFY2(pilot.says("Received ") && pilot.says(" parameters"), pilot.words().constData());
    pilot.type("fence load " + write(pilot.path("fence.txt"), kFence));
    QVERIFY2(pilot.says("Sent all 3 fence items"), pilot.words().constData());
    pilot.type("fence list");
    QVERIFY2(pilot.says("5001 0 -35.3650000000 149.1630000000"), pilot.words().constData());
    pilot.type("rally load " + write(pilot.path("rally.txt"), kRallyPoints));
    QVERIFY2(pilot.says("Sent all 1 rally items"), pilot.words().constData());
    pilot.type("rally list");
    QVERIFY2(pilot.says("5100 3 -35.3630000000 149.1660000000 25.000000"), pilot.words().constData());
    pilot.type("version");
    QVERIFY2(pilot.says("REQUEST_MESSAGE: ACCEPTED"), pilot.words().constData());
    QVERIFY2(pilot.achieves("status AUTOPILOT_VERSION", "AUTOPILOT_VERSION {"), pilot.words().constData());
    QVERIFY2(!pilot.said().toLower().contains("fence breach"), pilot.words().constData());
}

void MavproxyTest::readerCommandsNothing()
{
    QFETCH(bool, isArduCopter);
    if (isArduCopter)
        SKYSEAL_REQUIRES("arducopter");
    const quint16 port = freeTcpPort();
    GatewayFlight flight({QStringLiteral("tcpin:%1").arg(port)});
    QVERIFY(start(flight));
    MavProxy reader(port);
    QVERIFY2(reader.says("Received ") && reader.says(" parameters"), reader.words().constData());
    reader.type("wp list");
    QVERIFY2(reader.says("Requesting 0 waypoints"), reader.words().constData());
    if (!isArduCopter) { // ArduCopter 3.6.7 knows none of these by the messages that MAVProxy uses
        reader.type("fence list");
        QVERIFY2(reader.says("Requesting 0 fence items"), reader.words().constData());
        reader.type("rally list");
        QVERIFY2(reader.says("Requesting 0 rally items"), reader.words().constData());
        reader.type("version");
        QVERIFY2(reader.achieves("status AUTOPILOT_VERSION", "AUTOPILOT_VERSION {"), reader.words().constData());
    }
    for (const char *message : {"HEARTBEAT", "ATTITUDE", "GLOBAL_POSITION_INT", "SYS_STATUS", "GPS_RAW_INT"})
        QVERIFY2(reader.achieves(QByteArray("status ") + message, QByteArray(message) + " {"), reader.words().constData());
    reader.type("mode GUIDED");
    QVERIFY2(reader.says("DO_SET_MODE: DENIED"), reader.words().constData());
    reader.type("arm throttle force");
    QVERIFY2(reader.says("COMPONENT_ARM_DISARM: DENIED"), reader.words().constData());
    reader.type("param set WPNAV_SPEED 300");
    QVERIFY2(reader.says("Failed to set WPNAV_SPEED"), reader.words().constData());
    reader.type("wp load " + write(reader.path("flight.txt"), kMission));
    reader.type("wp list");
    QVERIFY2(reader.says("Requesting 0 waypoints"), reader.words().constData());
    QVERIFY(flight.gateway->last(QStringLiteral("stats"))[QLatin1String("vehicles")][0][QLatin1String("armed")] == false);
    QVERIFY(!flight.gateway->events(QStringLiteral("client_denied")).empty());
}

SKYSEAL_TEST(MavproxyTest)
#include "mavproxy_test.moc"
