// The replay window: a numbered table of cases at its edges, and random orders against a set of all counters.
#include "core/channel/replay_window.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>
#include <rapidcheck.h>

#include <algorithm>
#include <random>
#include <set>

using namespace skyseal::channel;

class ReplayWindowTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void table_data();
    void table();
    void replaysAtTheEdge_data();
    void replaysAtTheEdge();
    void sweepsBackwards();
    void matchesASetOfCounters();
    void lossIsExactInAnyOrder();
    void checkingDoesNotMark();
    void expectedTailCountsAsMissing();
};

namespace {

constexpr std::uint32_t N = ReplayWindow::kEntries;

bool take(ReplayWindow &window, std::uint32_t counter)
{
    if (!window.fresh(counter))
        return false;
    window.mark(counter);
    return true;
}

struct Step
{
    std::uint32_t counter;
    bool accepted;
};

} // namespace

void ReplayWindowTest::table_data()
{
    QTest::addColumn<QVector<quint32>>("counters");
    QTest::addColumn<QVector<bool>>("accepted");
    const auto row = [](int number, const char *what, std::initializer_list<Step> steps) {
        QVector<quint32> counters;
        QVector<bool> accepted;
        for (const Step &step : steps) {
            counters << step.counter;
            accepted << step.accepted;
        }
        QTest::addRow("%d %s", number, what) << counters << accepted;
    };
    row(1, "the first counter, once", {{0, true}, {0, false}});
    row(2, "in order", {{0, true}, {1, true}, {2, true}, {1, false}, {2, false}});
    row(3, "first is not zero", {{9, true}, {8, true}, {7, true}, {7, false}, {0, true}});
    row(4, "oldest that fits", {{N - 1, true}, {0, true}, {0, false}});
    row(5, "one too old", {{N, true}, {0, false}, {1, true}});
    row(6, "jump over the whole window", {{5, true}, {5 + N, true}, {5, false}, {6, true}, {5 + N, false}});
    row(7, "jump of exactly the ring", {{3, true}, {3 + 4096, true}, {3, false}, {3 + 4096 - 1, true}, {3 + 4096, false}});
    row(8, "jump of many rings", {{3, true}, {3 + 4096 * 9, true}, {3 + 4096 * 9 - N + 1, true}, {3 + 4096 * 9 - N, false}});
    row(9, "block borders",
        {{63, true}, {64, true}, {63, false}, {64, false}, {65, true}, {127, true}, {128, true}, {126, true}});
    row(10, "an old bit does not stand for a new counter",
        {{64, true}, {64 + 4096, true}, {65 + 4096, true}, {66, false}, {66 + 4096, true}});
    constexpr std::uint32_t kLast = (1u << 24) - 1;
    row(11, "the last counter of an epoch", {{kLast - 1, true}, {kLast - 1, false}, {kLast, true}, {kLast, false}});
    row(12, "a gap filled later", {{0, true}, {1000, true}, {500, true}, {500, false}, {1, true}, {999, true}});
}

void ReplayWindowTest::table()
{
    QFETCH(QVector<quint32>, counters);
    QFETCH(QVector<bool>, accepted);
    ReplayWindow window;
    for (int i = 0; i < counters.size(); ++i)
        QCOMPARE(take(window, counters[i]), accepted[i]);
}

void ReplayWindowTest::replaysAtTheEdge_data()
{
    QTest::addColumn<quint32>("newer");
    QTest::addColumn<bool>("seen");
    for (const quint32 newer : {0u, 1u, N - 1, N, N + 1}) {
        QTest::addRow("seen, then %u newer", newer) << newer << true;
        QTest::addRow("withheld, then %u newer", newer) << newer << false;
    }
}

void ReplayWindowTest::replaysAtTheEdge()
{
    QFETCH(quint32, newer);
    QFETCH(bool, seen);
    ReplayWindow window;
    constexpr std::uint32_t kCounter = 777;
    for (std::uint32_t i = 0; i < kCounter; ++i)
        QVERIFY(take(window, i));
    if (seen)
        QVERIFY(take(window, kCounter));
    for (std::uint32_t i = 1; i <= newer; ++i)
        QVERIFY(take(window, kCounter + i));
    QCOMPARE(take(window, kCounter), !seen && newer < N);
    QCOMPARE(take(window, kCounter), false);
}

