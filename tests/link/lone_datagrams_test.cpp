// When a socket expects its next datagram alone: after a run of datagrams that came apart, until some come together.
#include "core/link/lone_datagrams.h"
#include "tests/support/test_runner.h"

using namespace skyseal;
using link::LoneDatagrams;

namespace {

constexpr TimePoint kStart{std::chrono::hours(1)};

/// Passes `count` datagrams, each `apart` after the one before; returns the time of the last.
TimePoint passOneByOne(LoneDatagrams &lone, TimePoint now, Duration apart, unsigned count)
{
    for (unsigned i = 0; i < count; ++i)
        lone.note(now += apart, 1);
    return now;
}

} // namespace

class LoneDatagramsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void expectedAfterARun()
    {
        LoneDatagrams lone;
        QVERIFY(!lone.expected());
        const TimePoint now = passOneByOne(lone, kStart, LoneDatagrams::kApart, LoneDatagrams::kRun - 1);
        QVERIFY(!lone.expected());
        lone.note(now + LoneDatagrams::kApart, 1);
        QVERIFY(lone.expected());
        passOneByOne(lone, now + std::chrono::seconds(1), std::chrono::seconds(1), 1'000); // the run does not overflow
        QVERIFY(lone.expected());
    }

    void batchEndsTheRun()
    {
        LoneDatagrams lone;
        const TimePoint now = passOneByOne(lone, kStart, std::chrono::milliseconds(1), LoneDatagrams::kRun);
        QVERIFY(lone.expected());
        lone.note(now + std::chrono::milliseconds(1), 2);
        QVERIFY(!lone.expected());
        // Only a whole new run makes it expected again.
        const TimePoint later = passOneByOne(lone, now + std::chrono::milliseconds(2), std::chrono::milliseconds(1),
                                             LoneDatagrams::kRun - 1);
        QVERIFY(!lone.expected());
        lone.note(later + std::chrono::milliseconds(1), 1);
        QVERIFY(lone.expected());
    }

    void burstTakenOneByOneEndsTheRun()
    {
        LoneDatagrams lone;
        const TimePoint now = passOneByOne(lone, kStart, std::chrono::milliseconds(1), LoneDatagrams::kRun);
        lone.note(now + LoneDatagrams::kApart - std::chrono::nanoseconds(1), 1);
        QVERIFY(!lone.expected());
    }

    void seriesOfBurstsIsNeverExpectedAlone()
    {
        LoneDatagrams lone;
        TimePoint now = kStart;
        for (int burst = 0; burst < 100; ++burst) {
            lone.note(now += std::chrono::milliseconds(4), 8);
            QVERIFY(!lone.expected());
        }
    }

    void emptyReceiptIsNoLoneDatagram()
    {
        LoneDatagrams lone;
        const TimePoint now = passOneByOne(lone, kStart, std::chrono::milliseconds(1), LoneDatagrams::kRun);
        lone.note(now + std::chrono::milliseconds(1), 0);
        QVERIFY(!lone.expected());
    }
};

SKYSEAL_TEST_APPLESS(LoneDatagramsTest)
#include "lone_datagrams_test.moc"
