// The model of a bad link: exact accounting for all settings, the same run from the same seed, and each impairment with its own
// effect only.
#include "core/impair/impairment.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>
#include <rapidcheck.h>

#include <map>
#include <set>

using namespace skyseal;
using namespace skyseal::impair;
using std::chrono::milliseconds;

class ImpairmentTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void perfectLinkChangesNothing();
    void everyDatagramIsAccountedFor();
    void sameSeedSameRun();
    void probabilitiesDoNotDisturbEachOther();
    void directionsOfOneSeedDiffer();
    void lossComesNearItsProbability();
    void corruptionFlipsOneBitOfBothCopies();
    void reorderingDelaysAndLosesNothing();
    void heldDatagramIsDeliveredWhenNothingFollows();
    void delayAndJitterStayInTheirBounds();
    void lineRateSpacesAndDropsOverflow();
    void memoryIsBounded();
};

namespace {

struct Arrival
{
    TimePoint time;
    std::uint64_t sequence;
    Bytes bytes;
    bool operator==(const Arrival &) const = default;
};

struct Run
{
    std::vector<Treatment> treatments;
    std::vector<Arrival> arrivals;
    Counters counters;
    bool operator==(const Run &) const = default;
};

/// Datagram i holds its number and padding.
Bytes datagram(int i, std::size_t size)
{
    Bytes out(size, static_cast<std::uint8_t>(i * 7));
    for (std::size_t byte = 0; byte < std::min<std::size_t>(4, size); ++byte)
        out[byte] = static_cast<std::uint8_t>(i >> (8 * byte));
    return out;
}

/// Pushes `count` datagrams, one per `every`, on a simulated clock, and runs until the last was delivered.
Run drive(const ImpairmentSettings &settings, int count, Duration every, std::size_t size = 40, std::uint64_t stream = 0)
{
    Impairment link(settings, stream);
    Run run;
    const auto drain = [&](TimePoint until) {
        while (link.nextDeadline() <= until) {
            const TimePoint now = link.nextDeadline();
            Impairment::Delivery delivery;
            while (link.pop(now, delivery))
                run.arrivals.push_back({now, delivery.sequence, Bytes(delivery.bytes.begin(), delivery.bytes.end())});
        }
    };
    TimePoint now{};
    for (int i = 0; i < count; ++i, now += every) {
        drain(now);
        run.treatments.push_back(link.push(now, datagram(i, size)));
        const Counters &c = link.counters();
        if (c.offered + c.duplicated != c.lost + c.queueFull + c.delivered + c.waiting)
            qFatal("the counters do not add up after datagram %d", i);
    }
    drain(kNever - Duration(1));
    run.counters = link.counters();
    return run;
}

ImpairmentSettings bad(std::uint64_t seed)
{
    ImpairmentSettings out;
    out.loss = 0.2;
    out.duplicate = 0.1;
    out.reorder = 0.1;
    out.corrupt = 0.05;
    out.delay = milliseconds(20);
    out.jitter = milliseconds(50);
    out.seed = seed;
    return out;
}

} // namespace

void ImpairmentTest::perfectLinkChangesNothing()
{
    const Run run = drive({}, 1000, milliseconds(1));
    QCOMPARE(run.arrivals.size(), std::size_t(1000));
    for (int i = 0; i < 1000; ++i)
        QCOMPARE(run.arrivals[std::size_t(i)], (Arrival{TimePoint(milliseconds(i)), std::uint64_t(i), datagram(i, 40)}));
    QCOMPARE(run.counters.delivered, std::uint64_t(1000));
    QCOMPARE(run.counters.outOfOrder, std::uint64_t(0));
}

