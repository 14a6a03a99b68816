// Differences that a sweep reports, on synthetic sweeps with known truth: the same setting twice agrees, an A/A pair differs as
// seldom as it claims, a step of the instrument is no difference and a real one is found.
#include "core/experiment/analysis.h"
#include "core/experiment/contrast.h"
#include "core/metrics/histogram.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <random>

using namespace skyseal;
using namespace skyseal::experiment;
using crypto::SuiteId;

namespace {

constexpr unsigned kSeed = 20261121;

/// Three suites and one of them again; `draw` makes the value of an arm's run.
template<typename Draw> Results sweepOf(Metric metric, unsigned repeats, Draw draw)
{
    Results out;
    out.plan.arms = {{SuiteId::ChaCha20Poly1305, false},
                     {SuiteId::Aes256Gcm, false},
                     {SuiteId::Rc4, false},
                     {SuiteId::ChaCha20Poly1305, true}};
    out.plan.loads = {Load::Saturated};
    out.plan.repeats = repeats;
    for (const Run &run : schedule(out.plan)) {
        Sample sample;
        sample.run = run;
        sample.order = static_cast<unsigned>(out.samples.size());
        sample.values[metric] = draw(run.arm);
        out.samples.push_back(sample);
    }
    return out;
}

Summary summaryOf(const Results &results, std::size_t arm, Metric metric)
{
    return summarise(valuesOf(results, {0, 0, arm}, metric));
}

Contrast comparisonOf(const Results &results, std::size_t first, std::size_t second, Metric metric)
{
    for (const Contrast &pair : plannedContrasts(results, 0, 0, metric)) {
        if (pair.first == first && pair.second == second)
            return pair;
    }
    return {};
}

bool differ(const Results &results, std::size_t first, std::size_t second, Metric metric)
{
    return comparisonOf(results, first, second, metric).significant();
}

/// The next value that a histogram's percentile can have.
double nextStep(double value)
{
    using metrics::Histogram;
    return static_cast<double>(Histogram::lastOf(Histogram::bucketOf(static_cast<std::uint64_t>(value)) + 1));
}

} // namespace

class AnalysisTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sameSettingTwiceAgrees();
    void sameSuiteTwiceSeldomDiffers();
    void noPairOfEqualSuitesDiffers();
    void realDifferenceIsFound();
    void oneStepOfAHistogramIsNoDifference_data();
    void oneStepOfAHistogramIsNoDifference();
    void framesAtTheEdgesAreNoDifference();
    void coinsAreNoDifference();
    void zeroByDefinitionIsNotCompared();
    void rareLongCallsDoNotMoveThePercentile();
    void trendIsThatOfALine();
    void trendWithTheOrderIsFound();
    void trendIsSeldomFoundWhereThereIsNone();
    void launchesThatDifferAreNoTrend();
    void invalidRunsHaveNoPartInATrend();
};

void AnalysisTest::sameSettingTwiceAgrees()
{
    std::mt19937 random(kSeed);
    std::normal_distribution<double> around(1000, 30);
    int held = 0, agreed = 0;
    constexpr int kSweeps = 3000;
    for (int i = 0; i < kSweeps; ++i) {
        const auto draw = [&](std::size_t) { return around(random); };
        const Summary first = summaryOf(sweepOf(Metric::CpuPerFrame, 5, draw), 0, Metric::CpuPerFrame);
        const Summary second = summaryOf(sweepOf(Metric::CpuPerFrame, 5, draw), 0, Metric::CpuPerFrame);
        held += first.low() <= 1000 && 1000 <= first.high();
        agreed += first.low() <= second.high() && second.low() <= first.high();
    }
    qInfo("seed %u: the interval held the truth in %.1f %%, two intervals met in %.1f %%", kSeed, 100.0 * held / kSweeps,
          100.0 * agreed / kSweeps);
    QVERIFY(held > 0.94 * kSweeps && held < 0.96 * kSweeps); // what "95 %" says
    QVERIFY(agreed > 0.985 * kSweeps);
}

