// The counters of lost, late and repeated frames at station and agent agree exactly with the treatment of each datagram by the
// relay between them: the relay's log, replayed in the order of sending, gives the same numbers for every report. Covers both
// directions, records, frames sealed in place and clear MAVLink, in the live counters and in a sweep.
#include "tests/support/flight.h"
#include "tests/support/json_values.h"
#include "tests/support/record_counters.h"
#include "tests/support/relay_ledger.h"
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <cmath>

using namespace skyseal::test;

namespace {

QString q(const char *text)
{
    return QString::fromUtf8(text);
}

RelayLedger::Sealed sealedOf(const QJsonValue &counters)
{
    return {number(counters, "good"), number(counters, "lost"), number(counters, "late"), number(counters, "replayed")};
}

RelayLedger::Frames framesOf(const QJsonValue &counters)
{
    return {number(counters, "frames"), number(counters, "lost"), number(counters, "late"), number(counters, "duplicate")};
}

/// Compares a report with the ledger. Returns a description of the difference, empty if there is none.
QString difference(const QJsonValue &counters, const std::vector<RelayLedger::Sealed> &books)
{
    const RelayLedger::Sealed said = sealedOf(counters);
    if (number(counters, "forged") + number(counters, "malformed") > 0)
        return QStringLiteral("forged or malformed records over a link that damages nothing");
    const auto arrived = static_cast<std::size_t>(said.good + said.replayed);
    if (arrived >= books.size())
        return QStringLiteral("%1, but only %2 arrived at all").arg(words(said)).arg(books.size() - 1);
    if (said == books[arrived])
        return {};
    QString out = QStringLiteral("said %1; the relay did %2").arg(words(said), words(books[arrived]));
    for (std::size_t i = arrived > 3 ? arrived - 3 : 0; i < std::min(arrived + 4, books.size()); ++i)
        out += QStringLiteral("\n    after %1: %2").arg(i).arg(words(books[i]));
    return out;
}

QString difference(const QJsonValue &counters, const std::vector<RelayLedger::Frames> &books)
{
    const RelayLedger::Frames said = framesOf(counters);
    const auto arrived = static_cast<std::size_t>(said.received);
    if (arrived >= books.size())
        return QStringLiteral("%1, but only %2 arrived at all").arg(words(said)).arg(books.size() - 1);
    return said == books[arrived] ? QString()
                                  : QStringLiteral("said %1; the relay did %2").arg(words(said), words(books[arrived]));
}

/// Over a link that loses, and one that does everything; in records, and sealed in place.
void addLinks(const char *loss, const char *all)
{
    QTest::addColumn<bool>("inPlace");
    QTest::addColumn<QByteArray>("impairment");
    QTest::newRow("records, loss") << false << QByteArray(loss);
    QTest::newRow("records, loss, duplicates, reordering") << false << QByteArray(all);
    QTest::newRow("sealed in place, loss, duplicates, reordering") << true << QByteArray(all);
}

} // namespace

#define AGREES(counters, books)                                                                                                \
    do {                                                                                                                       \
        const QString wrong = difference(counters, books);                                                                     \
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));                                                                          \
    } while (false)

class LossAccountingTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void liveCountersAreExact_data();
    void liveCountersAreExact();
    void plainFramesAreCountedExactly();
    void sweepsLossIsExact_data();
    void sweepsLossIsExact();

private:
    QStringList relayArguments(quint16 relay, quint16 ground, const char *impairment);
    /// Until nothing waits in the relay and two more reports of the monitor have come.
    void drain(Program &impair, Program &monitor);
};

QStringList LossAccountingTest::relayArguments(quint16 relay, quint16 ground, const char *impairment)
{
    return QStringList{q("impair"),
                       q("--listen"),
                       QStringLiteral("udpin:127.0.0.1:%1").arg(relay),
                       q("--to"),
                       QStringLiteral("udpout:127.0.0.1:%1").arg(ground),
                       q("--json"),
                       q("--datagrams")}
    + words(impairment);
}