void ReplayWindowTest::sweepsBackwards()
{
    ReplayWindow window;
    constexpr std::uint32_t kTop = 10000;
    QVERIFY(take(window, kTop));
    for (std::uint32_t i = 1; i < N; ++i)
        QVERIFY(take(window, kTop - i));
    for (std::uint32_t i = 0; i < N; ++i)
        QVERIFY(!take(window, kTop - i));
    QVERIFY(!take(window, kTop - N));
    QCOMPARE(window.seen(), std::uint64_t(N));
    QCOMPARE(window.missing(), std::uint64_t(kTop + 1 - N));
}

void ReplayWindowTest::matchesASetOfCounters()
{
    QVERIFY(rc::check("a counter is taken if it is new and less than the window behind the newest", [] {
        const auto seed = *rc::gen::arbitrary<std::uint32_t>();
        const auto spread = *rc::gen::element<std::uint32_t>(10, 100, 2000, 4000, 9000, 100000);
        std::mt19937 random(seed);
        ReplayWindow window;
        std::set<std::uint32_t> seen;
        std::uint32_t base = 0;
        std::uint64_t late = 0;
        std::uint64_t lateByWindow = 0;
        for (int i = 0; i < 3000; ++i) {
            base += random() % 3;
            const std::uint32_t counter = base + random() % spread;
            const bool fresh = !seen.contains(counter) && (seen.empty() || counter + N > *seen.rbegin());
            RC_ASSERT(window.fresh(counter) == fresh);
            if (!fresh)
                continue;
            late += !seen.empty() && counter < *seen.rbegin();
            seen.insert(counter);
            lateByWindow += window.mark(counter) == ReplayWindow::Arrival::Late;
            RC_ASSERT(window.next() == *seen.rbegin() + 1);
            RC_ASSERT(window.seen() == seen.size());
            RC_ASSERT(window.missing() == *seen.rbegin() + 1 - seen.size());
        }
        RC_ASSERT(late == lateByWindow);
    }));
}

void ReplayWindowTest::lossIsExactInAnyOrder()
{
    QVERIFY(rc::check("what is missing is what was dropped, whatever the order within the window", [] {
        std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
        const auto total = *rc::gen::inRange<std::uint32_t>(1, 1500);
        std::vector<std::uint32_t> counters(total);
        for (std::uint32_t i = 0; i < total; ++i)
            counters[i] = i;
        std::shuffle(counters.begin(), counters.end(), random);
        const auto dropped = *rc::gen::inRange<std::uint32_t>(0, total);
        ReplayWindow window;
        for (std::uint32_t i = dropped; i < total; ++i)
            RC_ASSERT(take(window, counters[i]));
        window.expect(total);
        RC_ASSERT(window.missing() == dropped);
        for (std::uint32_t i = 0; i < dropped; ++i)
            RC_ASSERT(take(window, counters[i]));
        RC_ASSERT(window.missing() == 0u);
    }));
}

void ReplayWindowTest::checkingDoesNotMark()
{
    // A forged counter far ahead is checked but never marked: the window does not move.
    ReplayWindow window;
    for (std::uint32_t i = 0; i < 100; ++i)
        QVERIFY(take(window, i));
    for (std::uint32_t i = 0; i < 1000; ++i)
        QVERIFY(window.fresh((1u << 24) - 1 - i));
    QCOMPARE(window.next(), 100u);
    QCOMPARE(window.missing(), std::uint64_t(0));
    QVERIFY(take(window, 100));
}

void ReplayWindowTest::expectedTailCountsAsMissing()
{
    ReplayWindow window;
    for (std::uint32_t i = 0; i < 10; ++i)
        QVERIFY(take(window, i));
    window.expect(13);
    QCOMPARE(window.missing(), std::uint64_t(3));
    QVERIFY(take(window, 11));
    QCOMPARE(window.missing(), std::uint64_t(2));
    window.expect(5); // an older count of the peer has no effect
    QCOMPARE(window.missing(), std::uint64_t(2));
}

SKYSEAL_TEST(ReplayWindowTest)
#include "replay_window_test.moc"
