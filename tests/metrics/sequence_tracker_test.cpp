// Sequence loss compared with a brute-force account of every frame, and the cases that other stations miscount: a late frame, a
// duplicate, a restart of the sender.
#include "core/impair/impairment.h"
#include "core/metrics/sequence_table.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>
#include <rapidcheck.h>

#include <algorithm>
#include <set>

using namespace skyseal;
using namespace skyseal::metrics;
using std::chrono::milliseconds;

class SequenceTrackerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void countsMatchTheAccount();
    void agreesWithTheImpairedLink();
    void longLossAfterAPauseIsLoss();
    void lateFrameTakesItsLossBack();
    void lateFirstFramesAreNotLost();
    void overtakenBatchIsLateAndNoRestart();
    void restartIsDetected();
    void restartAheadCostsOneGap();
    void announcedRestartCostsNothing();
    void silenceIsNotCountedAcross();
    void tableKeepsSendersApart();
    void forgedSendersDoNotReplaceEstablishedOnes();
    void tableIsBounded();

private:
    static SequenceCounts run(std::initializer_list<int> sequence)
    {
        SequenceTracker tracker;
        for (const int number : sequence)
            tracker.note(static_cast<std::uint8_t>(number), TimePoint());
        return tracker.counts();
    }
};

void SequenceTrackerTest::countsMatchTheAccount()
{
    QVERIFY(rc::check("lost, late and duplicate equal the brute-force account", [] {
        const int start = *rc::gen::inRange(0, 256);
        const int count = *rc::gen::inRange(1, 1500);
        const int lossPercent = *rc::gen::inRange(0, 60);
        const int reach = *rc::gen::inRange(1, 24);
        // Each frame is lost, or delivered once or twice, each copy after up to `reach` later frames.
        std::vector<std::pair<int, int>> arrivals;
        for (int i = 0; i < count; ++i) {
            if (*rc::gen::inRange(0, 100) < lossPercent)
                continue;
            const int copies = *rc::gen::inRange(0, 10) == 0 ? 2 : 1;
            for (int copy = 0; copy < copies; ++copy)
                arrivals.emplace_back(i + *rc::gen::inRange(0, 4) / 3 * *rc::gen::inRange(0, reach), i);
        }
        std::stable_sort(arrivals.begin(), arrivals.end(), [](auto a, auto b) { return a.first < b.first; });

        SequenceTracker tracker;
        std::set<int> seen;
        SequenceCounts expected;
        int newest = -1;
        int first = -1;
        for (const auto &[when, index] : arrivals) {
            tracker.note(static_cast<std::uint8_t>(start + index), TimePoint(milliseconds(20 * when)));
            ++expected.received;
            if (first < 0)
                first = index;
            if (!seen.insert(index).second)
                ++expected.duplicate;
            else if (index < newest)
                ++expected.late;
            newest = std::max(newest, index);
        }
        if (newest >= 0) {
            for (int i = first; i <= newest; ++i)
                expected.lost += seen.count(i) ? 0 : 1;
        }
        RC_ASSERT(tracker.counts().received == expected.received);
        RC_ASSERT(tracker.counts().lost == expected.lost);
        RC_ASSERT(tracker.counts().late == expected.late);
        RC_ASSERT(tracker.counts().duplicate == expected.duplicate);
        RC_ASSERT(tracker.counts().restarts == 0u);
    }));
}

void SequenceTrackerTest::agreesWithTheImpairedLink()
{
    const auto check = [](double loss, double duplicate, double reorder, Duration jitter, int framesPerSecond,
                          std::uint64_t seed) {
        impair::Impairment link({loss, duplicate, reorder, 0, milliseconds(20), jitter, 0, 16 << 10, seed});
        const Duration pause = std::chrono::duration_cast<Duration>(std::chrono::seconds(1)) / framesPerSecond;
        SequenceTracker tracker;
        SequenceCounts expected;
        std::set<std::uint64_t> seen;
        std::uint64_t newest = 0;
        std::uint64_t begin = 0;
        const auto drain = [&](TimePoint now) {
            impair::Impairment::Delivery delivery;
            while (link.pop(now, delivery)) {
                tracker.note(static_cast<std::uint8_t>(delivery.sequence), now);
                ++expected.received;
                if (seen.empty())
                    begin = delivery.sequence;
                const bool first = seen.insert(delivery.sequence).second;
                expected.duplicate += !first;
                expected.late += first && seen.size() > 1 && delivery.sequence < newest;
                newest = std::max(newest, delivery.sequence);
            }
        };
        TimePoint now{};
        for (int i = 0; i < 3000; ++i, now += pause) {
            for (TimePoint due = link.nextDeadline(); due <= now; due = link.nextDeadline())
                drain(due);
            link.push(now, Bytes(12));
        }
        while (link.nextDeadline() != kNever)
            drain(link.nextDeadline());
        // Frames sent before the first arrival are not expected.
        for (std::uint64_t number = begin; number <= newest && !seen.empty(); ++number)
            expected.lost += !seen.contains(number);
        RC_ASSERT(tracker.counts() == expected);
    };
    QVERIFY(rc::check("lost, late and duplicate as the impaired link decided them, up to 1000 frames a second", [&] {
        check(0.01 * *rc::gen::inRange(0, 30), 0.01 * *rc::gen::inRange(0, 20), 0.01 * *rc::gen::inRange(0, 20),
              milliseconds(*rc::gen::inRange(0, 120)), *rc::gen::inRange(20, 1001), *rc::gen::arbitrary<std::uint64_t>());
    }));
    QVERIFY(rc::check("20 % loss, 50 ms and 120 ms of jitter at 1000 frames a second", [&] {
        check(0.2, 0.1, 0.1, milliseconds(50), 1000, *rc::gen::arbitrary<std::uint64_t>());
        check(0.2, 0.1, 0.1, milliseconds(120), 1000, *rc::gen::arbitrary<std::uint64_t>());
    }));
}