void LossAccountingTest::drain(Program &impair, Program &monitor)
{
    for (int i = 0; i < 2; ++i) {
        impair.skipReceivedEvents();
        monitor.skipReceivedEvents();
        QVERIFY(!impair.waitFor(q("stats")).isEmpty());
        QVERIFY(!monitor.waitFor(q("stats")).isEmpty());
    }
}

void LossAccountingTest::liveCountersAreExact_data()
{
    const char *const kLoss = "--loss 0.15 --seed 3";
    addLinks(kLoss, "--loss 0.15 --duplicate 0.1 --reorder 0.1 --delay 5 --jitter 10 --seed 4");
    QTest::newRow("sealed in place, loss") << true << QByteArray(kLoss);
}

void LossAccountingTest::liveCountersAreExact()
{
    QFETCH(bool, inPlace);
    QFETCH(QByteArray, impairment);
    Flight flight;
    QVERIFY(flight.ready());
    const quint16 relay = freeUdpPort();
    Program impair(q("skyseal-cli"), relayArguments(relay, flight.groundPort, impairment.constData()));
    Program monitor(q("skyseal-cli"),
                    flight.monitorArguments(
                        words(inPlace ? "--framing inline --stream-rate 20 --no-record" : "--stream-rate 20 --no-record")));
    Program sim(q("skyseal-sim"), flight.simArguments());
    Program air(q("skyseal-air"), flight.airArguments(relay, inPlace ? words("--allow-inline") : QStringList()));
    QVERIFY2(!monitor.waitFor(q("session")).isEmpty(), monitor.errors().constData());
    for (int second = 0; second < 6; ++second)
        QVERIFY(!monitor.waitFor(q("stats")).isEmpty());
    QCOMPARE(sim.terminate(), 0);
    drain(impair, monitor);
    QCOMPARE(monitor.terminate(), 0);
    QCOMPARE(air.terminate(), 0);
    QCOMPARE(impair.terminate(), 0);

    const RelayLedger down(impair.events(), q("forward")), up(impair.events(), q("backward"));
    QVERIFY2(down.dropped() > 20 && up.dropped() > 0,
             qPrintable(QStringLiteral("%1, %2").arg(down.dropped()).arg(up.dropped())));
    QCOMPARE(down.duplicated() > 10, impairment.contains("duplicate"));
    QCOMPARE(down.overtaken() > 10, impairment.contains("reorder"));
    int reports = 0;
    for (const QJsonObject &stats : monitor.events(q("stats"))) {
        const QJsonValue channel = stats[QLatin1String("channel")];
        AGREES(receivedRecords(channel), down.sealed());
        AGREES(channel[QLatin1String("tx")], up.sealed()); // as the agent reported over the link
        if (inPlace)
            AGREES(stats[QLatin1String("mavlink")], down.frames());
        ++reports;
    }
    for (const QJsonObject &stats : air.events(q("stats")))
        AGREES(receivedRecords(stats[QLatin1String("channel")]), up.sealed());
    QVERIFY(reports >= 8);
    const RelayLedger::Sealed last = sealedOf(monitor.last(q("stats"))[QLatin1String("channel")][QLatin1String("rx")]);
    qInfo("to the station at last: %s", qPrintable(words(last)));
    QVERIFY(last.lost > 20);
}

