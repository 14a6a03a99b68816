// The remaining time of a sweep, by durations that are made up: it falls as the runs end, whatever a block's start costs.
#include "core/experiment/time_left.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <cmath>

using skyseal::experiment::TimeLeft;

class TimeLeftTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void planIsAllThatIsKnownAtFirst() { QCOMPARE(TimeLeft(5.5).of(48, 1), 48 * 5.5); }

    void startOfABlockIsCountedOncePerBlock()
    {
        // Three blocks of sixteen runs of 5.6 s each, and 4 s before the first run of each.
        constexpr double kRun = 5.6, kStart = 4;
        constexpr std::size_t kBlocks = 3, kRuns = 16;
        TimeLeft left(5.5);
        double told = left.of(kBlocks * kRuns, kBlocks), ahead = kBlocks * (kStart + kRuns * kRun);
        for (std::size_t i = 0; i < kBlocks * kRuns; ++i) {
            const bool first = i % kRuns == 0;
            const double took = kRun + (first ? kStart : 0);
            left.runEnded(took, first);
            ahead -= took;
            const std::size_t runs = kBlocks * kRuns - 1 - i, blocks = runs / kRuns;
            const double now = left.of(runs, blocks);
            // The first run tells about the start of the other blocks, which nobody knew; from then on it only falls.
            if (i > 0)
                QVERIFY2(now < told, qPrintable(QStringLiteral("run %1: %2 after %3").arg(i).arg(now).arg(told)));
            QVERIFY2(std::abs(now - ahead) < 0.05 * ahead + 0.01,
                     qPrintable(QStringLiteral("run %1: %2 for %3").arg(i).arg(now).arg(ahead)));
            told = now;
        }
        QCOMPARE(told, 0.0);
    }

    void oneBlockDoesNotJumpAtItsFirstRun()
    {
        TimeLeft left(1.5);
        left.runEnded(6.2, true);
        QCOMPARE(left.of(1, 0), 1.5);
    }

    void runsThatTakeLongerThanPlannedAreBelieved()
    {
        TimeLeft left(2);
        left.runEnded(3, true);
        left.runEnded(4, false);
        left.runEnded(6, false);
        QCOMPARE(left.of(10, 0), 50.0);
        QCOMPARE(left.of(10, 1), 50.0); // the first run was no slower than the others
        left.runEnded(0.1, false);      // refused at once; the plan is the least
        left.runEnded(0.1, false);
        left.runEnded(0.1, false);
        left.runEnded(0.1, false);
        QCOMPARE(left.of(10, 0), 20.0);
    }
};

SKYSEAL_TEST(TimeLeftTest)
#include "time_left_test.moc"