void AnalysisTest::sameSuiteTwiceSeldomDiffers()
{
    std::mt19937 random(kSeed);
    std::normal_distribution<double> around(1000, 30);
    int differing = 0;
    constexpr int kSweeps = 2000;
    for (int i = 0; i < kSweeps; ++i) {
        Results results = sweepOf(Metric::CpuPerFrame, 5, [&](std::size_t) { return around(random); });
        for (Sample &sample : results.samples) {
            for (const Metric metric :
                 {Metric::Packets, Metric::Latency, Metric::AgentCpuPerFrame, Metric::ByteRate, Metric::Cpu})
                sample.values[metric] = around(random);
        }
        const std::vector<Contrast> noise = noiseContrasts(results);
        QCOMPARE(noise.size(), std::size_t(6));
        differing += std::any_of(noise.begin(), noise.end(), [](const Contrast &one) { return one.significant(); });
    }
    qInfo("seed %u: of six A/A tests any differs in %.1f %% of sweeps", kSeed, 100.0 * differing / kSweeps);
    QVERIFY(differing > 0.03 * kSweeps && differing < 0.06 * kSweeps); // one in twenty, as the report says
}

void AnalysisTest::noPairOfEqualSuitesDiffers()
{
    std::mt19937 random(kSeed);
    std::normal_distribution<double> around(1000, 30);
    int alarms = 0;
    constexpr int kSweeps = 3000;
    for (int i = 0; i < kSweeps; ++i) {
        const auto pairs = plannedContrasts(sweepOf(Metric::CpuPerFrame, 5, [&](std::size_t) { return around(random); }), 0, 0,
                                            Metric::CpuPerFrame);
        QCOMPARE(pairs.size(), std::size_t(2));
        alarms += std::any_of(pairs.begin(), pairs.end(), [](const Contrast &pair) { return pair.significant(); });
    }
    QVERIFY2(alarms < 0.06 * kSweeps, qPrintable(QString::number(alarms))); // any of the pairs, all together
}

void AnalysisTest::realDifferenceIsFound()
{
    std::mt19937 random(kSeed);
    std::normal_distribution<double> noise(0, 10);
    const Results results = sweepOf(Metric::CpuPerFrame, 5,
                                    [&](std::size_t arm) { return (arm == 1 ? 1100 : 1000) + noise(random); });
    QVERIFY(differ(results, 0, 1, Metric::CpuPerFrame));
    QVERIFY(!differ(results, 0, 2, Metric::CpuPerFrame));
}

void AnalysisTest::oneStepOfAHistogramIsNoDifference_data()
{
    QTest::addColumn<int>("metric");
    for (const Metric metric : {Metric::OpenP50, Metric::OpenP99, Metric::SealP50, Metric::SealP99})
        QTest::newRow(info(metric).key.data()) << static_cast<int>(metric);
}

void AnalysisTest::oneStepOfAHistogramIsNoDifference()
{
    QFETCH(int, metric);
    const auto cost = static_cast<Metric>(metric);
    using metrics::Histogram;
    for (auto value = static_cast<double>(Histogram::lastOf(Histogram::bucketOf(200))); value < 40000;
         value = nextStep(value)) {
        // Values that never vary: whatever differs at all has p = 0.
        const Results one = sweepOf(cost, 5, [&](std::size_t arm) { return arm == 1 ? nextStep(value) : value; });
        QVERIFY2(!differ(one, 0, 1, cost), qPrintable(QString::number(value)));
        const Results three = sweepOf(cost, 5,
                                      [&](std::size_t arm) { return arm == 1 ? nextStep(nextStep(nextStep(value))) : value; });
        QVERIFY2(differ(three, 0, 1, cost), qPrintable(QString::number(value)));
        const Results again = sweepOf(cost, 5, [&](std::size_t arm) { return arm == 3 ? nextStep(value) : value; });
        QVERIFY(!noiseContrasts(again).at(0).significant());
    }
    // A mean has no such step.
    QVERIFY(differ(sweepOf(Metric::WirePerFrame, 5, [](std::size_t arm) { return arm == 1 ? 101.0 : 100.0; }), 0, 1,
                   Metric::WirePerFrame));
}

