// An independent peer: a station and an agent in Python, written from PROTOCOL.md and public specifications alone, shake
// hands with the real programs, open each other's records under every suite, and switch between them live.
//
// Needs /usr/bin/python3 with python3-cryptography (Debian); SKYSEAL_PYTHON names another interpreter.
#include "tests/support/flight.h"
#include "tests/support/json_values.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDeadlineTimer>
#include <QtCore/QFile>
#include <QtTest/QTest>

using namespace skyseal::test;

namespace {

constexpr int kSuites = 6;
constexpr int kFramesUnderEach = 20;

QJsonObject within(const QJsonObject &object, const char *key)
{
    return object[QLatin1String(key)].toObject();
}

qint64 framesUnder(const QJsonObject &status, int suite)
{
    return within(status, "frames")[QString::number(suite)].toInteger();
}

Program::Predicate has(const char *key, const char *text)
{
    return [key, text](const QJsonObject &event) { return event[QLatin1String(key)].toString() == QLatin1String(text); };
}

/// Asks the peer for its status until `predicate` holds; the last answer, or an empty object when it never did.
QJsonObject statusWhere(Program &peer, const Program::Predicate &predicate, int milliseconds = kDeadlineMs)
{
    const QDeadlineTimer deadline(milliseconds);
    while (!deadline.hasExpired()) {
        peer.skipReceivedEvents();
        peer.notify(QStringLiteral("status"));
        const QJsonObject status = peer.waitFor(QStringLiteral("status"));
        if (!status.isEmpty() && predicate(status))
            return status;
    }
    return {};
}

} // namespace

class IndependentPeerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void agreesWithTheDocument();
    void stationOpensTelemetryUnderEverySuite();
    void stationSwitchesOverABadLink();
    void stationRoamsClosesAndComesBack();
    void stationThatLostItsCounterGoesOn();
    void stationGetsThroughAFlood();
    void agentServesTheMonitor();
    void agentAsksForACookie();

private:
    QStringList script(const QStringList &arguments) const;
    /// A key for the Python peer that the programs of this flight know; false when something failed.
    bool introduce(const Flight &flight) const;
    /// The arguments of the Python station or agent of this flight.
    QStringList arguments(const Flight &flight, const char *role, const char *otherKey, const QStringList &more) const;

    QString m_python;
};

void IndependentPeerTest::initTestCase()
{
    SKYSEAL_REQUIRES("python_cryptography");
    m_python = pythonProgram();
}

QStringList IndependentPeerTest::script(const QStringList &arguments) const
{
    return QStringList{QStringLiteral("-B"), QStringLiteral(SKYSEAL_SOURCE_DIR "/tests/integration/independent_peer/peer.py")}
    + arguments;
}

bool IndependentPeerTest::introduce(const Flight &flight) const
{
    Program newKey(m_python, script({QStringLiteral("--new-key"), flight.path(QStringLiteral("python.key"))}));
    if (newKey.waitForExit() != 0 || newKey.otherLines().isEmpty())
        return false;
    const QString key = QString::fromLatin1(newKey.otherLines().front());
    for (const char *peers : {"air.peers", "ground.peers"}) {
        Program add(QStringLiteral("skyseal-cli"),
                    {QStringLiteral("keys"), QStringLiteral("peers"), QStringLiteral("add"), QStringLiteral("--peers"),
                     flight.path(QLatin1String(peers)), QStringLiteral("--name"), QStringLiteral("python"), key});
        if (add.waitForExit() != 0)
            return false;
    }
    return true;
}

QStringList IndependentPeerTest::arguments(const Flight &flight, const char *role, const char *otherKey,
                                           const QStringList &more) const
{
    Program show(
        QStringLiteral("skyseal-cli"),
        {QStringLiteral("keys"), QStringLiteral("show"), flight.path(QLatin1String(otherKey)), QStringLiteral("--json")});
    const QString other = show.waitFor(QStringLiteral("key"))[QLatin1String("public")].toString();
    return script({QLatin1String(role), QStringLiteral("--research"), QStringLiteral("--key"),
                   flight.path(QStringLiteral("python.key")), QStringLiteral("--peer"), other})
        + more;
}

void IndependentPeerTest::agreesWithTheDocument()
{
    Program check(m_python,
                  script({QStringLiteral("--check"), QStringLiteral(SKYSEAL_SOURCE_DIR "/core/channel/PROTOCOL.md")}));
    const int status = check.waitForExit();
    QVERIFY2(status == 0, check.otherLines().join('\n') + check.errors());
}