void SequenceTrackerTest::longLossAfterAPauseIsLoss()
{
    SequenceTracker tracker;
    for (int i = 0; i < 300; ++i)
        tracker.note(static_cast<std::uint8_t>(i), TimePoint(milliseconds(i)));
    tracker.note(static_cast<std::uint8_t>(299 + 180), TimePoint(milliseconds(299 + 180)));
    QCOMPARE(tracker.counts(), (SequenceCounts{301, 179, 0, 0, 0}));
}

void SequenceTrackerTest::lateFrameTakesItsLossBack()
{
    SequenceTracker tracker;
    using Verdict = SequenceTracker::Verdict;
    QCOMPARE(tracker.note(254, TimePoint()), Verdict::First);
    QCOMPARE(tracker.note(1, TimePoint()), Verdict::AfterGap);
    QCOMPARE(tracker.counts().lost, std::uint64_t(2));
    QCOMPARE(tracker.note(0, TimePoint()), Verdict::Late);
    QCOMPARE(tracker.note(0, TimePoint()), Verdict::Duplicate);
    QCOMPARE(tracker.note(255, TimePoint()), Verdict::Late);
    QCOMPARE(tracker.note(2, TimePoint()), Verdict::InOrder);
    QCOMPARE(tracker.counts(), (SequenceCounts{6, 0, 2, 1, 0}));
}

void SequenceTrackerTest::lateFirstFramesAreNotLost()
{
    // 9 and 8 were sent before 10, which arrived first: they were not counted as lost, so they take no loss back.
    QCOMPARE(run({10, 9, 8, 8, 11}), (SequenceCounts{5, 0, 2, 1, 0}));
}

void SequenceTrackerTest::overtakenBatchIsLateAndNoRestart()
{
    SequenceTracker tracker;
    tracker.note(99, TimePoint());
    tracker.note(140, TimePoint());
    QCOMPARE(tracker.counts().lost, std::uint64_t(40));
    for (std::uint8_t i = 100; i < 140; ++i)
        QCOMPARE(tracker.note(i, TimePoint()), SequenceTracker::Verdict::Late);
    QCOMPARE(tracker.counts(), (SequenceCounts{42, 0, 40, 0, 0}));
}

void SequenceTrackerTest::restartIsDetected()
{
    SequenceTracker tracker;
    for (int i = 0; i <= 50; ++i)
        tracker.note(static_cast<std::uint8_t>(i), TimePoint());
    for (int i = 0; i < 400; ++i)
        tracker.note(static_cast<std::uint8_t>(i), TimePoint());
    // The run that revealed the restart counts neither as duplicates nor as late frames.
    QCOMPARE(tracker.counts(), (SequenceCounts{451, 0, 0, 0, 1}));
}

void SequenceTrackerTest::restartAheadCostsOneGap()
{
    SequenceTracker tracker;
    for (int i = 0; i <= 200; ++i)
        tracker.note(static_cast<std::uint8_t>(i), TimePoint());
    for (int i = 0; i < 400; ++i)
        tracker.note(static_cast<std::uint8_t>(i), TimePoint());
    // The step from 200 to 0 cannot be distinguished from 55 lost frames, but it counts only once.
    QCOMPARE(tracker.counts(), (SequenceCounts{601, 55, 0, 0, 0}));
}

void SequenceTrackerTest::announcedRestartCostsNothing()
{
    SequenceTracker tracker;
    tracker.note(200, TimePoint());
    tracker.expectRestart();
    tracker.note(0, TimePoint());
    tracker.note(1, TimePoint());
    QCOMPARE(tracker.counts(), (SequenceCounts{3, 0, 0, 0, 0}));
}

