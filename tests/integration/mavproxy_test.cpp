// MAVProxy, a ground station that we did not write, through the gateway: it reads parameters, transfers a mission and flies
// while the cipher is switched every two seconds; one that may only read sees everything and commands nothing.
//
// SKYSEAL_MAVPROXY names mavproxy.py, which python3 must be able to run; without it the test is skipped.
#include "tests/support/eventually.h"
#include "tests/support/gateway_flight.h"
#include "tests/support/test_runner.h"

#include <QtCore/QProcess>
#include <QtCore/QTimer>
#include <QtTest/QTest>

using namespace skyseal::test;

namespace {

/// MAVProxy with its console on pipes.
class MavProxy
{
public:
    explicit MavProxy(quint16 gateway)
    {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("HOME"), m_home.path()); // its settings and logs
        m_process.setProcessEnvironment(environment);
        m_process.setProcessChannelMode(QProcess::MergedChannels);
        m_process.setWorkingDirectory(m_home.path());
        m_process.start(QStringLiteral("python3"),
                        {qEnvironmentVariable("SKYSEAL_MAVPROXY"), QStringLiteral("--dialect=ardupilotmega"),
                         QStringLiteral("--master=tcp:127.0.0.1:%1").arg(gateway)});
    }
    ~MavProxy()
    {
        m_process.kill();
        m_process.waitForFinished();
    }
    MavProxy(const MavProxy &) = delete;
    MavProxy &operator=(const MavProxy &) = delete;

    void type(const QByteArray &command) { m_process.write(command + '\n'); }
    /// Waits for a text behind the one that was found last.
    bool says(const QByteArray &text)
    {
        return eventually([&] {
            m_said += m_process.readAll();
            const qsizetype found = m_said.indexOf(text, m_found);
            if (found >= 0)
                m_found = found + text.size();
            return found >= 0;
        });
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
    QByteArray said() const { return m_said; }
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
            const QStringList suites = GatewayFlight::suites();
            failed += flight.control({QStringLiteral("switch"), suites[switched++ % suites.size()]}).status != 0;
        });
        m_timer.start(2000);
    }
    int switched = 0, failed = 0;

private:
    QTimer m_timer;
};

} // namespace

class MavproxyTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void pilotFliesWhileCiphersSwitch();
    void readerSeesEverythingAndCommandsNothing();
};

void MavproxyTest::initTestCase()
{
    if (!qEnvironmentVariableIsSet("SKYSEAL_MAVPROXY"))
        QSKIP("SKYSEAL_MAVPROXY names no MAVProxy");
}

void MavproxyTest::pilotFliesWhileCiphersSwitch()
{
    const quint16 port = freeTcpPort();
    GatewayFlight flight({QStringLiteral("tcpin:%1,write=all").arg(port)});
    flight.startSimulatedVehicle();
    QVERIFY(flight.waitForSession());
    MavProxy pilot(port);
    const auto said = [&pilot] { return pilot.said().right(2000); };
    Switching switching(flight);
    QVERIFY2(pilot.says("Received ") && pilot.says(" parameters"), said().constData());
    pilot.type("param set WPNAV_SPEED 600");
    QVERIFY2(pilot.achieves("param show WPNAV_SPEED", "WPNAV_SPEED      600.0"), said().constData());

    pilot.type("wp load " + write(pilot.path("flight.txt"), kMission));
    QVERIFY2(pilot.says("Sent all 3 waypoints") && pilot.says("TYPE_MISSION: ACCEPTED"), said().constData());
    pilot.type("wp list");
    QVERIFY2(pilot.says("16 3 -35.3620000000 149.1653000000 20.000000"), said().constData());
    pilot.type("fence load " + write(pilot.path("fence.txt"), kFence));
    QVERIFY2(pilot.says("Sent all 3 fence items"), said().constData());
    pilot.type("fence list");
    QVERIFY2(pilot.says("5001 0 -35.3650000000 149.1630000000"), said().constData());
    pilot.type("rally load " + write(pilot.path("rally.txt"), kRallyPoints));
    QVERIFY2(pilot.says("Sent all 1 rally items"), said().constData());
    pilot.type("rally list");
    QVERIFY2(pilot.says("5100 3 -35.3630000000 149.1660000000 25.000000"), said().constData());
    pilot.type("version");
    QVERIFY2(pilot.says("REQUEST_MESSAGE: ACCEPTED"), said().constData());
    QVERIFY2(pilot.achieves("status AUTOPILOT_VERSION", "AUTOPILOT_VERSION {"), said().constData());
    QVERIFY2(!pilot.said().toLower().contains("fence breach"), said().constData());

    QVERIFY2(pilot.achieves("mode GUIDED", "Mode GUIDED"), said().constData());
    QVERIFY2(pilot.achieves("arm throttle", "ARMED"), said().constData());
    QVERIFY2(pilot.achieves("takeoff 10", "NAV_TAKEOFF: ACCEPTED"), said().constData());
    QVERIFY2(pilot.says("height "), said().constData());
    QVERIFY2(pilot.achieves("mode LAND", "Mode LAND"), said().constData());
    QVERIFY2(pilot.says("DISARMED"), said().constData());
    pilot.type("link");
    QVERIFY2(pilot.says(" 0 lost, 0.0% loss"), said().constData());
    QVERIFY(switching.switched > 5);
    QCOMPARE(switching.failed, 0);
}

void MavproxyTest::readerSeesEverythingAndCommandsNothing()
{
    const quint16 port = freeTcpPort();
    GatewayFlight flight({QStringLiteral("tcpin:%1").arg(port)});
    flight.startSimulatedVehicle();
    QVERIFY(flight.waitForSession());
    MavProxy reader(port);
    const auto said = [&reader] { return reader.said().right(2000); };
    QVERIFY2(reader.says("Received ") && reader.says(" parameters"), said().constData());
    reader.type("wp list");
    QVERIFY2(reader.says("Requesting 0 waypoints"), said().constData());
    reader.type("fence list");
    QVERIFY2(reader.says("Requesting 0 fence items"), said().constData());
    reader.type("rally list");
    QVERIFY2(reader.says("Requesting 0 rally items"), said().constData());
    reader.type("version");
    QVERIFY2(reader.achieves("status AUTOPILOT_VERSION", "AUTOPILOT_VERSION {"), said().constData());
    reader.type("mode GUIDED");
    QVERIFY2(reader.says("DO_SET_MODE: DENIED"), said().constData());
    reader.type("arm throttle force");
    QVERIFY2(reader.says("COMPONENT_ARM_DISARM: DENIED"), said().constData());
    reader.type("param set WPNAV_SPEED 300");
    QVERIFY2(reader.says("Failed to set WPNAV_SPEED"), said().constData());
    QVERIFY(flight.gateway->last(QStringLiteral("stats"))[QLatin1String("vehicles")][0][QLatin1String("armed")] == false);
    QVERIFY(!flight.gateway->events(QStringLiteral("client_denied")).empty());
}

SKYSEAL_TEST(MavproxyTest)
#include "mavproxy_test.moc"
