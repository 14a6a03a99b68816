// A PX4 vehicle behind skyseal-air is flown by script: modes by its names, take-off above sea level, integers as bytes.
#include "tests/support/flight.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonArray>
#include <QtCore/QSet>
#include <QtTest/QTest>

using namespace skyseal::test;

class Px4FlightTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesOffAndLands();
};

void Px4FlightTest::takesOffAndLands()
{
    Flight flight;
    QVERIFY(flight.ready());
    Program sim(QStringLiteral("skyseal-sim"),
                flight.simArguments(
                    {QStringLiteral("--autopilot"), QStringLiteral("px4"), QStringLiteral("--rate"), QStringLiteral("4")}));
    Program air(QStringLiteral("skyseal-air"), flight.airArguments());
    Program monitor(QStringLiteral("skyseal-cli"),
                    flight.monitorArguments({QStringLiteral("--switch-to"), allSuites(), QStringLiteral("--switch-every"),
                                             QStringLiteral("1"), QStringLiteral("--do"),
                                             QStringLiteral("wait gps_fix>=3 60; wait ekf_ok==1 60; mode POSCTL; mode LOITER; "
                                                            "param NAV_DLL_ACT 1; arm; takeoff 10; wait alt_rel>=9 60; land; "
                                                            "wait armed==0 90")}));
    QVERIFY2(monitor.waitForExit(2 * kDeadlineMs) == 0, monitor.errors().constData());
    QCOMPARE(monitor.events(QStringLiteral("vehicle")).front()[QLatin1String("autopilot")].toInt(), 12); // MAV_AUTOPILOT_PX4
    const auto steps = monitor.events(QStringLiteral("command"));
    QCOMPARE(steps.size(), std::size_t(10));
    for (const QJsonObject &step : steps) {
        const QString result = step[QLatin1String("result")].toString();
        QVERIFY2(result == QLatin1String("accepted") || result == QLatin1String("reached"), qPrintable(result));
    }
    QSet<QString> modes;
    for (const QJsonObject &stats : monitor.events(QStringLiteral("stats"))) {
        for (const QJsonValue &vehicle : stats[QLatin1String("vehicles")].toArray())
            modes.insert(vehicle[QLatin1String("mode")].toString());
    }
    QVERIFY2(modes.contains(QStringLiteral("LAND")), qPrintable(QStringList(modes.values()).join(QLatin1Char(' '))));
}

SKYSEAL_TEST(Px4FlightTest)
#include "px4_flight_test.moc"