void SequenceTrackerTest::silenceIsNotCountedAcross()
{
    SequenceTracker tracker;
    tracker.note(5, TimePoint());
    tracker.note(30, TimePoint(SequenceTracker::kLongestSilence + milliseconds(1)));
    QCOMPARE(tracker.counts(), (SequenceCounts{2, 0, 0, 0, 1}));
    // A slow sender without a gap is no restart.
    tracker.note(31, TimePoint(3 * SequenceTracker::kLongestSilence));
    QCOMPARE(tracker.counts(), (SequenceCounts{3, 0, 0, 0, 1}));
}

void SequenceTrackerTest::tableKeepsSendersApart()
{
    SequenceTable table;
    const SequenceTable::Sender autopilot{LinkId{1}, 1, 1};
    const SequenceTable::Sender gimbal{LinkId{1}, 1, 154};
    const SequenceTable::Sender otherLink{LinkId{2}, 1, 1};
    for (int i = 0; i < 100; ++i) {
        table.note(autopilot, static_cast<std::uint8_t>(i), TimePoint());
        table.note(gimbal, static_cast<std::uint8_t>(200 + i), TimePoint());
        if (i % 2 == 0)
            table.note(otherLink, static_cast<std::uint8_t>(i), TimePoint());
    }
    QCOMPARE(table.counts(autopilot), (SequenceCounts{100, 0, 0, 0, 0}));
    QCOMPARE(table.counts(gimbal).lost, std::uint64_t(0));
    QCOMPARE(table.counts(otherLink), (SequenceCounts{50, 49, 0, 0, 0}));
    QCOMPARE(table.countsOfSystem(1).received, std::uint64_t(250));
    QCOMPARE(table.total().lost, std::uint64_t(49));
    QCOMPARE(table.counts({LinkId{9}, 9, 9}), SequenceCounts());
}

void SequenceTrackerTest::forgedSendersDoNotReplaceEstablishedOnes()
{
    SequenceTable table;
    const SequenceTable::Sender autopilot{LinkId{1}, 1, 1};
    const SequenceTable::Sender gimbal{LinkId{1}, 1, 154};
    std::uint64_t forged = 0;
    std::uint8_t gimbalNext = 0;
    // One minute: the autopilot at 50 Hz, the gimbal at 1 Hz, and 2000 frames/s of forged senders, each new.
    for (int ms = 0; ms < 60'000; ++ms) {
        const TimePoint now{milliseconds(ms)};
        if (ms % 20 == 0)
            table.note(autopilot, static_cast<std::uint8_t>(ms / 20), now);
        if (ms % 1000 == 0)
            table.note(gimbal, gimbalNext++, now);
        for (int i = 0; ms >= 10'000 && i < 2; ++i, ++forged)
            table.note({LinkId{1}, static_cast<std::uint8_t>(2 + forged % 250), static_cast<std::uint8_t>(forged / 250)},
                       static_cast<std::uint8_t>(forged * 7), now);
    }
    QCOMPARE(table.counts(autopilot), (SequenceCounts{3000, 0, 0, 0, 0}));
    QCOMPARE(table.counts(gimbal), (SequenceCounts{60, 0, 0, 0, 0}));
    QVERIFY(table.size() <= SequenceTable::kMostSenders);
    QCOMPARE(table.evicted(), forged - (SequenceTable::kMostSenders - 2));
    QCOMPARE(table.untracked(), std::uint64_t(0));
    // The sums keep the counts of replaced senders.
    QCOMPARE(table.total().received, 3060 + forged);
}

void SequenceTrackerTest::tableIsBounded()
{
    SequenceTable table;
    const auto note = [&table](std::uint32_t sender, int count, TimePoint now) {
        for (int i = 0; i < count; ++i)
            table.note({LinkId{sender}, 1, 1}, static_cast<std::uint8_t>(i), now);
    };
    for (std::uint32_t i = 0; i < SequenceTable::kMostSenders; ++i)
        note(i, 8, TimePoint());
    note(1000, 10, TimePoint());
    QCOMPARE(table.untracked(), std::uint64_t(10));
    QCOMPARE(table.evicted(), std::uint64_t(0));
    QCOMPARE(table.total().received, std::uint64_t(8 * SequenceTable::kMostSenders));
    // After the others became silent there is room.
    note(1000, 10, TimePoint(SequenceTable::kEstablishedFor));
    QCOMPARE(table.untracked(), std::uint64_t(10));
    QCOMPARE(table.evicted(), std::uint64_t(1));
    QCOMPARE(table.countsOfSystem(1).received, std::uint64_t(8 * SequenceTable::kMostSenders + 10));
}

SKYSEAL_TEST(SequenceTrackerTest)
#include "sequence_tracker_test.moc"
