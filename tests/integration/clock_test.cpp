// The time of day jumps by ten years, in flight and back before a handshake, without any effect.
#include "tests/support/flight.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal::test;

class ClockTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void tenYearsInFlight();
    void tenYearsBackBeforeAHandshake();
};

namespace {

constexpr qint64 kTenYears = 10LL * 365 * 24 * 3600;

/// To be started by env, with a clock that is wrong by so much from so many seconds on.
QStringList shifted(const QString &program, const QStringList &arguments, qint64 by, int after)
{
    return QStringList{QStringLiteral("LD_PRELOAD=" SKYSEAL_CLOCK_SHIFT), QStringLiteral("CLOCK_SHIFT=%1").arg(by),
                       QStringLiteral("CLOCK_SHIFT_AFTER=%1").arg(after), QStringLiteral(SKYSEAL_BIN_DIR "/") + program}
    + arguments;
}

const QString kEnv(QStringLiteral("/usr/bin/env"));

qint64 lost(const QJsonObject &stats)
{
    return stats[QLatin1String("channel")][QLatin1String("rx")][QLatin1String("lost")].toInteger();
}

} // namespace

void ClockTest::initTestCase()
{
    // The shift works at all.
    Program date(kEnv,
                 {QStringLiteral("LD_PRELOAD=" SKYSEAL_CLOCK_SHIFT), QStringLiteral("CLOCK_SHIFT=%1").arg(kTenYears),
                  QStringLiteral("/bin/date"), QStringLiteral("+{\"event\":\"date\",\"now\":%s}")});
    const qint64 then = date.waitFor(QStringLiteral("date"))[QLatin1String("now")].toInteger();
    QVERIFY(qAbs(then - QDateTime::currentSecsSinceEpoch() - kTenYears) < 60);
}

void ClockTest::tenYearsInFlight()
{
    Flight flight;
    QVERIFY(flight.ready());
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    Program air(kEnv, shifted(QStringLiteral("skyseal-air"), flight.airArguments(), kTenYears, 3));
    Program monitor(kEnv,
                    shifted(QStringLiteral("skyseal-cli"),
                            flight.monitorArguments({QStringLiteral("--do"), QStringLiteral("sleep 7; mode GUIDED")}),
                            -kTenYears, 5));
    QVERIFY2(!monitor.waitFor(QStringLiteral("session")).isEmpty(), monitor.errors().constData());
    // After both steps, commands are as fresh as before.
    const QJsonObject mode = monitor.waitFor(QStringLiteral("command"), [](const QJsonObject &command) {
        return command[QLatin1String("step")].toString().startsWith(QLatin1String("mode"));
    });
    QVERIFY2(mode[QLatin1String("result")] == QLatin1String("accepted"), monitor.errors().constData());
    const QJsonObject stats = monitor.last(QStringLiteral("stats"));
    QCOMPARE(monitor.events(QStringLiteral("session")).size(), std::size_t(1));
    QCOMPARE(lost(stats), 0);
    QVERIFY(stats[QLatin1String("mavlink")][QLatin1String("frames")].toInteger() > 50);
    QVERIFY(monitor.events(QStringLiteral("commands_late")).empty());
    QVERIFY(air.events(QStringLiteral("frames_refused")).empty());
}

void ClockTest::tenYearsBackBeforeAHandshake()
{
    Flight flight;
    QVERIFY(flight.ready());
    const qint64 since1970 = QDateTime::currentSecsSinceEpoch(); // an agent without a battery for its clock
    for (const qint64 by : {kTenYears, -kTenYears, since1970, qint64(0)}) {
        Program air(kEnv, shifted(QStringLiteral("skyseal-air"), flight.airArguments(), -by, 0));
        Program monitor(kEnv, shifted(QStringLiteral("skyseal-cli"), flight.monitorArguments(), by, 0));
        const QJsonObject session = monitor.waitFor(QStringLiteral("session"));
        QVERIFY2(session[QLatin1String("state")].toString() == QLatin1String("up"), monitor.errors().constData());
    }
}

SKYSEAL_TEST(ClockTest)
#include "clock_test.moc"
