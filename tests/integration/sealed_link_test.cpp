// The sealed link between real programs: simulator, agent and monitor connect, switch through all suites and lose only what
// the channel between them drops. The time that connecting may take: SessionTest::comesUpWithinASecond.
#include "tests/support/flight.h"
#include "tests/support/json_values.h"
#include "tests/support/record_counters.h"
#include "tests/support/test_runner.h"

#include <QtCore/QSet>
#include <QtTest/QTest>

using namespace skyseal::test;

namespace {

/// How long the suites are switched; SKYSEAL_SWITCHING_SECONDS of the environment makes it longer.
const int kSwitchingSeconds = qEnvironmentVariableIsSet("SKYSEAL_SWITCHING_SECONDS")
    ? qEnvironmentVariableIntValue("SKYSEAL_SWITCHING_SECONDS")
    : 14;

QJsonObject within(const QJsonObject &object, const char *outer, const char *inner)
{
    return object[QLatin1String(outer)][QLatin1String(inner)].toObject();
}

} // namespace

class SealedLinkTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sessionComesUp();
    void walksThroughAllSuitesAndLosesNothing();
    void losesOnlyWhatTheChannelDropped();
};

void SealedLinkTest::sessionComesUp()
{
    Flight flight;
    QVERIFY(flight.ready());
    Program air(QStringLiteral("skyseal-air"), flight.airArguments());
    QVERIFY(!air.waitFor(QStringLiteral("link")).isEmpty());
    Program monitor(QStringLiteral("skyseal-cli"), flight.monitorArguments());
    QVERIFY2(!monitor.waitFor(QStringLiteral("link")).isEmpty(), monitor.errors().constData());
    const QJsonObject session = monitor.waitFor(QStringLiteral("session"));
    QCOMPARE(session[QLatin1String("state")].toString(), QStringLiteral("up"));
    QCOMPARE(session[QLatin1String("peer")].toString(), QStringLiteral("air-1"));
    QCOMPARE(session[QLatin1String("suite")].toString(), QStringLiteral("chacha20-poly1305"));
}

void SealedLinkTest::walksThroughAllSuitesAndLosesNothing()
{
    Flight flight;
    QVERIFY(flight.ready());
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    Program air(QStringLiteral("skyseal-air"), flight.airArguments());
    Program monitor(QStringLiteral("skyseal-cli"),
                    flight.monitorArguments({QStringLiteral("--switch-to"), allSuites(), QStringLiteral("--switch-every"),
                                             QStringLiteral("1"), QStringLiteral("--stream-rate"), QStringLiteral("50"),
                                             QStringLiteral("--duration"), QString::number(kSwitchingSeconds)}));
    QCOMPARE(monitor.waitForExit(kSwitchingSeconds * 1000 + kDeadlineMs), 0);

    const QJsonObject summary = monitor.last(QStringLiteral("summary"));
    const QJsonObject mavlink = summary[QLatin1String("mavlink")].toObject();
    const QJsonObject received = receivedRecords(summary[QLatin1String("channel")]);
    QVERIFY(number(mavlink, "frames") > 50 * (kSwitchingSeconds - 3));
    QCOMPARE(number(mavlink, "lost"), 0);
    QCOMPARE(number(mavlink, "duplicate"), 0);
    for (const char *counter : {"lost", "replayed", "forged", "malformed"})
        QVERIFY2(number(received, counter) == 0, counter);

    QSet<QString> reached;
    for (const QJsonObject &event : monitor.events(QStringLiteral("switch"))) {
        QCOMPARE(event[QLatin1String("result")].toString(), QStringLiteral("committed"));
        reached.insert(event[QLatin1String("to")].toString());
    }
    const QStringList wanted = allSuites().split(QLatin1Char(','));
    QCOMPARE(reached, QSet<QString>(wanted.begin(), wanted.end()));
}

void SealedLinkTest::losesOnlyWhatTheChannelDropped()
{
    Flight flight;
    QVERIFY(flight.ready());
    const quint16 relay = freeUdpPort();
    Program impair(QStringLiteral("skyseal-cli"),
                   {QStringLiteral("impair"), QStringLiteral("--listen"), QStringLiteral("udpin:127.0.0.1:%1").arg(relay),
                    QStringLiteral("--to"), QStringLiteral("udpout:127.0.0.1:%1").arg(flight.groundPort),
                    QStringLiteral("--loss"), QStringLiteral("0.2"), QStringLiteral("--jitter"), QStringLiteral("50"),
                    QStringLiteral("--duplicate"), QStringLiteral("0.1"), QStringLiteral("--reorder"), QStringLiteral("0.1"),
                    QStringLiteral("--seed"), QStringLiteral("11"), QStringLiteral("--json")});
    Program monitor(QStringLiteral("skyseal-cli"),
                    flight.monitorArguments({QStringLiteral("--switch-to"), allSuites(), QStringLiteral("--switch-every"),
                                             QStringLiteral("1"), QStringLiteral("--stream-rate"), QStringLiteral("50")}));
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    Program air(QStringLiteral("skyseal-air"), flight.airArguments(relay));

    QVERIFY(!monitor.waitFor(QStringLiteral("session")).isEmpty());
    for (int second = 0; second < kSwitchingSeconds; ++second)
        QVERIFY(!monitor.waitFor(QStringLiteral("stats")).isEmpty());

    // Stop the sender first, so that everything in flight arrives before the receiver is asked.
    QCOMPARE(air.terminate(), 0);
    const auto drained = [](const QJsonObject &stats) {
        return stats[QLatin1String("forward")][QLatin1String("waiting")].toInt() == 0;
    };
    impair.skipReceivedEvents();
    QVERIFY(!impair.waitFor(QStringLiteral("stats"), drained).isEmpty());
    QCOMPARE(impair.terminate(), 0);

    const qint64 sent = number(within(air.last(QStringLiteral("summary")), "channel", "tx"), "records");
    const qint64 dropped = number(impair.last(QStringLiteral("summary"))[QLatin1String("forward")].toObject(),
                                  "dropped_records");
    const auto allArrived = [&](const QJsonObject &stats) { // the last of it may still wait in the receiver's socket
        return number(within(stats, "channel", "rx"), "good") >= sent - dropped;
    };
    QVERIFY(!monitor.waitFor(QStringLiteral("stats"), allArrived).isEmpty());
    QCOMPARE(monitor.terminate(), 0);
    const QJsonObject received = receivedRecords(monitor.last(QStringLiteral("summary"))[QLatin1String("channel")]);
    QVERIFY(dropped > 0);
    QCOMPARE(number(received, "good"), sent - dropped);
    QCOMPARE(number(received, "forged"), 0);
    QCOMPARE(number(received, "malformed"), 0);
    QVERIFY(number(received, "replayed") > 0); // the duplicates of the channel
    // None of them reaches MAVLink. Its numbers, of eight bits, take a few frames for repeated ones where the relay stood still
    // and then sent more than half of all numbers in another order.
    const QJsonObject frames = monitor.last(QStringLiteral("summary"))[QLatin1String("mavlink")].toObject();
    QVERIFY(number(frames, "duplicate") < number(received, "replayed") / 4);
}

SKYSEAL_TEST(SealedLinkTest)
#include "sealed_link_test.moc"