void LossAccountingTest::plainFramesAreCountedExactly()
{
    Flight flight;
    QVERIFY(flight.ready());
    const quint16 relay = freeUdpPort();
    Program impair(
        q("skyseal-cli"),
        relayArguments(relay, flight.groundPort, "--loss 0.15 --duplicate 0.1 --reorder 0.1 --delay 5 --jitter 10 --seed 5"));
    Program monitor(q("skyseal-cli"),
                    QStringList{q("monitor"), q("--link"), QStringLiteral("udpin:127.0.0.1:%1").arg(flight.groundPort)}
                        + words("--secure off --stream-rate 20 --no-record --json"));
    // Otherwise the relay would send to a port that is not open yet, a loss that its log does not show.
    QVERIFY2(!monitor.waitFor(q("link")).isEmpty(), monitor.errors().constData());
    Program sim(q("skyseal-sim"), flight.simArguments());
    Program air(q("skyseal-air"), flight.airArguments(relay, words("--allow-plain")));
    QVERIFY2(!monitor.waitFor(q("vehicle")).isEmpty(), monitor.errors().constData());
    for (int second = 0; second < 6; ++second)
        QVERIFY(!monitor.waitFor(q("stats")).isEmpty());
    QCOMPARE(sim.terminate(), 0);
    drain(impair, monitor);
    QCOMPARE(monitor.terminate(), 0);
    QCOMPARE(impair.terminate(), 0);

    const RelayLedger down(impair.events(), q("forward"));
    QVERIFY(down.dropped() > 20 && down.duplicated() > 10 && down.overtaken() > 10);
    for (const QJsonObject &stats : monitor.events(q("stats")))
        AGREES(stats[QLatin1String("mavlink")], down.frames());
    const RelayLedger::Frames last = framesOf(monitor.last(q("stats"))[QLatin1String("mavlink")]);
    qInfo("to the station at last: %s", qPrintable(words(last)));
    QVERIFY(last.lost > 20 && last.duplicate > 10 && last.late > 0);
}

void LossAccountingTest::sweepsLossIsExact_data()
{
    addLinks("--loss 0.1 --seed 6", "--loss 0.1 --duplicate 0.1 --reorder 0.1 --delay 5 --jitter 10 --seed 7");
}

void LossAccountingTest::sweepsLossIsExact()
{
    QFETCH(bool, inPlace);
    QFETCH(QByteArray, impairment);
    Flight flight;
    QVERIFY(flight.ready());
    const quint16 relay = freeUdpPort();
    Program impair(q("skyseal-cli"), relayArguments(relay, flight.groundPort, impairment.constData()));
    Program sim(q("skyseal-sim"), flight.simArguments());
    Program air(q("skyseal-air"), flight.airArguments(relay, inPlace ? words("--allow-inline") : QStringList()));
    QStringList arguments =
        words("sweep --launches 1 --allow-research --seconds 1.5 --warm-up 1 --repeats 2 --no-noise --json --suites")
        + words(inPlace ? "chacha20,aes-256-ctr,rc4 --framing inline --identity"
                        : "chacha20-poly1305,aes-256-gcm,rc4 --identity");
    arguments << flight.path(q("ground.key")) << q("--peers") << flight.path(q("ground.peers")) << q("--link")
              << QStringLiteral("udpin:127.0.0.1:%1").arg(flight.groundPort);
    Program sweep(q("skyseal-cli"), arguments);
    QCOMPARE(sweep.waitForExit(2 * kDeadlineMs), 0);
    QCOMPARE(impair.terminate(), 0);

    const RelayLedger down(impair.events(), q("forward")), up(impair.events(), q("backward"));
    const auto runs = sweep.events(q("run"));
    QCOMPARE(runs.size(), std::size_t(6));
    for (const QJsonObject &run : runs) {
        const QJsonValue counted = run[QLatin1String("counted")];
        const QJsonValue begin = counted[QLatin1String("begin")], end = counted[QLatin1String("end")];
        for (const QJsonValue &edge : {begin, end}) {
            AGREES(edge[QLatin1String("rx")], down.sealed());
            AGREES(edge[QLatin1String("tx")], up.sealed());
        }
        // The reported share is computed from these counts.
        const auto checkShare = [&](const char *direction, const char *metric) {
            const auto from = sealedOf(begin[QLatin1String(direction)]), to = sealedOf(end[QLatin1String(direction)]);
            const auto lost = static_cast<double>(std::max<qint64>(0, to.lost - from.lost)),
                       good = static_cast<double>(to.good - from.good);
            const double share = run[QLatin1String("values")][QLatin1String(metric)].toDouble(-1);
            QVERIFY2(lost + good > 0 ? std::abs(share - lost / (lost + good)) < 1e-12
                                     : share == -1, // no new report of the agent
                     qPrintable(QStringLiteral("%1: %2").arg(q(metric)).arg(share)));
        };
        checkShare("rx", "record_loss");
        checkShare("tx", "record_loss_up");
    }
}

SKYSEAL_TEST(LossAccountingTest)
#include "loss_accounting_test.moc"
