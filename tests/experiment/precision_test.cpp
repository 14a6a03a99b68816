// How many launches a wanted precision takes: what is said from a pilot is what longer sweeps of the same kind reach.
#include "core/experiment/precision.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <cmath>
#include <random>

using namespace skyseal;
using namespace skyseal::experiment;
using crypto::SuiteId;

namespace {

/// `deviation`: of an arm's cost from launch to launch.
Results sweepOf(unsigned launches, double deviation, unsigned seed)
{
    Results out;
    out.plan.arms = {{SuiteId::None}, {SuiteId::ChaCha20}, {SuiteId::Rc4}, {SuiteId::Aes256Gcm}};
    out.plan.launches = launches;
    out.plan.repeats = 1;
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, deviation);
    for (const Run &run : schedule(out.plan)) {
        Sample sample;
        sample.run = run;
        sample.values[Metric::CpuPerFrame] = 1000 * std::exp(noise(random));
        out.samples.push_back(sample);
    }
    return out;
}

} // namespace

class PrecisionTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pilotForeseesTheLaunches()
    {
        double foreseen = 0, halfWidth = 0;
        constexpr int kSweeps = 200;
        for (unsigned seed = 0; seed < kSweeps; ++seed)
            foreseen += precisionOf(sweepOf(10, 0.05, seed), 0.03)->launchesNeeded / double(kSweeps);
        const auto launches = static_cast<unsigned>(foreseen);
        QVERIFY2(launches > 15 && launches < 40, qPrintable(QString::number(launches))); // 2 * (2 * 0.05 / 0.03)^2 is 22
        for (unsigned seed = 1000; seed < 1000 + kSweeps; ++seed)
            halfWidth += precisionOf(sweepOf(launches, 0.05, seed), 0.03)->halfWidth / kSweeps;
        QVERIFY2(std::abs(halfWidth - 0.03) < 0.002, qPrintable(QString::number(halfWidth)));
    }

    void reachedGoalNeedsNoMore()
    {
        const auto precise = precisionOf(sweepOf(10, 0.001, 1), 0.03);
        QVERIFY(precise && precise->halfWidth < 0.003 && precise->launchesNeeded <= 10);
    }

    void nothingIsSaidWithoutAnInterval()
    {
        QVERIFY(!precisionOf(sweepOf(1, 0.05, 1), 0.03)); // of one launch, whatever its blocks say
        QVERIFY(!precisionOf(Results(), 0.03));
        QCOMPARE(launchesIn(sweepOf(7, 0.05, 1)), 7u);
    }

    void loadWithoutValidRunsIsNotPrecise()
    {
        Results results = sweepOf(10, 0.001, 1);
        results.plan.loads.push_back(results.plan.loads.front());
        QVERIFY(!precisionOf(results, 0.03)); // The second load has no run at all.
        results = sweepOf(10, 0.001, 1);
        for (Sample &sample : results.samples) {
            if (results.plan.arms[sample.run.arm].suite == SuiteId::Rc4)
                sample.invalid = "not saturated";
        }
        QVERIFY(!precisionOf(results, 0.03));
    }
};

SKYSEAL_TEST_APPLESS(PrecisionTest)
#include "precision_test.moc"
