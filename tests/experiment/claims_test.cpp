// The claims of the paper: the load and link that each is judged under, the margin, and what is said where nothing is decided.
#include "core/experiment/claims.h"
#include "core/experiment/claims_csv.h"
#include "core/experiment/contrast.h"
#include "core/experiment/sweep_json.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtTest/QTest>

#include <algorithm>
#include <cmath>

using namespace skyseal;
using namespace skyseal::experiment;
using crypto::SuiteId;

namespace {

Plan planOf(std::vector<Load> loads, std::vector<const char *> conditions = {"clean"})
{
    Plan out;
    for (const crypto::SuiteInfo &info : crypto::suites())
        out.arms.push_back({info.id, false});
    out.loads = std::move(loads);
    out.conditions.clear();
    for (const char *condition : conditions)
        out.conditions.push_back(*parseCondition(condition));
    out.repeats = 5;
    return out;
}

/// `of` gives the mean of a metric in a run; the noise is up to 1 %.
template<typename Mean> Results measured(Plan plan, Metric metric, Mean of)
{
    Results out;
    out.plan = std::move(plan);
    for (const Run &run : schedule(out.plan)) {
        Sample sample;
        sample.run = run;
        const double noise = (static_cast<double>((run.repeat * 3 + run.arm) % 5) - 2) * 0.005;
        sample.values[metric] = of(out.plan.arms[run.arm].suite, run) * (1 + noise);
        out.samples.push_back(sample);
    }
    return out;
}

Claim theClaim(const Results &results, std::string_view key)
{
    const std::vector<Claim> claims = paperClaims(results);
    return *std::ranges::find(claims, key, &Claim::key);
}

bool says(const Claim &claim, const char *text)
{
    return claim.reason.find(text) != std::string::npos;
}

} // namespace

class ClaimsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eachHasItsLoad();
    void anotherLoadIsNamed();
    void packetsOfAnyValidSaturatedLoad();
    void slightlyIsMoreThanTheMargin();
    void decidableMarginDecides_data();
    void decidableMarginDecides();
    void smallerMarginsMayDecideToo();
    void exactRatiosHaveNoInterval();
    void numbersAreInTheFiles();
    void memoryHasAnOrdering();
};

void ClaimsTest::eachHasItsLoad()
{
    const Plan plan = planOf({Load::Saturated, Load::Natural});
    const Results cpu = measured(plan, Metric::CpuPerFrame, [](SuiteId suite, const Run &run) {
        return suite != SuiteId::ChaCha20 ? 1000.0 : run.load == 1 ? 800.0 : 1200.0;
    });
    const Claim natural = theClaim(cpu, "cpu-least-station");
    QCOMPARE(natural.finding, Finding::Confirmed);
    QVERIFY2(says(natural, ", natural load, framing"), natural.reason.c_str());
    const Results packets = measured(plan, Metric::Packets, [](SuiteId suite, const Run &run) {
        return suite != SuiteId::ChaCha20 ? 1000.0 : run.load == 0 ? 1200.0 : 800.0;
    });
    const Claim saturated = theClaim(packets, "packets-best");
    QCOMPARE(saturated.finding, Finding::Confirmed);
    QVERIFY2(says(saturated, ", saturated load, framing"), saturated.reason.c_str());
}

void ClaimsTest::anotherLoadIsNamed()
{
    const Results paced = measured(planOf({Load::Saturated, Load::paced(100), Load::paced(2000)}), Metric::AgentCpuPerFrame,
                                   [](SuiteId suite, const Run &run) {
                                       return suite != SuiteId::ChaCha20 ? 1000.0 : run.load == 2 ? 800.0 : 1200.0;
                                   });
    const Claim fastest = theClaim(paced, "cpu-least-drone");
    QCOMPARE(fastest.finding, Finding::Confirmed);
    QVERIFY2(says(fastest, "pps2000 load, since the natural one has no such ratios"), fastest.reason.c_str());
    // Where a suite has no valid run under the natural load, the claims that speak of it go elsewhere, and only these.
    Results some = measured(planOf({Load::Natural, Load::paced(100)}), Metric::CpuPerFrame,
                            [](SuiteId suite, const Run &) { return suite == SuiteId::ChaCha20 ? 800.0 : 1000.0; });
    for (Sample &sample : some.samples) {
        if (some.plan.arms[sample.run.arm].suite == SuiteId::Rc4 && sample.run.load == 0)
            sample.problem = "no vehicle was heard";
    }
    QVERIFY(says(theClaim(some, "rc4-cpu-station"), "pps100 load, since the natural one"));
    QVERIFY(says(theClaim(some, "cpu-plain-station"), ", natural load, framing"));
}