void IndependentPeerTest::stationOpensTelemetryUnderEverySuite()
{
    Flight flight;
    QVERIFY(flight.ready() && introduce(flight));
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    Program air(QStringLiteral("skyseal-air"), flight.airArguments());
    Program station(m_python,
                    arguments(flight, "--station", "air.key", {QStringLiteral("--port"), QString::number(flight.groundPort)}));
    const QJsonObject session = station.waitFor(QStringLiteral("session"));
    QVERIFY2(!session.isEmpty(), station.errors().constData());
    QCOMPARE(session[QLatin1String("suite")].toInt(), 1);
    QCOMPARE(air.waitFor(QStringLiteral("session"))[QLatin1String("peer")].toString(), QStringLiteral("python"));

    for (int suite = kSuites; suite >= 1; --suite) {
        station.notify(QStringLiteral("propose %1").arg(suite));
        const QJsonObject settled = station.waitFor(QStringLiteral("settled"));
        QCOMPARE(settled[QLatin1String("epoch")].toInt(), kSuites + 1 - suite);
        const auto seen = [suite](const QJsonObject &status) { return framesUnder(status, suite) >= kFramesUnderEach; };
        QVERIFY2(!statusWhere(station, seen).isEmpty(), qPrintable(QString::number(suite)));
    }
    station.notify(QStringLiteral("beat 5"));
    const auto fiveOpened = [](const QJsonObject &status) { return number(within(status, "peer"), "opened_bytes") == 5 * 21; };
    const QJsonObject status = statusWhere(station, fiveOpened);
    QVERIFY2(!status.isEmpty(), station.errors().constData());
    for (const char *counter : {"lost", "replayed", "forged", "malformed", "plaintext_dropped"}) {
        QVERIFY2(number(within(status, "counts"), counter) == 0, counter);
        QVERIFY2(number(within(status, "peer"), counter) == 0, counter);
    }
    QCOMPARE(number(status, "gaps"), 0);
    QCOMPARE(number(status, "strange"), 0);

    station.skipReceivedEvents();
    QCOMPARE(air.terminate(), 0);
    const QJsonObject ended = station.waitFor(QStringLiteral("ended"));
    QCOMPARE(ended[QLatin1String("why")].toString(), QStringLiteral("peer closed"));
    const QJsonObject sent = within(within(air.last(QStringLiteral("summary")), "channel"), "tx");
    QCOMPARE(number(within(ended, "counts"), "good"), number(sent, "records"));
    QCOMPARE(number(within(ended, "counts"), "lost"), 0);
}

void IndependentPeerTest::stationSwitchesOverABadLink()
{
    Flight flight;
    QVERIFY(flight.ready() && introduce(flight));
    const quint16 relay = freeUdpPort();
    Program impair(QStringLiteral("skyseal-cli"),
                   {QStringLiteral("impair"), QStringLiteral("--listen"), QStringLiteral("udpin:127.0.0.1:%1").arg(relay),
                    QStringLiteral("--to"), QStringLiteral("udpout:127.0.0.1:%1").arg(flight.groundPort),
                    QStringLiteral("--loss"), QStringLiteral("0.2"), QStringLiteral("--jitter"), QStringLiteral("50"),
                    QStringLiteral("--duplicate"), QStringLiteral("0.1"), QStringLiteral("--reorder"), QStringLiteral("0.1"),
                    QStringLiteral("--seed"), QStringLiteral("5"), QStringLiteral("--json")});
    Program station(m_python,
                    arguments(flight, "--station", "air.key", {QStringLiteral("--port"), QString::number(flight.groundPort)}));
    QVERIFY2(!station.waitFor(QStringLiteral("listening")).isEmpty(), station.errors().constData());
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    Program air(QStringLiteral("skyseal-air"), flight.airArguments(relay));
    QVERIFY2(!station.waitFor(QStringLiteral("session")).isEmpty(), station.errors().constData());

    for (int suite = kSuites; suite >= 1; --suite) {
        station.notify(QStringLiteral("propose %1").arg(suite));
        QVERIFY2(!station.waitFor(QStringLiteral("settled")).isEmpty(), qPrintable(QString::number(suite)));
        const auto seen = [suite](const QJsonObject &status) { return framesUnder(status, suite) >= kFramesUnderEach; };
        QVERIFY2(!statusWhere(station, seen).isEmpty(), qPrintable(QString::number(suite)));
    }
    // Stop the sender first, so that everything in flight arrives before the receiver is asked.
    QCOMPARE(air.terminate(), 0);
    const auto drained = [](const QJsonObject &stats) { return number(within(stats, "forward"), "waiting") == 0; };
    impair.skipReceivedEvents();
    QVERIFY(!impair.waitFor(QStringLiteral("stats"), drained).isEmpty());
    QCOMPARE(impair.terminate(), 0);

    const qint64 sent = number(within(within(air.last(QStringLiteral("summary")), "channel"), "tx"), "records");
    const qint64 dropped = number(within(impair.last(QStringLiteral("summary")), "forward"), "dropped_records");
    const auto allArrived = [&](const QJsonObject &asked) { // the last of it may still wait in the receiver's socket
        return number(within(asked, "counts"), "good") >= sent - dropped;
    };
    const QJsonObject status = statusWhere(station, allArrived);
    QVERIFY2(!status.isEmpty(), station.errors().constData());
    const QJsonObject counts = within(status, "counts");
    QVERIFY(dropped > 0);
    QCOMPARE(number(counts, "good"), sent - dropped);
    QVERIFY(number(counts, "replayed") > 0); // the channel's duplicates, each refused
    QCOMPARE(number(counts, "forged"), 0);
    QCOMPARE(number(counts, "malformed"), 0);
    QCOMPARE(number(status, "strange"), 0);
}

