// kill -9 of each of the three programs in flight: the session returns with the program, and the others run on. The time
// that this takes by the protocol is tested on the simulated clock: SessionTest::agentRestarts and stationRestarts.
#include "tests/support/flight.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonArray>
#include <QtTest/QTest>

#include <memory>

using namespace skyseal::test;

class RecoveryTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();
    void agentKilled();
    void stationKilled();
    void simulatorKilled();

private:
    std::unique_ptr<Program> start(const char *name) const;
    void expectTelemetry(Program &monitor) const;

    std::unique_ptr<Flight> m_flight;
    std::unique_ptr<Program> m_sim, m_air, m_monitor;
};

std::unique_ptr<Program> RecoveryTest::start(const char *name) const
{
    const QString program = QLatin1String(name);
    if (program == QLatin1String("skyseal-sim"))
        return std::make_unique<Program>(program, m_flight->simArguments());
    if (program == QLatin1String("skyseal-air"))
        return std::make_unique<Program>(program, m_flight->airArguments());
    return std::make_unique<Program>(program, m_flight->monitorArguments());
}

/// Waits for a report with a heartbeat of the vehicle that is not older than the report's interval.
void RecoveryTest::expectTelemetry(Program &monitor) const
{
    const auto fresh = [](const QJsonObject &stats) {
        const QJsonArray vehicles = stats[QLatin1String("vehicles")].toArray();
        return !vehicles.isEmpty() && vehicles[0][QLatin1String("heartbeat_age")].toDouble(99) < 1.2;
    };
    QVERIFY(!monitor.waitFor(QStringLiteral("stats"), fresh).isEmpty());
}

void RecoveryTest::init()
{
    m_flight = std::make_unique<Flight>();
    QVERIFY(m_flight->ready());
    m_sim = start("skyseal-sim");
    m_air = start("skyseal-air");
    m_monitor = start("skyseal-cli");
    QVERIFY2(!m_monitor->waitFor(QStringLiteral("session")).isEmpty(), m_monitor->errors().constData());
    expectTelemetry(*m_monitor);
}

void RecoveryTest::cleanup()
{
    m_monitor.reset();
    m_air.reset();
    m_sim.reset();
}

void RecoveryTest::agentKilled()
{
    m_air->kill();
    m_air = start("skyseal-air");
    QVERIFY(!m_air->waitFor(QStringLiteral("link")).isEmpty());
    const auto up = [](const QJsonObject &event) { return event[QLatin1String("state")].toString() == QLatin1String("up"); };
    QVERIFY(!m_monitor->waitFor(QStringLiteral("session"), up).isEmpty());
    expectTelemetry(*m_monitor);
    QVERIFY(m_sim->running());
}

void RecoveryTest::stationKilled()
{
    m_monitor->kill();
    m_monitor = start("skyseal-cli");
    QVERIFY(!m_monitor->waitFor(QStringLiteral("link")).isEmpty());
    QVERIFY(!m_monitor->waitFor(QStringLiteral("session")).isEmpty());
    expectTelemetry(*m_monitor);
    QVERIFY(m_air->running() && m_sim->running());
}

void RecoveryTest::simulatorKilled()
{
    m_sim->kill();
    m_sim = start("skyseal-sim");
    // A session needs no vehicle: it must have stayed, and the new vehicle's telemetry flows through it.
    const std::size_t sessions = m_monitor->events(QStringLiteral("session")).size();
    const auto gap = [](const QJsonObject &stats) { return !stats[QLatin1String("vehicles")].toArray().isEmpty(); };
    QVERIFY(!m_monitor->waitFor(QStringLiteral("stats"), gap).isEmpty());
    expectTelemetry(*m_monitor);
    QCOMPARE(m_monitor->events(QStringLiteral("session")).size(), sessions);
    QVERIFY(m_air->running());
}

SKYSEAL_TEST(RecoveryTest)
#include "recovery_test.moc"
