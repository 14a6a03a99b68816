// The cost of a suite as a function of its load, against a solution of the normal equations in fractions (Python)
// and against statsmodels (tests/data/vectors/make_cost_models.py), and which
// runs it is fitted to.
#include "core/experiment/cost_model.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <array>
#include <cmath>
#include <fstream>
#include <span>
#include <sstream>
#include <vector>

using namespace skyseal;
using namespace skyseal::experiment;

namespace {

struct Observed
{
    unsigned load, launch;
    double frames, wakeUps, cost; ///< per second; ns
};
constexpr std::array<Observed, 8> kObserved{{{0, 0, 60, 60, 2013000},
                                             {0, 1, 60, 64, 2090000},
                                             {1, 0, 560, 250, 6890000},
                                             {1, 1, 560, 262, 7010000},
                                             {2, 0, 2060, 260, 11050000},
                                             {2, 1, 2060, 255, 10880000},
                                             {3, 0, 5060, 262, 18870000},
                                             {3, 1, 5060, 251, 18790000}}};
constexpr double kCoefficients[] = {749228.0173306685, 2637.135872056824, 18495.38014538162};
constexpr double kErrors[] = {55671.46022213793, 12.737910439447882, 294.0536170182829};
constexpr double kResiduals[] = {-4178.97837697504, -1160.498958501512,  40130.85797210543,  -61813.703772473986,
                                 59473.24843305284, -18049.850840039075, -68925.12802818323, 54524.05357101457};
constexpr double kStudent = 2.570581835636314; ///< 0.975 quantile of 5 degrees, by tables

/// Three launches that differ by more than their runs; one run is missing. The numbers are those of REML by full covariance
/// matrices (Python).
constexpr std::array<Observed, 11> kLaunches{{{0, 0, 60, 60, 2386000},
                                              {1, 0, 560, 250, 7290000},
                                              {2, 0, 2060, 260, 11477000},
                                              {3, 0, 5060, 262, 19261000},
                                              {0, 1, 60, 60, 1645000},
                                              {1, 1, 560, 253, 6549000},
                                              {2, 1, 2060, 260, 10673000},
                                              {3, 1, 5060, 265, 18520000},
                                              {0, 2, 60, 60, 2094000},
                                              {1, 2, 560, 256, 6998000},
                                              {2, 2, 2060, 260, 11122000}}};
constexpr double kMixed[] = {753500.1764783972, 2611.7553691938665, 18846.645393107134};
constexpr double kMixedErrors[] = {230995.62501547436, 12.301229037184001, 240.31065838754984};
constexpr double kWithin = 57270.18152795528, kBetween = 392655.29412954807;

/// One arm, whose station costs that and whose agent costs twice as much.
Results observedSweep(std::span<const Observed> observed, unsigned launches)
{
    Results out;
    out.plan.arms = {{crypto::SuiteId::Aes256Gcm}};
    out.plan.loads = {Load::paced(10), Load::paced(500), Load::paced(2000), Load::paced(5000)};
    out.plan.launches = launches;
    out.plan.repeats = 1;
    for (const Observed &one : observed) {
        Sample sample;
        sample.run = {0, one.load, 0, launches == 1 ? one.launch : 0, launches == 1 ? 0 : one.launch};
        sample.values[Metric::FrameRate] = one.frames;
        sample.values[Metric::WakeUps] = sample.values[Metric::AgentWakeUps] = one.wakeUps;
        sample.values[Metric::Cpu] = one.cost / 1e7;
        sample.values[Metric::AgentCpu] = 2 * one.cost / 1e7;
        out.samples.push_back(sample);
    }
    return out;
}

/// All runs of a single launch.
Results observedSweep()
{
    return observedSweep(kObserved, 1);
}

bool isWithin(double value, double expected, double relative)
{
    return std::abs(value - expected) <= relative * std::abs(expected);
}

} // namespace

class CostModelTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void agreesWithFractions()
    {
        const Results results = observedSweep();
        const std::vector<CostModel> models = costModels(results);
        QCOMPARE(int(models.size()), 2);
        for (const CostModel &model : models) {
            const double scale = model.end == LinkEnd::Station ? 1 : 2;
            QCOMPARE(model.fit.degrees, 5.0);
            for (std::size_t term = 0; term < CostModel::kTerms; ++term) {
                QVERIFY(isWithin(model.fit.coefficients[term], scale * kCoefficients[term], 1e-10));
                QVERIFY(isWithin(model.fit.halfWidth(term), scale * kStudent * kErrors[term], 1e-9));
            }
            for (std::size_t i = 0; i < kObserved.size(); ++i) {
                QVERIFY(std::abs(model.fit.residuals[i] - scale * kResiduals[i]) < 1e-3);
                QCOMPARE(model.runs[i], &results.samples[i]);
            }
        }
    }

    void launchesAreARandomEffect()
    {
        const CostModel model = costModels(observedSweep(kLaunches, 3)).front();
        constexpr double kOfLaunches = 4.302652729911275, kOfRuns = 2.446911851144969; // Student's t, 2 and 6 degrees
        QCOMPARE(model.launches, 3u);
        QCOMPARE(model.fit.degrees, 6.0);
        for (std::size_t term = 0; term < CostModel::kTerms; ++term) {
            QVERIFY2(isWithin(model.fit.coefficients[term], kMixed[term], 1e-6),
                     qPrintable(QString::number(model.fit.coefficients[term], 'g', 12)));
            const double student = term == CostModel::kConstant ? kOfLaunches : kOfRuns;
            QVERIFY2(isWithin(model.halfWidth(term), student * kMixedErrors[term], 1e-5),
                     qPrintable(QString::number(model.halfWidth(term), 'g', 12)));
        }
        QVERIFY(isWithin(model.fit.deviation, kWithin, 1e-5) && isWithin(model.launchDeviation, kBetween, 1e-5));
        QVERIFY(isWithin(model.fit.residuals[0],
                         kLaunches[0].cost - kMixed[0] - kMixed[1] * kLaunches[0].frames - kMixed[2] * kLaunches[0].wakeUps,
                         1e-4));
        QVERIFY(costModelHtml(observedSweep(kLaunches, 3)).find("the launch as a random effect") != std::string::npos);
    }

    void launchesAgreeWithStatsmodels()
    {
        std::ifstream in(SKYSEAL_SOURCE_DIR "/tests/data/vectors/cost_models.txt");
        std::vector<Observed> runs;
        std::array<double, 3> coefficients{}, errors{};
        int checked = 0;
        for (std::string line; std::getline(in, line);) {
            std::istringstream words(line);
            std::string kind;
            words >> kind;
            if (kind == "cost")
                runs.clear();
            if (kind == "run") {
                Observed &run = runs.emplace_back();
                words >> run.launch >> run.load >> run.frames >> run.wakeUps >> run.cost;
            }
            if (kind == "fit") {
                for (double &value : coefficients)
                    words >> value;
                for (double &value : errors)
                    words >> value;
            }
            if (kind != "deviation")
                continue;
            double within = 0, between = 0;
            words >> within >> between;
            const CostModel model = costModels(observedSweep(runs, runs.back().launch + 1)).front();
            QCOMPARE(model.launches, runs.back().launch + 1);
            for (std::size_t term = 0; term < CostModel::kTerms; ++term) {
                QVERIFY2(std::abs(model.fit.coefficients[term] - coefficients[term]) < 1e-3 * errors[term], line.c_str());
                QVERIFY2(isWithin(model.fit.errors[term], errors[term], 1e-3), line.c_str());
            }
            QVERIFY2(isWithin(model.fit.deviation, within, 1e-3), line.c_str());
            QVERIFY2(isWithin(model.launchDeviation, between, 1e-3), line.c_str());
            ++checked;
        }
        QCOMPARE(checked, 3);
    }

    /// As by chance: the launches add nothing.
    void equalLaunchesAreThoseOfOne()
    {
        const CostModel together = costModels(observedSweep()).front(), apart = costModels(observedSweep(kObserved, 2)).front();
        QCOMPARE(apart.launchDeviation, 0.0);
        for (std::size_t term = 0; term < CostModel::kTerms; ++term)
            QVERIFY(isWithin(apart.fit.coefficients[term], together.fit.coefficients[term], 1e-9)
                    && apart.halfWidth(term) > together.halfWidth(term)); // fewer degrees of freedom
        QVERIFY(std::isnan(together.launchDeviation));
    }

    void runsThatDoNotCount()
    {
        Results results = observedSweep();
        Sample extra = results.samples.front();
        extra.values[Metric::Cpu] = 99;
        extra.invalid = "the generator missed 5 % of its sends";
        results.samples.push_back(extra);
        extra.invalid = {};
        results.plan.loads.push_back(Load::Saturated);
        extra.run.load = 4;
        results.samples.push_back(extra);
        QCOMPARE(costModels(results).front().runs.size(), kObserved.size());
    }

    void oneRateIsNoModel()
    {
        Results results = observedSweep();
        for (Sample &sample : results.samples)
            sample.run.load = 0;
        QVERIFY(costModels(results).empty());
        QVERIFY(costModelHtml(results).find("Not fitted") != std::string::npos);
        results.plan.loads = {Load::Natural};
        QVERIFY(costModelHtml(results).empty());
    }

    void reportShowsIntervalsAndResiduals()
    {
        const std::string html = costModelHtml(observedSweep());
        for (const char *text :
             {"2,637 ± 33", "18,495 ± 756", "749 ± 143", "residuals at 5000 frames/s (%)", "-0.0375 (≤ 0.365)"})
            QVERIFY2(html.find(text) != std::string::npos, (std::string(text) + " in " + html).c_str());
    }
};

SKYSEAL_TEST_APPLESS(CostModelTest)
#include "cost_model_test.moc"