/// On a clean link nothing can be saturated here; the slow line was full.
void ClaimsTest::packetsOfAnyValidSaturatedLoad()
{
    Results results = measured(planOf({Load::Natural, Load::Saturated}, {"clean", "rate=57600"}), Metric::Packets,
                               [](SuiteId suite, const Run &) { return suite == SuiteId::ChaCha20 ? 900.0 : 1000.0; });
    for (Sample &sample : results.samples) {
        if (sample.run.load == 1 && sample.run.condition == 0)
            sample.invalid = "not saturated";
    }
    const Claim claim = theClaim(results, "packets-unharmed");
    QCOMPARE(claim.finding, Finding::Refuted);
    QVERIFY2(says(claim, "link 57,600 baud, saturated load"), claim.reason.c_str());
    for (Sample &sample : results.samples)
        sample.invalid = sample.run.load == 1 ? "not saturated" : "";
    QCOMPARE(theClaim(results, "packets-unharmed").finding, Finding::NotDecided);
    QVERIFY(std::isnan(theClaim(results, "packets-unharmed").decidable));
}

void ClaimsTest::slightlyIsMoreThanTheMargin()
{
    const auto plainAbove = [](double plain, double margin) {
        Results results = measured(planOf({Load::Saturated}), Metric::Packets,
                                   [plain](SuiteId suite, const Run &) { return suite == SuiteId::None ? plain : 1000.0; });
        results.plan.margin = margin;
        return theClaim(results, "packets-plain-above").finding;
    };
    QCOMPARE(plainAbove(1100, 0.03), Finding::Confirmed);
    QCOMPARE(plainAbove(1030, 0.03), Finding::NotDecided);
    QCOMPARE(plainAbove(1010, 0.03), Finding::Refuted); // of no practical effect
    QCOMPARE(plainAbove(1020, 0.001), Finding::Confirmed);
}

void ClaimsTest::decidableMarginDecides_data()
{
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<double>("chacha");
    for (const double chacha : {970.0, 985.0, 1000.0, 1010.0, 1030.0}) {
        for (const char *key : {"cpu-plain-station", "cpu-least-station"})
            QTest::addRow("%s, %.0f", key, chacha) << QByteArray(key) << chacha;
    }
}

/// Just that margin decides, and one that is a little smaller does not.
void ClaimsTest::decidableMarginDecides()
{
    QFETCH(QByteArray, key);
    QFETCH(double, chacha);
    Results results = measured(planOf({Load::Natural}), Metric::CpuPerFrame, [chacha](SuiteId suite, const Run &run) {
        return (suite == SuiteId::ChaCha20 ? chacha : 1000.0)
            * (1 + 0.02 * static_cast<double>((run.repeat + run.arm * run.arm) % 4));
    });
    results.plan.margin = 0.001;
    const Claim claim = theClaim(results, key.data());
    if (claim.finding != Finding::NotDecided) {
        QVERIFY(std::isnan(claim.decidable));
        return;
    }
    QVERIFY2(claim.decidable > results.plan.margin && says(claim, "% it would be "), claim.reason.c_str());
    results.plan.margin = claim.decidable * 0.9999;
    QCOMPARE(theClaim(results, key.data()).finding, Finding::NotDecided);
    results.plan.margin = claim.decidable * 1.0001;
    QVERIFY(theClaim(results, key.data()).finding != Finding::NotDecided);
    QVERIFY(std::isnan(theClaim(results, key.data()).decidable));
    if (key == "cpu-plain-station") { // equal to plain
        const auto ratios = plannedContrasts(results, 0, 0, Metric::CpuPerFrame);
        const auto plain = std::ranges::find_if(ratios, [&](const Contrast &one) {
            return results.plan.arms[one.second].suite == SuiteId::ChaCha20 && one.first == referenceArm(results.plan);
        });
        QVERIFY(plain != ratios.end());
        const double low = plain->low(), high = plain->high();
        QVERIFY(low < 1 && high > 1); // otherwise the small margin would have refuted it
        QVERIFY(std::abs(claim.decidable + 1 - std::max(high, 1 / low)) < 1e-6);
    }
}

/// "More than plain" is confirmed by a small margin and refuted by a large one; in between nothing is decided.
void ClaimsTest::smallerMarginsMayDecideToo()
{
    Results results = measured(planOf({Load::Saturated}), Metric::Packets,
                               [](SuiteId suite, const Run &) { return suite == SuiteId::None ? 1030.0 : 1000.0; });
    const Claim claim = theClaim(results, "packets-plain-above");
    QCOMPARE(claim.finding, Finding::NotDecided);
    QVERIFY2(claim.decidableBelow > 0.015 && claim.decidableBelow < 0.03 && claim.decidable > 0.03, claim.reason.c_str());
    const std::size_t small = claim.reason.find(" By a margin below "), large = claim.reason.find(" By a margin of ");
    QVERIFY2(small < large && large != std::string::npos, claim.reason.c_str());
    QVERIFY(claim.reason.find("confirmed", small) < large && claim.reason.find("refuted", large) != std::string::npos);
    const auto by = [&results](double margin) {
        results.plan.margin = margin;
        return theClaim(results, "packets-plain-above").finding;
    };
    QCOMPARE(by(claim.decidableBelow * 0.9999), Finding::Confirmed);
    QCOMPARE(by(claim.decidableBelow * 1.0001), Finding::NotDecided);
    QCOMPARE(by(claim.decidable * 0.9999), Finding::NotDecided);
    QCOMPARE(by(claim.decidable * 1.0001), Finding::Refuted);
}

