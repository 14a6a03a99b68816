// Statistics against values that others published: tables of Student's t, NIST's certified univariate data, Welch tests
// worked out with R, Holm's procedure; and what must hold for any samples.
#include "core/experiment/statistics.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace skyseal::experiment;

namespace {

bool near(double a, double b, double tolerance)
{
    if (std::abs(a - b) <= tolerance)
        return true;
    qWarning("%.15g and %.15g differ by more than %g", a, b, tolerance);
    return false;
}

} // namespace

class StatisticsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void studentTable_data();
    void studentTable();
    void closedForms();
    void quantileInvertsProbability();
    void certifiedMeansAndDeviations();
    void intervalOfAPublishedSample();
    void nothingAndOne();
    void outliersAreMarkedAndKept();
    void quartilesAsSpreadsheetsHaveThem();
    void noneSeenIsNotNone();
    void holmsExample();
    void holmIsBetweenNothingAndBonferroni();
};

void StatisticsTest::studentTable_data()
{
    // NIST/SEMATECH e-Handbook of Statistical Methods, 1.3.6.7.2.
    QTest::addColumn<double>("share");
    QTest::addColumn<double>("degrees");
    QTest::addColumn<double>("value");
    const auto row = [](double share, double degrees, double value) {
        QTest::addRow("%g at %g", degrees, share) << share << degrees << value;
    };
    row(0.90, 1, 3.078);
    row(0.95, 1, 6.314);
    row(0.975, 1, 12.706);
    row(0.99, 1, 31.821);
    row(0.975, 2, 4.303);
    row(0.995, 2, 9.925);
    row(0.975, 4, 2.776);
    row(0.90, 5, 1.476);
    row(0.975, 9, 2.262);
    row(0.995, 10, 3.169);
    row(0.999, 10, 4.144);
    row(0.95, 20, 1.725);
    row(0.975, 29, 2.045);
    row(0.975, 30, 2.042);
    row(0.975, 100, 1.984);
    row(0.975, 1e7, 1.960);
}

void StatisticsTest::studentTable()
{
    QFETCH(double, share);
    QFETCH(double, degrees);
    QFETCH(double, value);
    QVERIFY(near(studentQuantile(share, degrees), value, 0.0005001));
    QVERIFY(near(studentQuantile(1 - share, degrees), -value, 0.0005001));
}

void StatisticsTest::closedForms()
{
    for (const double share : {0.51, 0.6, 0.9, 0.975, 0.9999}) {
        // One degree of freedom is Cauchy's distribution; two have an algebraic quantile.
        QVERIFY(near(studentQuantile(share, 1) / std::tan(M_PI * (share - 0.5)), 1, 1e-11));
        const double a = 4 * share * (1 - share);
        QVERIFY(near(studentQuantile(share, 2) / (2 * (share - 0.5) * std::sqrt(2 / a)), 1, 1e-11));
    }
    QCOMPARE(studentQuantile(0.5, 3), 0.0);
}

void StatisticsTest::quantileInvertsProbability()
{
    QVERIFY(rc::check("twoSided(quantile(p)) = 2(1-p)", [] {
        const double degrees = *rc::gen::inRange(5, 5000) / 10.0;
        const double share = 0.5 + *rc::gen::inRange(1, 4999) / 10000.0;
        const double back = studentTwoSided(studentQuantile(share, degrees), degrees);
        RC_ASSERT(std::abs(back / (2 * (1 - share)) - 1) < 1e-9);
    }));
}

void StatisticsTest::certifiedMeansAndDeviations()
{
    // NIST Statistical Reference Datasets, NumAcc1 to NumAcc4: few digits of variation behind many of the mean.
    const Summary small = summarise(std::vector<double>{10000001, 10000003, 10000002});
    QCOMPARE(small.mean, 10000002.0);
    QCOMPARE(small.deviation, 1.0);
    for (const double base : {1.0, 1000000.0, 10000000.0}) {
        std::vector<double> values{base + 0.2};
        for (int i = 0; i < 500; ++i) {
            values.push_back(base + 0.1);
            values.push_back(base + 0.3);
        }
        const Summary summary = summarise(values);
        QVERIFY(near(summary.mean, base + 0.2, base * 1e-13));
        QVERIFY(near(summary.deviation, 0.1, 1e-8));
        QCOMPARE(summary.count, std::size_t(1001));
    }
}