void ImpairmentTest::everyDatagramIsAccountedFor()
{
    QVERIFY(rc::check("the treatments tell exactly what arrives", [] {
        ImpairmentSettings settings;
        settings.loss = *rc::gen::inRange(0, 101) / 100.0;
        settings.duplicate = *rc::gen::inRange(0, 101) / 100.0;
        settings.reorder = *rc::gen::inRange(0, 101) / 100.0;
        settings.corrupt = *rc::gen::inRange(0, 101) / 100.0;
        settings.delay = milliseconds(*rc::gen::inRange(0, 100));
        settings.jitter = milliseconds(*rc::gen::inRange(0, 100));
        settings.baud = *rc::gen::element<std::uint64_t>(0, 9600, 57600, 921600);
        settings.seed = *rc::gen::arbitrary<std::uint64_t>();
        const Run run = drive(settings, 300, milliseconds(*rc::gen::inRange(0, 30)));

        std::map<std::uint64_t, std::uint64_t> copies;
        std::uint64_t outOfOrder = 0;
        std::uint64_t newest = 0;
        for (const Arrival &arrival : run.arrivals) {
            ++copies[arrival.sequence];
            outOfOrder += arrival.sequence < newest;
            newest = std::max(newest, arrival.sequence);
        }
        Counters expected;
        for (const Treatment &treatment : run.treatments) {
            ++expected.offered;
            expected.offeredBytes += treatment.bytes;
            expected.lost += treatment.fate == Treatment::Fate::Lost;
            expected.queueFull += treatment.fate == Treatment::Fate::QueueFull;
            expected.duplicated += treatment.duplicated;
            expected.heldBack += treatment.heldBack;
            expected.corrupted += treatment.corrupted;
            RC_ASSERT(copies[treatment.sequence] == (treatment.dropped() ? 0u : treatment.duplicated ? 2u : 1u));
        }
        expected.delivered = run.arrivals.size();
        expected.deliveredBytes = 40 * run.arrivals.size();
        expected.outOfOrder = outOfOrder;
        RC_ASSERT(run.counters == expected);
    }));
}

void ImpairmentTest::sameSeedSameRun()
{
    QVERIFY(drive(bad(7), 2000, milliseconds(5)) == drive(bad(7), 2000, milliseconds(5)));
    QVERIFY(!(drive(bad(7), 2000, milliseconds(5)) == drive(bad(8), 2000, milliseconds(5))));
}

void ImpairmentTest::probabilitiesDoNotDisturbEachOther()
{
    ImpairmentSettings onlyLoss;
    onlyLoss.loss = 0.2;
    onlyLoss.seed = 42;
    const Run with = drive(bad(42), 1000, milliseconds(5));
    const Run without = drive(onlyLoss, 1000, milliseconds(5));
    for (std::size_t i = 0; i < with.treatments.size(); ++i)
        QCOMPARE(with.treatments[i].fate, without.treatments[i].fate);
}

void ImpairmentTest::directionsOfOneSeedDiffer()
{
    QVERIFY(drive(bad(7), 200, milliseconds(5), 40, 0).treatments != drive(bad(7), 200, milliseconds(5), 40, 1).treatments);
}

void ImpairmentTest::lossComesNearItsProbability()
{
    // 20,000 draws at 0.2: five standard deviations are 283. The seeds are fixed, so the result is always the same.
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        const Counters counters = drive(bad(seed), 20'000, milliseconds(1)).counters;
        QVERIFY2(counters.lost > 3717 && counters.lost < 4283, qPrintable(QString::number(counters.lost)));
        QVERIFY(counters.duplicated > 1380 && counters.duplicated < 1820);
        QVERIFY(counters.outOfOrder > 0);
    }
}

void ImpairmentTest::corruptionFlipsOneBitOfBothCopies()
{
    ImpairmentSettings settings;
    settings.corrupt = 0.5;
    settings.duplicate = 0.5;
    const Run run = drive(settings, 500, milliseconds(1), 17);
    std::set<int> bits;
    for (const Arrival &arrival : run.arrivals) {
        const Bytes original = datagram(int(arrival.sequence), 17);
        int flipped = 0;
        for (std::size_t i = 0; i < original.size(); ++i) {
            const auto difference = static_cast<unsigned>(original[i] ^ arrival.bytes[i]);
            flipped += std::popcount(difference);
            if (difference)
                bits.insert(int(i) * 8 + std::countr_zero(difference));
        }
        QCOMPARE(flipped, run.treatments[arrival.sequence].corrupted ? 1 : 0);
    }
    QVERIFY(bits.size() > 17u * 8 / 2);
}