void ClaimsTest::exactRatiosHaveNoInterval()
{
    Results results = measured(planOf({Load::Natural}), Metric::Memory, [](SuiteId, const Run &) { return 20e6; });
    for (const SweepArm &arm : results.plan.arms)
        results.contextBytes[arm.suite] = arm.suite == SuiteId::Rc4 ? 2e6 : 400;
    const Claim claim = theClaim(results, "rc4-memory");
    QCOMPARE(claim.finding, Finding::Confirmed);
    QVERIFY2(says(claim, "rc4 to chacha20 1.09998;") && !says(claim, " to 1."), claim.reason.c_str());
}

/// A reader of the files needs no sentence to know what decided, and what margin would have.
void ClaimsTest::numbersAreInTheFiles()
{
    Results results = measured(planOf({Load::Saturated}), Metric::Packets,
                               [](SuiteId suite, const Run &) { return suite == SuiteId::None ? 1030.0 : 1000.0; });
    const std::vector<Claim> claims = paperClaims(results);
    const Claim claim = theClaim(results, "packets-plain-above");
    QCOMPARE(claim.ratios.size(), std::size_t(1));
    const ClaimRatio &ratio = claim.ratios.front();
    QCOMPARE(ratio.first + ratio.second, std::string("nonechacha20"));
    QVERIFY(std::abs(ratio.ratio - 1.03) < 0.01 && ratio.low < ratio.ratio && ratio.ratio < ratio.high);

    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(sweepJson(results, {}))).object();
    QJsonObject written;
    for (const QJsonValue one : json[QLatin1String("claims")].toArray()) {
        if (one[QLatin1String("key")] == QLatin1String("packets-plain-above"))
            written = one.toObject();
    }
    QCOMPARE(written[QLatin1String("decidable_margin")].toDouble(), claim.decidable);
    QCOMPARE(written[QLatin1String("decidable_below")].toDouble(), claim.decidableBelow);
    const QJsonObject one = written[QLatin1String("ratios")].toArray().first().toObject();
    QCOMPARE(one[QLatin1String("ratio")].toDouble(), ratio.ratio);
    QCOMPARE(one[QLatin1String("ci95_low")].toDouble(), ratio.low);
    QCOMPARE(one[QLatin1String("ci95_high")].toDouble(), ratio.high);

    const QStringList lines = QString::fromStdString(claimsCsv(results, claims)).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    const QStringList columns = lines.first().split(QLatin1Char(','));
    QStringList row;
    for (const QString &line : lines) {
        QCOMPARE(line.count(QLatin1Char(',')), columns.size() - 1);
        if (line.startsWith(QLatin1String("packets-plain-above,")))
            row = line.split(QLatin1Char(','));
    }
    const auto cell = [&](const char *name) { return row.value(columns.indexOf(QLatin1String(name))).toDouble(); };
    QVERIFY(std::abs(cell("ci95_low") - ratio.low) < 1e-5 && std::abs(cell("ci95_high") - ratio.high) < 1e-5);
    QVERIFY(std::abs(cell("decidable_margin") - claim.decidable) < 1e-5);
    QVERIFY(std::abs(cell("decidable_below") - claim.decidableBelow) < 1e-5);
    QCOMPARE(QString::fromStdString(claimColumnsCsv()).count(QLatin1Char('\n')), columns.size() + 1);
}

void ClaimsTest::memoryHasAnOrdering()
{
    Results results = measured(planOf({Load::Natural}), Metric::CpuPerFrame, [](SuiteId, const Run &) { return 1000.0; });
    for (Sample &sample : results.samples)
        sample.values[Metric::Memory] = 20e6;
    results.contextBytes = {
        {SuiteId::ChaCha20, 2000}, {SuiteId::Aes256Ctr, 4000}, {SuiteId::Aes256Cbc, 6000}, {SuiteId::Rc4, 1000}};
    const std::vector<Ordering> all = orderings(results);
    QCOMPARE(all.back().quantity, std::string("Memory of the process, the least first"));
    QCOMPARE(all.back().here, std::string("plain 1, rc4 1.00005, chacha20 1.0001, aes-256-ctr 1.0002, aes-256-cbc 1.0003"));
    QVERIFY(says(theClaim(results, "memory-plain"), "a suite would have to take 600 kB more"));
}

SKYSEAL_TEST_APPLESS(ClaimsTest)
#include "claims_test.moc"
