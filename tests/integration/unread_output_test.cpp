// An agent, or a relay, whose output is not read: a full pipe must not stop the link.
#include "tests/support/flight.h"
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <optional>

using namespace skyseal::test;

class UnreadOutputTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void linkGoesOn_data();
    void linkGoesOn();
};

namespace {

/// A program whose pipe is full when it begins, and whose reader never reads. Both end by themselves.
QStringList unread(const char *program, const QStringList &arguments)
{
    return QStringList{QStringLiteral("-c"),
                       QStringLiteral("(head -c 65536 /dev/zero; exec timeout 25 \"$0\" \"$@\") | sleep 26"),
                       QStringLiteral(SKYSEAL_BIN_DIR "/") + QLatin1String(program)}
    + arguments;
}

} // namespace

void UnreadOutputTest::linkGoesOn_data()
{
    QTest::addColumn<bool>("isRelay");
    QTest::newRow("agent") << false;
    QTest::newRow("relay between agent and station") << true;
}

void UnreadOutputTest::linkGoesOn()
{
    QFETCH(bool, isRelay);
    Flight flight;
    QVERIFY(flight.ready());
    const quint16 relay = freeUdpPort();
    const QString shell = QStringLiteral("/bin/sh");
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    std::optional<Program> agent, relaying;
    if (isRelay) {
        agent.emplace(QStringLiteral("skyseal-air"), flight.airArguments(relay));
        relaying.emplace(shell,
                         unread("skyseal-cli",
                                words("impair --json --drops --loss 0.1 --listen")
                                    << QStringLiteral("udpin:127.0.0.1:%1").arg(relay) << QStringLiteral("--to")
                                    << QStringLiteral("udpout:127.0.0.1:%1").arg(flight.groundPort)));
    } else {
        agent.emplace(shell, unread("skyseal-air", flight.airArguments()));
    }
    Program monitor(QStringLiteral("skyseal-cli"),
                    flight.monitorArguments({QStringLiteral("--duration"), QStringLiteral("4")}));
    QVERIFY2(!monitor.waitFor(QStringLiteral("session")).isEmpty(), monitor.errors() + agent->errors());
    QCOMPARE(monitor.waitForExit(), 0);
    const QJsonObject mavlink = monitor.last(QStringLiteral("summary"))[QLatin1String("mavlink")].toObject();
    QVERIFY(mavlink[QLatin1String("frames")].toInt() > 50);
}

SKYSEAL_TEST(UnreadOutputTest)
#include "unread_output_test.moc"
