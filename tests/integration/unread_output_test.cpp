// An agent whose output is not read: a full pipe must not stop the link.
#include "tests/support/flight.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal::test;

class UnreadOutputTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void linkGoesOn();
};

void UnreadOutputTest::linkGoesOn()
{
    Flight flight;
    QVERIFY(flight.ready());
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    // The pipe is full when the agent begins, and its reader never reads. Both end by themselves.
    const QString script = QStringLiteral("(head -c 65536 /dev/zero; exec timeout 25 \"$0\" \"$@\") | sleep 26");
    Program agent(QStringLiteral("/bin/sh"),
                  QStringList{QStringLiteral("-c"), script, QStringLiteral(SKYSEAL_BIN_DIR "/skyseal-air")}
                      + flight.airArguments());
    Program monitor(QStringLiteral("skyseal-cli"),
                    flight.monitorArguments({QStringLiteral("--duration"), QStringLiteral("4")}));
    QVERIFY2(!monitor.waitFor(QStringLiteral("session")).isEmpty(), monitor.errors() + agent.errors());
    QCOMPARE(monitor.waitForExit(), 0);
    const QJsonObject mavlink = monitor.last(QStringLiteral("summary"))[QLatin1String("mavlink")].toObject();
    QVERIFY(mavlink[QLatin1String("frames")].toInt() > 50);
}

SKYSEAL_TEST(UnreadOutputTest)
#include "unread_output_test.moc"