void IndependentPeerTest::stationRoamsClosesAndComesBack()
{
    Flight flight;
    QVERIFY(flight.ready() && introduce(flight));
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    Program air(QStringLiteral("skyseal-air"),
                flight.airArguments(0, {QStringLiteral("--suites"), QStringLiteral("chacha20-poly1305,aes-256-cbc")}));
    Program station(m_python,
                    arguments(flight, "--station", "air.key",
                              {QStringLiteral("--suites"), QStringLiteral("2,4,1"), QStringLiteral("--port"),
                               QString::number(flight.groundPort)}));
    QCOMPARE(station.waitFor(QStringLiteral("session"))[QLatin1String("suite")].toInt(), 4);
    const auto enough = [](qint64 frames) {
        return [frames](const QJsonObject &status) { return framesUnder(status, 4) >= frames; };
    };
    const qint64 before = framesUnder(statusWhere(station, enough(kFramesUnderEach)), 4);
    QVERIFY(before > 0);
    station.notify(QStringLiteral("roam"));
    QVERIFY(!air.waitFor(QStringLiteral("moved")).isEmpty());
    const QJsonObject after = statusWhere(station, enough(before + 100));
    QVERIFY2(!after.isEmpty(), station.errors().constData());
    QCOMPARE(number(after, "gaps"), 0);
    QCOMPARE(number(within(after, "counts"), "lost"), 0);

    station.notify(QStringLiteral("propose 2")); // not in the agent's offer
    QCOMPARE(station.waitFor(QStringLiteral("switch-failed"))[QLatin1String("why")].toString(), QStringLiteral("refused"));

    station.notify(QStringLiteral("close"));
    const auto down = has("state", "down");
    QCOMPARE(air.waitFor(QStringLiteral("session"), down)[QLatin1String("reason")].toString(), QStringLiteral("peer-closed"));
    QVERIFY(!air.waitFor(QStringLiteral("session"), has("state", "up")).isEmpty());
    QCOMPARE(station.waitFor(QStringLiteral("session"))[QLatin1String("suite")].toInt(), 4);
}

void IndependentPeerTest::agentServesTheMonitor()
{
    Flight flight;
    QVERIFY(flight.ready() && introduce(flight));
    Program monitor(
        QStringLiteral("skyseal-cli"),
        flight.monitorArguments({QStringLiteral("--switch-to"), allSuites(), QStringLiteral("--switch-every"),
                                 QStringLiteral("0.4"), QStringLiteral("--record"), flight.path(QStringLiteral("record"))}));
    QVERIFY2(!monitor.waitFor(QStringLiteral("link")).isEmpty(), monitor.errors().constData());
    Program agent(
        m_python,
        arguments(flight, "--agent", "ground.key", {QStringLiteral("--announce"), QString::number(flight.groundPort)}));
    const QJsonObject up = monitor.waitFor(QStringLiteral("session"));
    QCOMPARE(up[QLatin1String("peer")].toString(), QStringLiteral("python"));
    QVERIFY(!agent.waitFor(QStringLiteral("session")).isEmpty());

    // The station proposes each suite, the agent answers.
    for (int i = 0; i < kSuites; ++i) {
        agent.notify(QStringLiteral("beat 10"));
        const QJsonObject switched = monitor.waitFor(QStringLiteral("switch"));
        QCOMPARE(switched[QLatin1String("to")].toString(), allSuites().split(QLatin1Char(','))[i]);
        QCOMPARE(switched[QLatin1String("result")].toString(), QStringLiteral("committed"));
    }
    // And the agent proposes one itself.
    agent.notify(QStringLiteral("propose 5"));
    const auto own = has("proposal", "own");
    QCOMPARE(agent.waitFor(QStringLiteral("switched"), own)[QLatin1String("suite")].toInt(), 5);
    const auto byPeer = [](const QJsonObject &event) { return event[QLatin1String("by_peer")].toBool(); };
    QCOMPARE(monitor.waitFor(QStringLiteral("switch"), byPeer)[QLatin1String("to")].toString(), QStringLiteral("chacha20"));

    const auto allArrived = [](const QJsonObject &status) {
        return number(within(status, "peer"), "opened_bytes") == kSuites * 10 * 21;
    };
    const QJsonObject status = statusWhere(agent, allArrived);
    QVERIFY2(!status.isEmpty(), agent.errors().constData());
    for (const char *counter : {"lost", "replayed", "forged", "malformed", "plaintext_dropped"}) {
        QVERIFY2(number(within(status, "counts"), counter) == 0, counter);
        QVERIFY2(number(within(status, "peer"), counter) == 0, counter);
    }
    agent.skipReceivedEvents();
    agent.notify(QStringLiteral("close"));
    const auto ended = has("why", "closed here");
    QVERIFY(!agent.waitFor(QStringLiteral("ended"), ended).isEmpty());
    const QJsonObject down = monitor.waitFor(QStringLiteral("session"), has("state", "down"));
    QCOMPARE(down[QLatin1String("reason")].toString(), QStringLiteral("peer-closed"));
    agent.notify(QStringLiteral("quit"));
    QCOMPARE(agent.waitForExit(), 0);
    QCOMPARE(monitor.terminate(), 0);
    const QJsonObject summary = monitor.last(QStringLiteral("summary"));
    QCOMPARE(number(within(summary, "mavlink"), "lost"), 0);
    QCOMPARE(number(within(summary, "mavlink"), "duplicate"), 0);
}