void ImpairmentTest::reorderingDelaysAndLosesNothing()
{
    ImpairmentSettings settings;
    settings.reorder = 0.1;
    const Run run = drive(settings, 5000, milliseconds(10));
    QCOMPARE(run.counters.delivered, std::uint64_t(5000));
    QVERIFY(run.counters.heldBack > 400);
    // Nearly all held datagrams are delivered out of order; one whose successors are held as well may not be.
    QVERIFY(run.counters.outOfOrder > run.counters.heldBack * 8 / 10);
    for (const Arrival &arrival : run.arrivals)
        QVERIFY(arrival.time - TimePoint(milliseconds(10) * arrival.sequence) <= milliseconds(30));
}

void ImpairmentTest::heldDatagramIsDeliveredWhenNothingFollows()
{
    ImpairmentSettings settings;
    settings.reorder = 1;
    const Run run = drive(settings, 1, milliseconds(10));
    QCOMPARE(run.arrivals.size(), std::size_t(1));
    QCOMPARE(run.arrivals[0].time, TimePoint(Impairment::kLongestHold));
}

void ImpairmentTest::delayAndJitterStayInTheirBounds()
{
    ImpairmentSettings settings;
    settings.delay = milliseconds(30);
    settings.jitter = milliseconds(20);
    const Run run = drive(settings, 2000, milliseconds(7));
    Duration least = Duration::max();
    Duration most{};
    for (const Arrival &arrival : run.arrivals) {
        const Duration took = arrival.time - TimePoint(milliseconds(7) * arrival.sequence);
        least = std::min(least, took);
        most = std::max(most, took);
    }
    QVERIFY(least >= milliseconds(30) && least < milliseconds(31));
    QVERIFY(most <= milliseconds(50) && most > milliseconds(49));
}

void ImpairmentTest::lineRateSpacesAndDropsOverflow()
{
    ImpairmentSettings settings;
    settings.baud = 57'600; // 5760 bytes a second
    settings.lineQueueBytes = 1440;
    const Run slow = drive(settings, 100, milliseconds(10), 48);
    QCOMPARE(slow.counters.queueFull, std::uint64_t(0));
    for (const Arrival &arrival : slow.arrivals)
        QCOMPARE(arrival.time - TimePoint(milliseconds(10) * arrival.sequence), Duration(8'333'333));

    // Twice the capacity of the line: half is dropped, the rest passes at the line rate.
    const Run fast = drive(settings, 2400, milliseconds(5), 57);
    const double carried = double(fast.counters.deliveredBytes) / seconds(fast.arrivals.back().time.time_since_epoch());
    QVERIFY2(carried > 5700 && carried < 5820, qPrintable(QString::number(carried)));
    QVERIFY(fast.counters.queueFull > 1100 && fast.counters.queueFull < 1250);
    QCOMPARE(fast.counters.outOfOrder, std::uint64_t(0));
}

void ImpairmentTest::memoryIsBounded()
{
    ImpairmentSettings settings;
    settings.delay = std::chrono::hours(1);
    settings.duplicate = 0.5;
    const Run run = drive(settings, 20'000, milliseconds(1), 1);
    QVERIFY(run.counters.queueFull > 10'000);
    QVERIFY(run.counters.delivered <= Impairment::kMostWaiting);
    QCOMPARE(run.counters.offered + run.counters.duplicated, run.counters.queueFull + run.counters.delivered);
}

SKYSEAL_TEST(ImpairmentTest)
#include "impairment_test.moc"
