// Plain MAVLink is the baseline of measurements: it passes only if both ends allow it.
#include "tests/support/flight.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonArray>
#include <QtTest/QTest>

using namespace skyseal::test;

class PlainBaselineTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void needsConsentOfBothEnds_data();
    void needsConsentOfBothEnds();
};

void PlainBaselineTest::needsConsentOfBothEnds_data()
{
    QTest::addColumn<bool>("agent");
    QTest::addColumn<bool>("station");
    QTest::newRow("both") << true << true;
    QTest::newRow("agent only") << true << false;
    QTest::newRow("station only") << false << true;
}

void PlainBaselineTest::needsConsentOfBothEnds()
{
    QFETCH(bool, agent);
    QFETCH(bool, station);
    Flight flight;
    QVERIFY(flight.ready());
    // The station that does not consent has no key of this agent: no session comes up that would hide the clear frames.
    QStringList monitorArguments{QStringLiteral("monitor"),
                                 QStringLiteral("--link"),
                                 QStringLiteral("udpin:127.0.0.1:%1").arg(flight.groundPort),
                                 QStringLiteral("--secure"),
                                 station ? QStringLiteral("off") : QStringLiteral("required"),
                                 QStringLiteral("--json")};
    if (!station)
        monitorArguments << QStringLiteral("--identity") << flight.path(QStringLiteral("ground.key"))
                         << QStringLiteral("--peers") << flight.path(QStringLiteral("air.peers"));
    Program monitor(QStringLiteral("skyseal-cli"), monitorArguments);
    QVERIFY2(!monitor.waitFor(QStringLiteral("link")).isEmpty(), monitor.errors().constData());
    Program air(QStringLiteral("skyseal-air"),
                flight.airArguments(0, agent ? QStringList{QStringLiteral("--allow-plain")} : QStringList()));
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());

    if (agent && station) {
        QVERIFY(!monitor.waitFor(QStringLiteral("vehicle")).isEmpty());
    } else {
        // The agent has the vehicle's heartbeat, several seconds long, and still nothing shows.
        for (int second = 0; second < 4; ++second)
            QVERIFY(!monitor.waitFor(QStringLiteral("stats")).isEmpty());
        QVERIFY(monitor.events(QStringLiteral("vehicle")).empty());
        QVERIFY(monitor.last(QStringLiteral("stats"))[QLatin1String("vehicles")].toArray().isEmpty());
    }
    QVERIFY(monitor.events(QStringLiteral("session")).empty());
}

SKYSEAL_TEST(PlainBaselineTest)
#include "plain_baseline_test.moc"