void StatisticsTest::intervalOfAPublishedSample()
{
    // Student's own data (1908): additional hours of sleep under drug 2. R: mean 2.33, sd 2.002249,
    // t.test's interval 0.8976775 to 3.7623225.
    const Summary summary = summarise(std::vector<double>{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4});
    QVERIFY(near(summary.mean, 2.33, 1e-12));
    QVERIFY(near(summary.deviation, 2.002249, 5e-7));
    QVERIFY(near(summary.low(), 0.8976775, 5e-8));
    QVERIFY(near(summary.high(), 3.7623225, 5e-8));
    QCOMPARE(summary.min, -0.1);
    QCOMPARE(summary.max, 5.5);
    QVERIFY(near(summary.median, 1.75, 1e-12));
}

void StatisticsTest::nothingAndOne()
{
    const Summary none = summarise(std::vector<double>{kNaN});
    QCOMPARE(none.count, std::size_t(0));
    QVERIFY(std::isnan(none.mean) && std::isnan(none.halfWidth) && std::isnan(none.max));
    const Summary one = summarise(std::vector<double>{7});
    QCOMPARE(one.mean, 7.0);
    QVERIFY(std::isnan(one.deviation) && std::isnan(one.halfWidth));
    QCOMPARE(one.max, 7.0);
}

void StatisticsTest::outliersAreMarkedAndKept()
{
    const std::vector<double> samples{10, 11, kNaN, 10, 40, 11, 10};
    const Summary summary = summarise(samples);
    QCOMPARE(summary.outliers, std::vector<std::size_t>{4});
    QCOMPARE(summary.count, std::size_t(6));
    QCOMPARE(summary.max, 40.0);
    QVERIFY(near(summary.mean, 92.0 / 6, 1e-12));
    QVERIFY(summarise(std::vector<double>{1, 1, 1, 100}).outliers.empty());
}

void StatisticsTest::quartilesAsSpreadsheetsHaveThem()
{
    // Python: statistics.quantiles([1, 2, 4, 7, 11, 16], n=4, method='inclusive') = [2.5, 5.5, 10.0]
    const std::vector<double> samples{16, 1, 7, 2, 11, 4};
    QCOMPARE(quantile(samples, 0.25), 2.5);
    QCOMPARE(quantile(samples, 0.5), 5.5);
    QCOMPARE(quantile(samples, 0.75), 10.0);
    QCOMPARE(quantile(samples, 0), 1.0);
    QCOMPARE(quantile(samples, 1), 16.0);
}

void StatisticsTest::noneSeenIsNotNone()
{
    // Hanley and Lippman-Hand, JAMA 249 (1983) 1743: the exact bounds beside 3/n.
    QVERIFY(near(boundOfNone(10), 0.26, 0.005) && near(boundOfNone(20), 0.14, 0.005) && near(boundOfNone(100), 0.03, 0.005));
    for (const double trials : {1.0, 30.0, 1000.0, 5e6}) // where that is the share, none is seen in one of twenty
        QVERIFY(near(std::pow(1 - boundOfNone(trials), trials), 0.05, 1e-8));
    QCOMPARE(boundOfNone(0), 1.0);
}

void StatisticsTest::holmsExample()
{
    // Wikipedia's worked example of the Holm–Bonferroni method.
    const std::vector<double> adjusted = holm(std::vector<double>{0.01, 0.04, 0.03, 0.005});
    const std::vector<double> expected{0.03, 0.06, 0.06, 0.02};
    for (std::size_t i = 0; i < expected.size(); ++i)
        QVERIFY(near(adjusted[i], expected[i], 1e-15));
    // A pair that was not tested is none of the family.
    const std::vector<double> withGap = holm(std::vector<double>{0.01, kNaN, 0.04, 0.03, kNaN, 0.005});
    QCOMPARE((std::vector<double>{withGap[0], withGap[2], withGap[3], withGap[5]}), adjusted);
    QVERIFY(std::isnan(withGap[1]) && std::isnan(withGap[4]));
}

void StatisticsTest::holmIsBetweenNothingAndBonferroni()
{
    QVERIFY(rc::check("p <= holm <= n p, and order is kept", [] {
        std::vector<double> p;
        for (const int value : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1001)))
            p.push_back(value / 1000.0);
        const std::vector<double> adjusted = holm(p);
        for (std::size_t i = 0; i < p.size(); ++i) {
            RC_ASSERT(adjusted[i] >= p[i]);
            RC_ASSERT(adjusted[i] <= std::min(1.0, p[i] * static_cast<double>(p.size())) + 1e-15);
            for (std::size_t j = 0; j < p.size(); ++j)
                RC_ASSERT(p[i] > p[j] || adjusted[i] <= adjusted[j]);
        }
    }));
}

SKYSEAL_TEST_APPLESS(StatisticsTest)
#include "statistics_test.moc"