void IndependentPeerTest::stationThatLostItsCounterGoesOn()
{
    Flight flight;
    QVERIFY(flight.ready() && introduce(flight));
    Program air(QStringLiteral("skyseal-air"), flight.airArguments());
    const QStringList stationArguments = arguments(flight, "--station", "air.key",
                                                   {QStringLiteral("--port"), QString::number(flight.groundPort)});
    {
        Program station(m_python, stationArguments);
        QVERIFY2(!station.waitFor(QStringLiteral("session")).isEmpty(), station.errors().constData());
        QVERIFY(!air.waitFor(QStringLiteral("session"), has("state", "up")).isEmpty());
        station.notify(QStringLiteral("close"));
        QVERIFY(!air.waitFor(QStringLiteral("session"), has("state", "down")).isEmpty());
        station.notify(QStringLiteral("quit"));
        QCOMPARE(station.waitForExit(), 0);
    }
    QVERIFY(QFile::remove(flight.path(QStringLiteral("python.key.counter"))));
    Program station(m_python, stationArguments);
    const QJsonObject told = station.waitFor(QStringLiteral("number"));
    QVERIFY2(number(told, "number") >= 1, station.errors().constData());
    QVERIFY(!station.waitFor(QStringLiteral("session")).isEmpty());
    QVERIFY(!air.waitFor(QStringLiteral("session"), has("state", "up")).isEmpty());
}

void IndependentPeerTest::stationGetsThroughAFlood()
{
    Flight flight;
    QVERIFY(flight.ready() && introduce(flight));
    Program air(QStringLiteral("skyseal-air"), flight.airArguments());
    // Forty times as many as the agent computes on, so that a station hardly gets in without a cookie, also on a busy machine.
    Program station(m_python,
                    arguments(flight, "--station", "air.key",
                              {QStringLiteral("--flood"), QStringLiteral("2000"), QStringLiteral("--port"),
                               QString::number(flight.groundPort)}));
    QVERIFY2(!station.waitFor(QStringLiteral("session")).isEmpty(), station.errors().constData());
    QVERIFY(!air.waitFor(QStringLiteral("session"), has("state", "up")).isEmpty());
    QVERIFY(!station.events(QStringLiteral("cookie")).empty());
}

void IndependentPeerTest::agentAsksForACookie()
{
    Flight flight;
    QVERIFY(flight.ready() && introduce(flight));
    Program monitor(QStringLiteral("skyseal-cli"),
                    flight.monitorArguments({QStringLiteral("--record"), flight.path(QStringLiteral("record"))}));
    QVERIFY2(!monitor.waitFor(QStringLiteral("link")).isEmpty(), monitor.errors().constData());
    Program agent(
        m_python,
        arguments(flight, "--agent", "ground.key",
                  {QStringLiteral("--suspicious"), QStringLiteral("--announce"), QString::number(flight.groundPort)}));
    QVERIFY2(!agent.waitFor(QStringLiteral("cookie")).isEmpty(), agent.errors().constData());
    QVERIFY(!monitor.waitFor(QStringLiteral("session")).isEmpty());
    QVERIFY(!agent.waitFor(QStringLiteral("session")).isEmpty());
}

SKYSEAL_TEST(IndependentPeerTest)
#include "independent_peer_test.moc"
