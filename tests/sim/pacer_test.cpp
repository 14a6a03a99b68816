// The schedule of an open-loop load on a simulated clock: it does not drift, a late generator makes up for little, and each
// send that was not made is counted.
#include "core/sim/pacer.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace std::chrono_literals;
using sim::Pacer;

namespace {

constexpr TimePoint kStart{1000s};

} // namespace

class PacerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sendsAreDueOneByOne()
    {
        Pacer pacer(4, kStart);
        QCOMPARE(pacer.take(kStart - 1ns), std::uint64_t(0));
        for (int i = 0; i < 100; ++i) {
            const TimePoint due = kStart + i * 250ms;
            QCOMPARE(pacer.nextDue(), due);
            QCOMPARE(pacer.take(due - 1ns), std::uint64_t(0));
            QCOMPARE(pacer.take(due), std::uint64_t(1));
            QCOMPARE(pacer.take(due), std::uint64_t(0));
        }
        QCOMPARE(pacer.missed(), std::uint64_t(0));
    }

    /// Called when it asks to be, for a day: as many sends as the rate says, at a rate that divides no clock.
    void doesNotDrift()
    {
        Pacer pacer(7, kStart);
        std::uint64_t sent = 0;
        while (pacer.nextDue() < kStart + 24h)
            sent += pacer.take(pacer.nextDue());
        QCOMPARE(sent, std::uint64_t(24 * 3600 * 7));
        QCOMPARE(pacer.due(), sent);
        QCOMPARE(pacer.missed(), std::uint64_t(0));
    }

    void highestRateForAYear()
    {
        Pacer pacer(1'000'000, kStart);
        const TimePoint late = kStart + 365 * 24h;
        pacer.take(late);
        QCOMPARE(pacer.due(), std::uint64_t(365) * 24 * 3600 * 1'000'000 + 1);
        QCOMPARE(pacer.nextDue(), late + 1us);
    }

    /// Sends of the patience are made up for, those before it are not.
    void pauseIsCountedAsMissed()
    {
        Pacer pacer(1000, kStart);
        QCOMPARE(pacer.take(kStart), std::uint64_t(1));
        QCOMPARE(pacer.take(kStart + 20ms), std::uint64_t(20)); // just within it
        QCOMPARE(pacer.missed(), std::uint64_t(0));
        QCOMPARE(pacer.take(kStart + 520ms), std::uint64_t(20)); // 501…520
        QCOMPARE(pacer.missed(), std::uint64_t(480));            // 21…500
        QCOMPARE(pacer.due(), std::uint64_t(521));
        QCOMPARE(pacer.nextDue(), kStart + 521ms); // the schedule stays as it was
    }

    void failedSendsAreMissed()
    {
        Pacer pacer(100, kStart);
        QCOMPARE(pacer.take(kStart + 10ms), std::uint64_t(2));
        pacer.fail(1);
        QCOMPARE(pacer.missed(), std::uint64_t(1));
        QCOMPARE(pacer.due(), std::uint64_t(2));
    }

    void clockMayStandStill()
    {
        Pacer pacer(1000, kStart);
        pacer.take(kStart + 5ms);
        QCOMPARE(pacer.take(kStart + 3ms), std::uint64_t(0));
        QCOMPARE(pacer.due(), std::uint64_t(6));
    }
};

SKYSEAL_TEST_APPLESS(PacerTest)
#include "pacer_test.moc"
