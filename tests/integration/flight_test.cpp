// A whole flight by script through the sealed link, switching ciphers on the way.
#include "tests/support/flight.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFileInfo>
#include <QtTest/QTest>

using namespace skyseal::test;

class FlightTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesOffAndLands();
    void refusedStepEndsTheScript();
};

void FlightTest::takesOffAndLands()
{
    Flight flight;
    QVERIFY(flight.ready());
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments({QStringLiteral("--rate"), QStringLiteral("4")}));
    Program air(QStringLiteral("skyseal-air"), flight.airArguments());
    Program monitor(
        QStringLiteral("skyseal-cli"),
        flight.monitorArguments({QStringLiteral("--switch-to"), allSuites(), QStringLiteral("--switch-every"),
                                 QStringLiteral("2"), QStringLiteral("--do"),
                                 QStringLiteral("wait ekf_ok==1 60; mode GUIDED; arm; takeoff 10; wait alt_rel>=9.5 60; land; "
                                                "wait armed==0 90")}));
    QCOMPARE(monitor.waitForExit(2 * kDeadlineMs), 0);
    const auto steps = monitor.events(QStringLiteral("command"));
    QCOMPARE(steps.size(), std::size_t(7));
    for (const QJsonObject &step : steps) {
        const QString result = step[QLatin1String("result")].toString();
        QVERIFY2(result == QLatin1String("accepted") || result == QLatin1String("reached"), qPrintable(result));
    }
    QVERIFY(monitor.events(QStringLiteral("switch")).size() >= 3);
}

void FlightTest::refusedStepEndsTheScript()
{
    Flight flight;
    QVERIFY(flight.ready());
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    Program air(QStringLiteral("skyseal-air"), flight.airArguments());
    Program monitor(QStringLiteral("skyseal-cli"),
                    flight.monitorArguments({QStringLiteral("--do"), QStringLiteral("takeoff 10; land")}));
    QCOMPARE(monitor.waitForExit(), 1);
    const auto steps = monitor.events(QStringLiteral("command"));
    QCOMPARE(steps.size(), std::size_t(1));
    QCOMPARE(steps[0][QLatin1String("result")].toString(), QStringLiteral("refused"));
    QVERIFY(!steps[0][QLatin1String("reason")].toString().isEmpty());
}

SKYSEAL_TEST(FlightTest)
#include "flight_test.moc"
