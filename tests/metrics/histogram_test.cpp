// Percentiles against a sorted list, merging, and the bounds of the buckets.
#include "core/metrics/histogram.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

using namespace skyseal::metrics;

class HistogramTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void emptyGivesZeros();
    void bucketsCoverEveryValueOnce();
    void percentilesMatchASortedList();
    void sinceSubtractsAnEarlierCopy();
    void hugeValuesStayInTheLastBucket();
};

void HistogramTest::emptyGivesZeros()
{
    Histogram histogram;
    const auto summary = histogram.summary();
    QCOMPARE(summary.count, std::uint64_t(0));
    QCOMPARE(summary.min, std::uint64_t(0));
    QCOMPARE(summary.p99, std::uint64_t(0));
    QCOMPARE(summary.mean, 0.0);
}

void HistogramTest::bucketsCoverEveryValueOnce()
{
    for (std::size_t bucket = 0; bucket + 1 < Histogram::kBuckets; ++bucket) {
        const std::uint64_t last = Histogram::lastOf(bucket);
        QCOMPARE(Histogram::bucketOf(last), bucket);
        QCOMPARE(Histogram::bucketOf(last + 1), bucket + 1);
    }
}

void HistogramTest::percentilesMatchASortedList()
{
    QVERIFY(rc::check("a percentile is at least the exact one and at most 1/32 above", [] {
        const auto bits = *rc::gen::inRange(1, 40);
        const auto values = *rc::gen::nonEmpty(
            rc::gen::container<std::vector<std::uint64_t>>(rc::gen::inRange<std::uint64_t>(0, std::uint64_t(1) << bits)));
        const double share = *rc::gen::inRange(0, 1001) / 1000.0;
        Histogram histogram;
        for (const std::uint64_t value : values)
            histogram.record(value);
        auto sorted = values;
        std::sort(sorted.begin(), sorted.end());
        const auto rank = std::max<std::size_t>(1, std::size_t(std::ceil(share * double(sorted.size()))));
        const std::uint64_t exact = sorted[rank - 1];
        RC_ASSERT(histogram.percentile(share) >= exact);
        RC_ASSERT(histogram.percentile(share) <= exact + exact / 32);
        RC_ASSERT(histogram.min() == sorted.front());
        RC_ASSERT(histogram.max() == sorted.back());
    }));
}

void HistogramTest::sinceSubtractsAnEarlierCopy()
{
    Histogram all, after;
    for (const std::uint64_t value : {5u, 70u, 900u, 1u << 20})
        all.record(value);
    const Histogram earlier = all;
    QCOMPARE(all.since(earlier).count(), std::uint64_t(0));
    QCOMPARE(all.since(earlier).percentile(0.99), std::uint64_t(0));
    for (std::uint64_t i = 30; i < 3000; i += 11) {
        all.record(i);
        after.record(i);
    }
    const Histogram difference = all.since(earlier);
    QCOMPARE(difference.count(), after.count());
    QCOMPARE(difference.sum(), after.sum());
    for (int share = 0; share <= 95; ++share) // the last bucket ends at the exact maximum if that is known
        QCOMPARE(difference.percentile(share / 100.0), after.percentile(share / 100.0));
    QVERIFY(difference.max() >= after.max() && difference.max() <= after.max() + after.max() / 32);
}

void HistogramTest::hugeValuesStayInTheLastBucket()
{
    Histogram histogram;
    histogram.record(UINT64_MAX);
    histogram.record(std::chrono::nanoseconds(-5));
    QCOMPARE(histogram.percentile(1), UINT64_MAX);
    QCOMPARE(histogram.percentile(0.5), std::uint64_t(0));
}

SKYSEAL_TEST(HistogramTest)
#include "histogram_test.moc"