/// Which frames fall within a run and which next to it is chance; the same count three times does not make it less so.
void AnalysisTest::framesAtTheEdgesAreNoDifference()
{
    for (const unsigned repeats : {2u, 3u, 5u, 20u}) {
        for (const std::size_t other : {1u, 3u}) { // another suite; the same again
            for (const double more : {1.0, 2.0, 3.0}) {
                Results results = sweepOf(Metric::Packets, repeats,
                                          [&](std::size_t arm) { return arm == other ? 367 + more : 367.0; });
                for (Sample &sample : results.samples)
                    sample.values[Metric::FrameRate] = sample.values[Metric::Packets] / seconds(results.plan.measure);
                const bool beyond = more > 2, tested = repeats >= 5;
                for (const Metric metric : {Metric::Packets, Metric::FrameRate}) {
                    Contrast comparison = comparisonOf(results, 0, 1, metric);
                    if (other == 3) {
                        const std::vector<Contrast> noise = noiseContrasts(results);
                        comparison = *std::ranges::find(noise, metric, &Contrast::metric);
                    }
                    QCOMPARE(std::isnan(comparison.p), !tested);
                    QCOMPARE(comparison.significant(), beyond && tested);
                    QCOMPARE(comparison.significantAlone(), beyond && tested);
                    QCOMPARE(comparison.known(), !beyond || tested);
                }
            }
        }
    }
}

/// As the count of a run comes out by the phase of its ends alone: one more or not, by a coin.
void AnalysisTest::coinsAreNoDifference()
{
    std::mt19937 random(kSeed);
    for (int i = 0; i < 2000; ++i) {
        const Results results = sweepOf(Metric::Packets, 2 + static_cast<unsigned>(i) % 3,
                                        [&](std::size_t) { return 367.0 + random() % 2; });
        for (const Contrast &pair : plannedContrasts(results, 0, 0, Metric::Packets))
            QVERIFY(!pair.significant() && pair.known());
        QVERIFY(!noiseContrasts(results).at(0).significant());
    }
}

/// Plain MAVLink has no suite to take time, and nothing around its frames: that it takes less than others is no finding.
void AnalysisTest::zeroByDefinitionIsNotCompared()
{
    for (const Metric metric : {Metric::CpuSuite, Metric::AgentCpuSuite, Metric::Overhead, Metric::Cpu}) {
        Results results = sweepOf(metric, 5, [](std::size_t arm) { return 10.0 + static_cast<double>(arm); });
        results.plan.arms = {{SuiteId::None}, {SuiteId::Aes256Gcm}, {SuiteId::Rc4}, {SuiteId::ChaCha20Poly1305}};
        QCOMPARE(plannedContrasts(results, 0, 0, metric).size(), std::size_t(metric == Metric::Cpu ? 3 : 0));
    }
}

void AnalysisTest::rareLongCallsDoNotMoveThePercentile()
{
    metrics::Histogram calls;
    calls.record(400, 1000);
    calls.record(3'000'000, 9); // the core was given away
    QVERIFY(calls.percentile(0.5) < 413 && calls.percentile(0.99) < 413);
}

/// By hand: slope 0.425, residual sum of squares 2.79075, and Student's t in closed form for three degrees of freedom.
void AnalysisTest::trendIsThatOfALine()
{
    const auto trendsOf = [](const std::vector<double> &logs) {
        Results out;
        out.plan.arms = {{SuiteId::Aes256Gcm}};
        for (const double log : logs) {
            Sample sample;
            sample.order = static_cast<unsigned>(out.samples.size());
            sample.values[Metric::CpuPerFrame] = std::exp(log);
            out.samples.push_back(sample);
        }
        return orderTrends(out);
    };
    const OrderTrend trend = trendsOf({1, 2, 1.3, 3.75, 2.25}).at(0);
    QVERIFY(std::abs(trend.perRun - std::expm1(0.425)) < 1e-12);
    const double u = 0.425 / std::sqrt(2.79075 / 3 / 10) / std::sqrt(3);
    const double p = 1 - 2 / std::acos(-1.0) * (std::atan(u) + u / (1 + u * u));
    QVERIFY2(std::abs(trend.p - p) < 1e-9, qPrintable(QString::number(trend.p, 'g', 12)));
    QCOMPARE(trendsOf({2, 4, 6, 8, 10}).at(0).p, 0.0);
    QCOMPARE(trendsOf({3, 3, 3, 3, 3}).at(0).p, 1.0);
    QVERIFY(trendsOf({3, 4}).empty()); // any line fits
}

