// A day of an agent and a station in simulated time, over a link that loses, repeats, reorders and damages datagrams: switches,
// rekeys, outages, changed addresses, garbage and restarts of either side. Nothing gets stuck, every frame and every record is
// accounted for, and the memory of the process does not grow.
#include "core/crypto/init_crypto.h"
#include "pair.h"
#include "tests/support/heap_bytes.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <algorithm>
#include <cstdio>

#if defined(__GLIBC__)
#endif

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

/// Longest time in which frames pass again after each kind of disturbance, with the losses of this link.
constexpr Duration kRecovery = 10s;

} // namespace

class DayTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void nothingGrowsOrSticks();

private:
    /// Frames pass both ways again.
    static bool flows(Pair &pair)
    {
        const std::size_t down = pair.ground().delivered.size(), up = pair.air().delivered.size();
        return pair.run(kRecovery, [&] {
            return pair.bothUp() && pair.ground().delivered.size() > down + 5 && pair.air().delivered.size() > up + 5;
        });
    }
    static void startTraffic(Pair &pair)
    {
        pair.every(100ms, [&pair] { pair.sendFrame(Air); });
        pair.every(250ms, [&pair] { pair.sendFrame(Ground); });
    }
    /// Forgets what was accounted for, so that the harness itself does not grow.
    static void forget(Pair &pair)
    {
        for (const Side side : {Ground, Air}) {
            pair.ends[side].events.clear();
            pair.ends[side].delivered = {};
            pair.ends[side].epochs = {};
            pair.ends[side].freshness = {};
            pair.ends[side].arrived = {};
            pair.sent[side].clear();
            pair.dropped[side].clear();
        }
        pair.sentAt = {};
    }
    /// Ends the traffic, lets the last records arrive, and compares what was sent with what arrived or was lost.
    void settle(Pair &pair, const WireModel &bad);
};

void DayTest::settle(Pair &pair, const WireModel &bad)
{
    pair.stopTraffic();
    pair.link.model = WireModel{};
    pair.run(5s); // reports and records that keep the session alive show the last gaps
    const std::size_t replaced = pair.ground().all<SessionDown>().size();
    std::size_t missing = 0, unexpected = 0;
    for (const Side from : {Ground, Air}) {
        const auto &delivered = pair.ends[from == Ground ? Air : Ground].delivered;
        for (const std::uint64_t number : pair.sent[from])
            missing += !delivered.contains(number) && !pair.dropped[from].contains(number);
        for (const auto &[number, count] : delivered)
            unexpected += count > 1 || !pair.sent[from].contains(number) || pair.dropped[from].contains(number);
    }
    QCOMPARE(unexpected, std::size_t(0));
    // After an outage the station may replace the session; what was under way in the old one is not opened any more.
    QVERIFY2(missing <= replaced, qPrintable(QStringLiteral("%1 of %2").arg(missing).arg(replaced)));
    const auto ground = pair.ground().stats();
    const auto air = pair.air().stats();
    QVERIFY(ground && air);
    const std::uint64_t sent = air->tx.records, counted = ground->rx.good + ground->rx.lost;
    QVERIFY2(
        counted <= sent && sent - counted <= 64,
        qPrintable(
            QStringLiteral("sent %1, received %2, lost %3").arg(air->tx.records).arg(ground->rx.good).arg(ground->rx.lost)));
    forget(pair);
    pair.link.model = bad;
}

void DayTest::nothingGrowsOrSticks()
{
    const int hours = qEnvironmentVariableIsSet("SKYSEAL_HOURS") ? qEnvironmentVariableIntValue("SKYSEAL_HOURS") : 2;
    PairOptions options;
    options.seed = 24;
    options.link = {.loss = .02, .duplicate = .01, .corrupt = .002, .reorder = .01, .delay = 20ms, .jitter = 5ms};
    Pair pair(options);
    std::mt19937 random(24);
    const auto chance = [&random](int one) { return random() % static_cast<unsigned>(one) == 0; };
    QVERIFY(pair.run(kRecovery, [&] { return pair.bothUp(); }));
    std::size_t switches = 0, rekeys = 0, outages = 0, moves = 0, restarts = 0, garbage = 0;
    std::vector<std::size_t> heap;
    const std::vector<crypto::SuiteId> suites = defaultSuites();
    startTraffic(pair);
    for (int minute = 1; minute <= hours * 60; ++minute) {
        for (int part = 0; part < 2; ++part) { // half a minute each, with one disturbance
            if (chance(3)) {
                const Side side = chance(2) ? Ground : Air;
                pair.ends[side].switchSuite(pair.now, suites[random() % suites.size()]);
                ++switches;
            } else if (chance(6)) {
                pair.ground().rekey(pair.now);
                ++rekeys;
            } else if (chance(6)) {
                pair.link.attacker = [](TimePoint, SentDatagram &) { return false; };
                pair.run(std::chrono::seconds(random() % 60 + 1));
                pair.link.attacker = {};
                ++outages;
            } else if (chance(4)) {
                pair.air().port = static_cast<std::uint16_t>(40000 + random() % 20000);
                ++moves;
            } else if (chance(4)) {
                SentDatagram noise{chance(2) ? Ground : Air, 666, 0, Bytes(random() % 200 + 1)};
                for (auto &byte : noise.bytes)
                    byte = static_cast<std::uint8_t>(random());
                pair.link.inject(pair.now, noise);
                ++garbage;
            }
            QVERIFY2(flows(pair), qPrintable(QStringLiteral("minute %1").arg(minute)));
            pair.run(20s);
        }
        if (minute % 20 == 0) {
            settle(pair, options.link);
            if (QTest::currentTestFailed())
                return;
            const Side side = minute % 40 == 0 ? Ground : Air;
            pair.kill(side);
            pair.run(std::chrono::seconds(random() % 5));
            pair.start(side);
            QVERIFY(pair.run(kRecovery, [&] { return pair.bothUp(); }));
            ++restarts;
            pair.run(2s); // until both ends use the new session
            forget(pair);
            startTraffic(pair);
            QVERIFY(flows(pair));
        }
        if (minute % 60 == 0)
            heap.push_back(heapBytes());
    }
    const auto most = *std::ranges::max_element(heap);
    std::printf(
        "%d h: %zu switches, %zu rekeys, %zu outages, %zu addresses, %zu restarts, %zu times garbage; heap %zu kB after an "
        "hour, at most %zu kB, %zu kB at the end\n",
        hours, switches, rekeys, outages, moves, restarts, garbage, heap.front() / 1024, most / 1024, heap.back() / 1024);
    QVERIFY2(most < heap.front() + (256 << 10), qPrintable(QString::number(most)));
}

SKYSEAL_TEST_APPLESS(DayTest)
#include "day_test.moc"