/// Each run costs 2 per mil less than the one before it: programs that are still warming up.
void AnalysisTest::trendWithTheOrderIsFound()
{
    std::mt19937 random(kSeed);
    std::normal_distribution<double> noise(0, 10);
    Results results = sweepOf(Metric::CpuPerFrame, 10, [](std::size_t) { return 0.0; });
    for (Sample &sample : results.samples)
        sample.values[Metric::CpuPerFrame] = (1000 + 300 * static_cast<double>(sample.run.arm) + noise(random))
            * std::pow(0.998, static_cast<double>(sample.order));
    const std::vector<OrderTrend> trends = orderTrends(results);
    QCOMPARE(trends.size(), std::size_t(1));
    QCOMPARE(int(trends[0].metric), int(Metric::CpuPerFrame));
    QVERIFY2(trends[0].remains(), qPrintable(QString::number(trends[0].p)));
    QVERIFY2(std::abs(trends[0].perRun + 0.002) < 0.0005, qPrintable(QString::number(trends[0].perRun)));
}

void AnalysisTest::trendIsSeldomFoundWhereThereIsNone()
{
    std::mt19937 random(kSeed);
    std::normal_distribution<double> around(1000, 30);
    int found = 0;
    constexpr int kSweeps = 2000;
    for (int i = 0; i < kSweeps; ++i) {
        Results results = sweepOf(Metric::CpuPerFrame, 5,
                                  [&](std::size_t arm) { return around(random) + 500.0 * double(arm); });
        for (Sample &sample : results.samples)
            sample.values[Metric::Latency] = around(random);
        const auto trends = orderTrends(results);
        found += std::any_of(trends.begin(), trends.end(), [](const OrderTrend &trend) { return trend.remains(); });
    }
    qInfo("seed %u: a trend is reported in %.1f %% of sweeps that have none", kSeed, 100.0 * found / kSweeps);
    QVERIFY(found > 0.03 * kSweeps && found < 0.06 * kSweeps); // one in twenty
}

/// Programs that start anew differ by more than their runs: five starts in any order are no trend, but runs of each that become
/// cheaper are one.
void AnalysisTest::launchesThatDifferAreNoTrend()
{
    std::mt19937 random(kSeed);
    std::normal_distribution<double> ofLaunch(0, 0.1), ofRun(0, 0.01);
    const auto sweep = [&](double perRun) {
        Results out;
        out.plan.arms = {{SuiteId::None}, {SuiteId::Aes256Gcm}, {SuiteId::ChaCha20Poly1305}};
        out.plan.launches = 5;
        out.plan.repeats = 2;
        std::vector<double> launches(out.plan.launches);
        std::ranges::generate(launches, [&] { return ofLaunch(random); });
        for (const Run &run : schedule(out.plan)) {
            Sample sample;
            sample.run = run;
            sample.order = static_cast<unsigned>(out.samples.size());
            const double place = sample.order % 6;
            sample.values[Metric::CpuPerFrame] = std::exp(7 + 0.1 * static_cast<double>(run.arm) + launches[run.launch]
                                                          + perRun * place + ofRun(random));
            out.samples.push_back(sample);
        }
        return orderTrends(out).at(0);
    };
    int found = 0;
    constexpr int kSweeps = 1000;
    for (int i = 0; i < kSweeps; ++i)
        found += sweep(0).remains();
    QVERIFY2(found > 0.03 * kSweeps && found < 0.07 * kSweeps, qPrintable(QString::number(found)));
    const OrderTrend warming = sweep(-0.01);
    QVERIFY2(warming.remains() && std::abs(warming.perRun + 0.01) < 0.005, qPrintable(QString::number(warming.perRun)));
}

void AnalysisTest::invalidRunsHaveNoPartInATrend()
{
    Results results = sweepOf(Metric::CpuPerFrame, 5, [](std::size_t) { return 1000.0; });
    for (Sample &sample : results.samples) {
        sample.values[Metric::CpuPerFrame] += sample.order % 3; // not constant
        if (sample.order > 10) {
            sample.values[Metric::CpuPerFrame] *= 3;
            sample.invalid = "not saturated";
        }
    }
    for (const OrderTrend &trend : orderTrends(results))
        QVERIFY2(!trend.remains(), qPrintable(QString::number(trend.p)));
}

SKYSEAL_TEST_APPLESS(AnalysisTest)
#include "analysis_test.moc"
