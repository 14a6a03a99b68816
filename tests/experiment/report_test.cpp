// Figures and report: what is drawn is what was measured, text is safe to show, claims are judged by significance alone.
#include "core/experiment/analysis.h"
#include "core/experiment/bar_chart.h"
#include "core/experiment/contrast.h"
#include "core/experiment/forest_chart.h"
#include "core/experiment/html_report.h"
#include "core/experiment/report_figures.h"
#include "core/experiment/sweep_csv.h"
#include "core/experiment/sweep_json.h"
#include "core/experiment/sweep_text.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QSet>
#include <QtCore/QXmlStreamReader>
#include <QtTest/QTest>

#include <cmath>

using namespace skyseal;
using namespace skyseal::experiment;
using crypto::SuiteId;

namespace {

/// Every suite, five repeats under the saturated load; `of` gives the mean of a suite, the noise is ±1 %.
template<typename Mean> Results resultsWith(Metric metric, Mean of)
{
    Results out;
    for (const crypto::SuiteInfo &info : crypto::suites())
        out.plan.arms.push_back({info.id, false});
    out.plan.arms.push_back({SuiteId::ChaCha20, true});
    out.plan.loads = {Load::Saturated};
    out.plan.repeats = 5;
    out.complete = true;
    for (const Run &run : schedule(out.plan)) {
        Sample sample;
        sample.run = run;
        sample.order = static_cast<unsigned>(out.samples.size());
        sample.seconds = 5;
        const double noise = (static_cast<double>((run.repeat * 3 + run.arm) % 5) - 2) * 0.005;
        sample.values[metric] = of(out.plan.arms[run.arm].suite) * (1 + noise);
        out.samples.push_back(sample);
    }
    return out;
}

Claim claimOf(const Results &results, std::string_view key)
{
    for (const Claim &claim : paperClaims(results)) {
        if (claim.key == key)
            return claim;
    }
    qFatal("no such claim");
}

Finding findingOf(const Results &results, std::string_view key)
{
    return claimOf(results, key).finding;
}

bool isXml(const std::string &text)
{
    QXmlStreamReader xml(QString::fromStdString(text));
    while (!xml.atEnd())
        xml.readNext();
    if (xml.hasError())
        qWarning("%s in line %lld", qPrintable(xml.errorString()), static_cast<long long>(xml.lineNumber()));
    return !xml.hasError();
}

double attribute(const QXmlStreamReader &xml, const char *name)
{
    return xml.attributes().value(QLatin1String(name)).toDouble();
}

} // namespace

class ReportTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void barsAreTheMeans();
    void figuresFitAColumn();
    void axisSteps_data();
    void axisSteps();
    void insecureIsSaidSo();
    void unmeasuredIsSaidSo();
    void lossIsInPerCent();
    void claimsFollowSignificance();
    void unharmedNeedsAsManyPackets();
    void unharmedNeedsSureness();
    void smallDifferencesAreNoClaim();
    void memoryIsOfOneKind();
    void claimsAreOfTheCleanLink();
    void dronesCpuIsJudgedAsWell();
    void residentMemoryHasNoInterval();
    void noIntervalBelowZero();
    void nothingLostHasABound();
    void shareEndsAtOne();
    void runsAreCounted();
    void howPlainTravelsIsSaid();
    void noiseIsNoDifference();
    void untestedIsSaidSo();
    void ratioToNothingIsNull();
    void noiseIsJudgedAsSuitesAre();
    void comparedIsWhatThePaperCompared();
    void singleRunsAreNotCompared();
    void framingsAreTold();
    void invalidRunsAreLeftOut();
    void memoryIsATable();
    void tablesNameSweepAndMachine();
    void reportIsWholeAndSafe();
};

void ReportTest::barsAreTheMeans()
{
    const Results results = resultsWith(Metric::CpuPerFrame,
                                        [](SuiteId suite) { return 1000.0 + 100 * static_cast<double>(suite); });
    const BarChart chart = chartOf(results, 0, 0, Metric::CpuPerFrame);
    QCOMPARE(chart.bars.size(), results.plan.arms.size());
    QXmlStreamReader xml(QString::fromStdString(svg(chart)));
    std::vector<double> widths, dots;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == QLatin1String("rect") && xml.attributes().hasAttribute(QLatin1String("stroke")))
            widths.push_back(attribute(xml, "width"));
        if (xml.name() == QLatin1String("circle"))
            dots.push_back(attribute(xml, "cx"));
    }
    QVERIFY(!xml.hasError());
    QCOMPARE(widths.size(), chart.bars.size());
    QCOMPARE(dots.size(), results.samples.size()); // every single run is shown
    for (std::size_t arm = 0; arm < widths.size(); ++arm) {
        const double mean = summarise(valuesOf(results, {0, 0, arm}, Metric::CpuPerFrame)).mean;
        QCOMPARE(chart.bars[arm].mean, mean);
        QVERIFY(std::abs(widths[arm] / widths[0] - mean / chart.bars[0].mean) < 0.002); // from zero, in proportion
    }
}

/// 88 mm are 333 pixels of 1/96 inch, and 7 pt are 9.33. DejaVu Sans, by which they are drawn, has 0.65 of its size for a wide
/// mean of such texts.
void ReportTest::figuresFitAColumn()
{
    Results results = resultsWith(Metric::CpuPerFrame, [](SuiteId suite) { return 1000.0 + 100 * static_cast<double>(suite); });
    results.plan.conditions = {*parseCondition("loss=0.05,delay=20,rate=57600")};
    const std::vector<ReportFigure> figures = figuresOf(results);
    QVERIFY(figures.size() >= 2);
    QVERIFY(figures.front().name.starts_with("ratio-") && !figures.back().name.starts_with("ratio-"));
    for (const ReportFigure &figure : figures) {
        QXmlStreamReader xml(QString::fromStdString(figure.svg));
        double height = 0;
        int texts = 0;
        while (!xml.atEnd()) {
            if (xml.readNext() != QXmlStreamReader::StartElement)
                continue;
            if (xml.name() == QLatin1String("svg")) {
                QCOMPARE(attribute(xml, "width"), 333.0);
                height = attribute(xml, "height");
            }
            if (xml.name() != QLatin1String("text"))
                continue;
            const double size = attribute(xml, "font-size"), x = attribute(xml, "x"), y = attribute(xml, "y");
            const QString anchor = xml.attributes().value(QLatin1String("text-anchor")).toString();
            const QString text = xml.readElementText();
            QVERIFY2(size >= 9.34, qPrintable(text));
            const double width = 0.65 * size * static_cast<double>(text.size());
            const double left = anchor == QLatin1String("end") ? x - width
                : anchor == QLatin1String("middle")            ? x - width / 2
                                                               : x;
            QVERIFY2(left > -8 && left + width < 333 + 30 && y < height, qPrintable(text));
            ++texts;
        }
        QVERIFY(!xml.hasError() && texts > 10);
    }
}

void ReportTest::axisSteps_data()
{
    QTest::addColumn<double>("highest");
    QTest::addColumn<double>("step");
    QTest::newRow("nothing") << 0.0 << 0.2;
    QTest::newRow("one") << 1.0 << 0.2;
    QTest::newRow("7") << 7.0 << 1.0;
    QTest::newRow("9") << 9.0 << 2.0;
    QTest::newRow("38") << 38.0 << 5.0;
    QTest::newRow("120000") << 120000.0 << 20000.0;
}

void ReportTest::axisSteps()
{
    QFETCH(double, highest);
    QFETCH(double, step);
    QVERIFY2(std::abs(axisStep(highest) / step - 1) < 1e-9, qPrintable(QString::number(axisStep(highest))));
}

void ReportTest::insecureIsSaidSo()
{
    const std::string text = svg(chartOf(resultsWith(Metric::Packets, [](SuiteId) { return 50.0; }), 0, 0, Metric::Packets));
    QVERIFY(text.find("rc4 sealed (insecure)") != std::string::npos);
    QVERIFY(text.find("aes-256-gcm sealed (insecure)") == std::string::npos);
}

void ReportTest::unmeasuredIsSaidSo()
{
    const Results results = resultsWith(Metric::OpenP50,
                                        [](SuiteId suite) { return suite == SuiteId::None ? std::nan("") : 5.0; });
    const std::string text = svg(chartOf(results, 0, 0, Metric::OpenP50));
    QVERIFY(text.find("not measured") != std::string::npos);
    QVERIFY(text.find("nan") == std::string::npos);
}

void ReportTest::lossIsInPerCent()
{
    const BarChart chart = chartOf(resultsWith(Metric::Loss, [](SuiteId) { return 0.05; }), 0, 0, Metric::Loss);
    QVERIFY(std::abs(chart.bars[0].mean - 5) < 0.1);
    QCOMPARE(chart.axis, std::string("Frames lost, %"));
    const auto none = [](SuiteId) { return 0.0; };
    const std::string nothing = svg(chartOf(resultsWith(Metric::Overhead, none), 0, 0, Metric::Overhead));
    for (const char *tick : {">0<", ">0.2<", ">0.8<", ">1<"}) // an axis, though there is nothing on it
        QVERIFY2(nothing.find(tick) != std::string::npos, tick);
    const std::string unknown = svg(chartOf(resultsWith(Metric::Loss, none), 0, 0, Metric::Loss)); // nor of any frame counted
    QVERIFY(unknown.find(">100<") != std::string::npos && unknown.find(">120<") == std::string::npos);
}

void ReportTest::claimsFollowSignificance()
{
    const auto cpu = [](double chacha) {
        return resultsWith(Metric::CpuPerFrame,
                           [chacha](SuiteId suite) { return suite == SuiteId::ChaCha20 ? chacha : 1000.0; });
    };
    QCOMPARE(findingOf(cpu(800), "cpu-least-station"), Finding::Confirmed);
    QCOMPARE(findingOf(cpu(1200), "cpu-least-station"), Finding::Refuted);
    QCOMPARE(findingOf(cpu(1000), "cpu-least-station"), Finding::Refuted); // known to be equal, which is not less
    QCOMPARE(findingOf(cpu(1000), "cpu-plain-station"), Finding::Confirmed);
    QCOMPARE(findingOf(cpu(1200), "cpu-plain-station"), Finding::Refuted);
    QCOMPARE(findingOf(cpu(800), "rc4-cpu-station"), Finding::Refuted); // not above AES
    const auto worst = resultsWith(Metric::CpuPerFrame, [](SuiteId suite) { return suite == SuiteId::Rc4 ? 1500.0 : 1000.0; });
    QCOMPARE(findingOf(worst, "rc4-cpu-station"), Finding::Confirmed);
    QVERIFY(orderings(worst).at(0).here.find("rc4 1.5 (") > orderings(worst).at(0).here.find("plain 1,"));
    QCOMPARE(findingOf(cpu(800), "packets-best"), Finding::NotDecided); // packets were not measured there
    const auto packets = resultsWith(Metric::Packets,
                                     [](SuiteId suite) { return suite == SuiteId::ChaCha20 ? 1200.0 : 1000.0; });
    QCOMPARE(findingOf(packets, "packets-best"), Finding::Confirmed); // more is better
    for (const double chacha : {800.0, 1000.0, 1200.0}) {
        QCOMPARE(findingOf(cpu(chacha), "battery"), Finding::NotDecided);         // energy
        QCOMPARE(findingOf(cpu(chacha), "confidentiality"), Finding::NotDecided); // confidentiality
    }
}

void ReportTest::unharmedNeedsAsManyPackets()
{
    const auto packets = [](double chacha) {
        return resultsWith(Metric::Packets, [chacha](SuiteId suite) { return suite == SuiteId::ChaCha20 ? chacha : 1000.0; });
    };
    QCOMPARE(findingOf(packets(1001), "packets-unharmed"), Finding::Confirmed);
    QCOMPARE(findingOf(packets(1100), "packets-unharmed"), Finding::Confirmed);
    QCOMPARE(findingOf(packets(900), "packets-unharmed"), Finding::Refuted);
    Results natural = packets(1001);
    natural.plan.loads = {Load::Natural};
    QCOMPARE(findingOf(natural, "packets-unharmed"), Finding::NotDecided); // the vehicle sets that rate
}

void ReportTest::unharmedNeedsSureness()
{
    // The same mean, scattered so much that it says nothing: a difference of a tenth would not be found either.
    Results results = resultsWith(Metric::Packets, [](SuiteId) { return 1000.0; });
    for (Sample &sample : results.samples)
        sample.values[Metric::Packets] = 1000 + 100 * (static_cast<double>((sample.run.repeat * 3 + sample.run.arm) % 5) - 2);
    QCOMPARE(findingOf(results, "packets-unharmed"), Finding::NotDecided);
}

/// A session has more than its cipher: the two are not mixed where one suite's session was not measured.
void ReportTest::memoryIsOfOneKind()
{
    Results results = resultsWith(Metric::Memory, [](SuiteId) { return 20e6; });
    for (Sample &sample : results.samples) {
        results.contextBytes[results.plan.arms[sample.run.arm].suite] = 400;
        if (results.plan.arms[sample.run.arm].suite != SuiteId::Rc4)
            sample.values[Metric::SessionMemory] = 5000;
    }
    const Claim rc4 = claimOf(results, "rc4-memory");
    QCOMPARE(rc4.finding, Finding::Refuted);
    QVERIFY2(rc4.reason.find("5,000") == std::string::npos && rc4.reason.find("keyed cipher") != std::string::npos,
             rc4.reason.c_str());
    const Claim plain = claimOf(results, "memory-plain");
    QCOMPARE(plain.finding, Finding::Confirmed);
    QVERIFY2(plain.reason.find("chacha20 5,000 B, none 0 B") != std::string::npos, plain.reason.c_str());
}

void ReportTest::smallDifferencesAreNoClaim()
{
    // Never varying, so that any difference is significant: it must matter as well.
    for (const double chacha : {995.0, 1005.0}) {
        Results results = resultsWith(Metric::CpuPerFrame, [](SuiteId) { return 1000.0; });
        for (Sample &sample : results.samples)
            sample.values[Metric::CpuPerFrame] = results.plan.arms[sample.run.arm].suite == SuiteId::ChaCha20 ? chacha : 1000;
        QCOMPARE(findingOf(results, "cpu-least-station"), Finding::Refuted);
    }
}

void ReportTest::claimsAreOfTheCleanLink()
{
    Results results;
    results.plan.arms = {{SuiteId::Aes256Cbc}, {SuiteId::Aes256Ctr}, {SuiteId::ChaCha20}, {SuiteId::Rc4}};
    results.plan.loads = {Load::Saturated};
    results.plan.conditions = {*parseCondition("loss=0.05"), *parseCondition("clean")};
    results.plan.repeats = 3;
    for (const Run &run : schedule(results.plan)) {
        Sample sample;
        sample.run = run;
        const bool chacha = results.plan.arms[run.arm].suite == SuiteId::ChaCha20;
        sample.values[Metric::CpuPerFrame] = (chacha ? (run.condition == 0 ? 2000 : 500) : 1000) + run.repeat;
        results.samples.push_back(sample);
    }
    const Claim claim = claimOf(results, "cpu-least-station");
    QCOMPARE(claim.finding, Finding::Confirmed);
    QVERIFY2(claim.reason.find("link clean") != std::string::npos, claim.reason.c_str());
    results.plan.conditions.pop_back();
    std::erase_if(results.samples, [](const Sample &sample) { return sample.run.condition == 1; });
    const Claim lossy = claimOf(results, "cpu-least-station");
    QCOMPARE(lossy.finding, Finding::Refuted);
    QVERIFY2(lossy.reason.find("link 5 % loss") != std::string::npos, lossy.reason.c_str());
}

void ReportTest::dronesCpuIsJudgedAsWell()
{
    const Results results = resultsWith(Metric::AgentCpuPerFrame,
                                        [](SuiteId suite) { return suite == SuiteId::ChaCha20 ? 800.0 : 1000.0; });
    QCOMPARE(findingOf(results, "cpu-least-station"), Finding::NotDecided); // the station's
    QCOMPARE(findingOf(results, "cpu-least-drone"), Finding::Confirmed);
}

void ReportTest::residentMemoryHasNoInterval()
{
    const Results results = resultsWith(Metric::AgentMemory,
                                        [](SuiteId suite) { return 1e7 + 1e6 * static_cast<double>(suite); });
    QVERIFY(plannedContrasts(results, 0, 0, Metric::AgentMemory).empty());
    QVERIFY(noiseContrasts(results).empty());
    const BarChart chart = chartOf(results, 0, 0, Metric::AgentMemory);
    QVERIFY(std::isnan(chart.bars[0].high) && std::isfinite(chart.bars[0].mean));
    QVERIFY2(chart.legend.find("not a suite's own") != std::string::npos, chart.legend.c_str());
    QVERIFY2(chart.legend.find("interval") == std::string::npos, chart.legend.c_str());
    QVERIFY(meanText(results, {0, 0, 1}, Metric::AgentMemory).find("±") == std::string::npos);
    QVERIFY(sweepJson(results, {}).find("\"ci95_low\":null") != std::string::npos);
}

void ReportTest::noIntervalBelowZero()
{
    // A loss in one run of five: Student's t knows nothing of shares, and would have its interval begin at -0.018.
    Results results = resultsWith(Metric::Loss, [](SuiteId) { return 0.0; });
    for (Sample &sample : results.samples)
        sample.values[Metric::Loss] = sample.run.repeat == 0 ? 0.05 : 0;
    const Summary summary = summaryOf(results, {0, 0, 1}, Metric::Loss);
    QVERIFY(summary.mean - summary.halfWidth < -0.01);
    QCOMPARE(summary.low(), 0.0);
    const std::string text = meanText(results, {0, 0, 1}, Metric::Loss);
    QVERIFY2(text.starts_with("0.010 (≤ 0.038)"), text.c_str());
    const BarChart chart = chartOf(results, 0, 0, Metric::Loss);
    QCOMPARE(chart.bars[1].low, 0.0);
    QVERIFY(svg(chart).find("1.0 (≤ 3.8)") != std::string::npos);
    const std::string json = sweepJson(results, {});
    QVERIFY(json.substr(0, json.find("\"noise\":")).find("\"ci95_low\":-") == std::string::npos); // differences can be negative
}

/// That nothing was lost of 880 frames does not say that nothing ever is.
void ReportTest::nothingLostHasABound()
{
    Results results = resultsWith(Metric::Loss, [](SuiteId) { return 0.0; });
    for (Sample &sample : results.samples) {
        sample.values[Metric::Packets] = 176;
        sample.begin.rx.good = 500;
        sample.end.rx.good = 500 + 60;
        sample.values[Metric::RecordLoss] = sample.run.repeat == 0 ? std::nan("") : 0; // such a run's records do not count
        sample.values[Metric::RecordLossUp] = 0;                                       // of no record at all
    }
    QVERIFY(std::abs(summaryOf(results, {0, 0, 1}, Metric::Loss).high() - (1 - std::pow(0.05, 1 / 880.0))) < 1e-12);
    QCOMPARE(meanText(results, {0, 0, 1}, Metric::Loss), std::string("0 (≤ 0.0034)"));
    QCOMPARE(meanText(results, {0, 0, 1}, Metric::RecordLoss), std::string("0 (≤ 0.012)"));
    QCOMPARE(summaryOf(results, {0, 0, 1}, Metric::RecordLossUp).high(), 1.0);
    QVERIFY(svg(chartOf(results, 0, 0, Metric::Loss)).find("0 (≤ 0.34)") != std::string::npos);
    std::erase_if(results.samples, [](const Sample &sample) { return sample.run.repeat > 0; });
    QCOMPARE(meanText(results, {0, 0, 1}, Metric::Loss), std::string("0 (≤ 0.017)")); // of one run, too
    // A quantity that is not a share needs no such bound.
    results = resultsWith(Metric::Overhead, [](SuiteId) { return 0.0; });
    QCOMPARE(meanText(results, {0, 0, 1}, Metric::Overhead), std::string("0 ± 0"));
}

void ReportTest::shareEndsAtOne()
{
    Results results = resultsWith(Metric::Loss, [](SuiteId) { return 0.8; });
    for (Sample &sample : results.samples)
        sample.values[Metric::Loss] = sample.run.repeat == 0 ? 0.4 : 0.9; // 0.80 ± 0.28
    const Summary summary = summaryOf(results, {0, 0, 1}, Metric::Loss);
    QVERIFY(summary.mean + summary.halfWidth > 1.05);
    QCOMPARE(summary.high(), 1.0);
    const std::string text = meanText(results, {0, 0, 1}, Metric::Loss);
    QVERIFY2(text.starts_with("0.80 (≥ 0.52)"), text.c_str());
    const std::string figure = svg(chartOf(results, 0, 0, Metric::Loss));
    QVERIFY(figure.find(">100<") != std::string::npos && figure.find(">120<") == std::string::npos);
    // Of both ends: all between none and all.
    for (Sample &sample : results.samples)
        sample.values[Metric::Loss] = sample.run.repeat % 2 == 0 ? 0.95 : 0.05;
    QVERIFY(summaryOf(results, {0, 0, 1}, Metric::Loss).low() >= 0 && summaryOf(results, {0, 0, 1}, Metric::Loss).high() <= 1);
}

void ReportTest::runsAreCounted()
{
    Results results = resultsWith(Metric::Packets, [](SuiteId) { return 1000.0; });
    QVERIFY(endedEarly(results).empty() && failedRuns(results).empty());
    QCOMPARE(runsText(results), std::string("5 runs"));
    results.samples.front().problem = "no vehicle was heard";
    results.samples.front().values = {};
    QCOMPARE(runsText(results), std::string("4 to 5 runs"));
    const std::string failed = failedRuns(results).text();
    QVERIFY2(failed.starts_with("1 of 40 runs failed: ") && failed.ends_with(" (saturated load): no vehicle was heard"),
             failed.c_str());
    const std::string page = htmlReport({results, {}, {}, {}});
    QVERIFY(page.find("Means of 4 to 5 runs each") != std::string::npos
            && page.find("1 of 40 runs failed") != std::string::npos);

    Results severalLinks = results;
    severalLinks.plan.conditions.push_back({"loss=0.05", {}});
    severalLinks.samples[0].run.condition = 1;
    QVERIFY(failedRuns(severalLinks).text().ends_with(" (saturated load, link loss=0.05): no vehicle was heard"));

    results.complete = false;
    QCOMPARE(endedEarly(results).text(), std::string("was given up or cancelled after its last run"));
    results.samples.resize(2);
    QCOMPARE(endedEarly(results).text(), std::string("ended after 2 of 40 runs"));
    QCOMPARE(runsText(results), std::string("1 run"));
    QVERIFY(htmlReport({results, {}, {}, {}}).find("ended after 2 of 40 runs") != std::string::npos);
    const std::string legend = chartOf(results, 0, 0, Metric::Packets).legend;
    QVERIFY2(legend.starts_with("1 run of 5 s") && legend.find("interval") == std::string::npos, legend.c_str());
    QVERIFY(sweepText(results).back().find("ended after 2 of 40") != std::string::npos);
}

void ReportTest::howPlainTravelsIsSaid()
{
    Results results = resultsWith(Metric::Packets, [](SuiteId) { return 1000.0; });
    const char *note = "joins the frames of one wake-up";
    QVERIFY(htmlReport({results, {}, {}, {}}).find(note) != std::string::npos);
    results.plan.arms.erase(results.plan.arms.begin()); // plain MAVLink
    results.samples.clear();
    QVERIFY(htmlReport({results, {}, {}, {}}).find(note) == std::string::npos);
}

void ReportTest::noiseIsNoDifference()
{
    const Results results = resultsWith(Metric::Packets, [](SuiteId) { return 1000.0; });
    const std::vector<Contrast> noise = noiseContrasts(results);
    QCOMPARE(noise.size(), std::size_t(1)); // nothing else was measured
    QVERIFY(noise[0].metric == Metric::Packets && !noise[0].significant());
    QCOMPARE(results.plan.arms[noise[0].first].suite, SuiteId::ChaCha20);
    QVERIFY(results.plan.arms[noise[0].second].again);
    // Six suites with plain MAVLink, and six pairs of the claims; the repeated arm is no suite.
    QCOMPARE(plannedContrasts(results, 0, 0, Metric::Packets).size(), std::size_t(12));
}

/// Where there was no test, no file claims that there was one.
void ReportTest::untestedIsSaidSo()
{
    Results results = resultsWith(Metric::Packets, [](SuiteId) { return 1000.0; });
    results.plan.repeats = 3;
    std::erase_if(results.samples, [](const Sample &sample) { return sample.run.repeat >= 3; });
    for (Sample &sample : results.samples)
        sample.values[Metric::Packets] = 1000 + 10 * static_cast<double>(sample.run.arm);
    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(sweepJson(results, {}))).object();
    for (const char *list : {"comparisons", "noise"}) {
        const QJsonArray pairs = json[QLatin1String(list)].toArray();
        QVERIFY(!pairs.isEmpty());
        for (const QJsonValue pair : pairs) {
            for (const char *key : {"p", "p_holm", "significant", "ci95_low", "ci95_high"})
                QVERIFY2(pair.toObject().contains(QLatin1String(key)) && pair[QLatin1String(key)].isNull(), key);
            QCOMPARE(pair[QLatin1String("step")].toDouble(), 2.0);
        }
    }
    const std::string page = htmlReport({results, {}, {}, paperClaims(results)});
    QVERIFY(page.find(">cannot be said<") != std::string::npos);
    QVERIFY(page.find("not measured often enough for an interval") != std::string::npos);
    for (const Claim &claim : paperClaims(results))
        QCOMPARE(claim.finding, Finding::NotDecided);
}

/// A share of nothing is no number, and no text either.
void ReportTest::ratioToNothingIsNull()
{
    const Results results = resultsWith(Metric::RecordLoss,
                                        [](SuiteId suite) { return suite == SuiteId::Aes256Gcm ? 0.1 : 0.0; });
    const std::string json = sweepJson(results, {});
    QVERIFY(json.find("\"ratio\"") == std::string::npos && json.find("\"significant\":true") != std::string::npos);
    QVERIFY(json.find("Infinity") == std::string::npos);
}

/// The same suite twice, held to both criteria: as any two suites are, and over all such tests of the sweep.
void ReportTest::noiseIsJudgedAsSuitesAre()
{
    Results results = resultsWith(Metric::CpuPerFrame, [](SuiteId) { return 1000.0; });
    results.plan.arms = {{SuiteId::ChaCha20}, {SuiteId::ChaCha20, true}};
    std::erase_if(results.samples, [](const Sample &sample) { return sample.run.arm > 1; });
    for (Sample &sample : results.samples) {
        const double noise = 0.01 * (static_cast<double>(sample.run.repeat) - 2) / std::sqrt(2.5); // deviation 0.01
        const double heat = 1000 + 50 * sample.run.repeat;                                         // of the block, cancels
        const bool again = sample.run.arm == 1;
        sample.values[Metric::CpuPerFrame] = heat * std::exp(again ? 0.02 + noise : 0);
        for (const Metric metric : {Metric::Cpu, Metric::AgentCpu, Metric::Latency, Metric::OpenP50, Metric::WirePerFrame})
            sample.values[metric] = heat * std::exp(again ? noise : 0);
    }
    const std::vector<Contrast> all = noiseContrasts(results);
    QCOMPARE(all.size(), std::size_t(6));
    const auto found = std::ranges::find(all, Metric::CpuPerFrame, &Contrast::metric);
    QVERIFY(found->significantAlone() && !found->significant());
    const std::string page = htmlReport({results, {}, {}, {}});
    const std::size_t begin = page.find("machine's noise");
    const std::size_t row = page.find("CPU time per frame, station</td>", begin);
    const std::string line = page.substr(row, page.find("</tr>", row) - row);
    // The paired t test of the logarithms: t = 0.02 / (0.01 / sqrt(5)) with 4 degrees of freedom; SciPy: ttest_1samp.
    QVERIFY2(line.find("<td>1.02 (1.01 to 1.03)</td><td>0.0111</td><td>differs</td><td>0.0663</td><td>no difference</td>")
                 != std::string::npos,
             line.c_str());
    QVERIFY(page.find("over all 6 A/A tests") != std::string::npos);
    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(sweepJson(results, {}))).object();
    for (const QJsonValue noise : json[QLatin1String("noise")].toArray()) {
        if (noise[QLatin1String("metric")] != QLatin1String("cpu_per_frame"))
            continue;
        QVERIFY(noise[QLatin1String("significant_alone")].toBool() && !noise[QLatin1String("significant")].toBool(true));
        QVERIFY(std::abs(noise[QLatin1String("ci95_low")].toDouble() - 1.007612) < 1e-6);
        QVERIFY(std::abs(noise[QLatin1String("ci95_high")].toDouble() - 1.032947) < 1e-6);
    }
}

/// The differences contain the quantities that the paper compared, and none by which suites are not compared.
void ReportTest::comparedIsWhatThePaperCompared()
{
    Results results = resultsWith(Metric::Packets, [](SuiteId suite) { return 1000.0 + static_cast<double>(suite); });
    for (Sample &sample : results.samples) {
        for (const Metric metric : {Metric::FrameRate, Metric::Cpu, Metric::AgentCpu, Metric::Loss, Metric::RecordLoss,
                                    Metric::Memory, Metric::AgentMemory})
            sample.values[metric] = sample.values[Metric::Packets] / 1e4;
    }
    const std::string page = htmlReport({results, {}, {}, {}});
    for (const auto &[from, to] : {std::pair("Ratios to plain MAVLink</h3>", "Pairs that a claim"),
                                   std::pair("machine's noise", "The paper's claims")}) {
        const std::size_t begin = page.find(from);
        const std::string part = page.substr(begin, page.find(to, begin) - begin);
        for (const char *title : {"Packets transmitted", "Rate", "CPU load, station", "CPU load, agent", "Frames lost",
                                  "Records lost, to the station"})
            QVERIFY2(
                part.find(std::string(title) + (std::string_view(title).find("lost") < 20 ? ", difference in %</td>" : "</td>"))
                    != std::string::npos,
                title);
        QVERIFY(part.find("Memory") == std::string::npos);
    }
}

void ReportTest::singleRunsAreNotCompared()
{
    Results results;
    results.plan.arms = armsOf({SuiteId::None, SuiteId::Aes256Gcm}, {experiment::ArmFraming::Sealed}, false);
    results.plan.repeats = 1;
    for (const Run &run : schedule(results.plan)) {
        Sample sample;
        sample.run = run;
        sample.values[Metric::Packets] = 100;
        results.samples.push_back(sample);
    }
    const std::string page = htmlReport({results, {}, {}, {}});
    QVERIFY(page.find("No two suites were measured twice each") != std::string::npos);
}

void ReportTest::framingsAreTold()
{
    Results results;
    results.plan.arms = armsOf({SuiteId::None, SuiteId::Aes256Gcm, SuiteId::ChaCha20},
                               {experiment::ArmFraming::Sealed, experiment::ArmFraming::Inline}, false);
    results.plan.repeats = 2;
    for (const Run &run : schedule(results.plan)) {
        Sample sample;
        sample.run = run;
        sample.order = static_cast<unsigned>(results.samples.size());
        sample.values[Metric::Packets] = 100 + run.repeat + static_cast<double>(run.arm);
        results.samples.push_back(sample);
    }
    QCOMPARE(results.plan.arms.size(), std::size_t(5));
    QCOMPARE(results.samples.size(), std::size_t(8)); // AES-256-GCM is not inline
    const std::string figure = svg(chartOf(results, 0, 0, Metric::Packets));
    for (const char *label :
         {">none (insecure)<", ">chacha20 sealed<", ">chacha20 inline<", ">aes-256-gcm inline<", ">not in this framing<"})
        QVERIFY2(figure.find(label) != std::string::npos, label);
    QVERIFY(figure.find("not measured") == std::string::npos);

    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(sweepJson(results, {}))).object();
    const QJsonObject plan = json[QLatin1String("plan")].toObject();
    QCOMPARE(plan[QLatin1String("framings")].toArray(), QJsonArray({QStringLiteral("sealed"), QStringLiteral("inline")}));
    QStringList arms;
    for (const QJsonValue arm : plan[QLatin1String("arms")].toArray()) {
        arms << arm[QLatin1String("suite")].toString() + QLatin1Char(' ') + arm[QLatin1String("framing")].toString();
        QCOMPARE(arm[QLatin1String("in_framing")].toBool(), arms.last() != QLatin1String("aes-256-gcm inline"));
    }
    QCOMPARE(arms,
             QStringList({QStringLiteral("none plain"), QStringLiteral("aes-256-gcm sealed"), QStringLiteral("chacha20 sealed"),
                          QStringLiteral("aes-256-gcm inline"), QStringLiteral("chacha20 inline")}));
    QSet<QString> told;
    for (const QJsonValue summary : json[QLatin1String("summaries")].toArray())
        told << summary[QLatin1String("suite")].toString() + QLatin1Char(' ') + summary[QLatin1String("framing")].toString();
    QCOMPARE(told.size(), 4);
    QVERIFY(sweepCsv(results).find(",chacha20,inline,0,") != std::string::npos);

    const auto figures = figuresOf(results);
    const auto claims = paperClaims(results);
    const std::string html = htmlReport({results, figures, {}, claims});
    QVERIFY(html.find("not in this framing") != std::string::npos);
    QVERIFY(html.find("framing inline") != std::string::npos);         // that the claims are judged in
    QVERIFY(plannedContrasts(results, 0, 0, Metric::Packets).empty()); // under the natural load
    results.plan.loads = {Load::Saturated};
    QCOMPARE(plannedContrasts(results, 0, 0, Metric::Packets).size(), std::size_t(3)); // each against plain MAVLink
}

void ReportTest::invalidRunsAreLeftOut()
{
    Results results = resultsWith(Metric::CpuPerFrame, [](SuiteId suite) { return suite == SuiteId::Rc4 ? 5000.0 : 1000.0; });
    const auto rc4 = static_cast<std::size_t>(std::ranges::find(results.plan.arms, SuiteId::Rc4, &SweepArm::suite)
                                              - results.plan.arms.begin());
    QVERIFY(invalidRuns(results).empty());
    const std::size_t pairs = plannedContrasts(results, 0, 0, Metric::CpuPerFrame).size();
    std::size_t left = 0;
    for (Sample &sample : results.samples) {
        if (sample.run.arm != rc4 || left == 4)
            continue;
        ++left;
        sample.values[Metric::CpuPerFrame] = 9e9;
        sample.invalid = "not saturated: nothing reached 95 % (41 % of the station's core)";
        sample.attempts = 3;
    }
    // One value is left, which is no comparison; the nonsense of the others is in no mean.
    QCOMPARE(summaryOf(results, {0, 0, rc4}, Metric::CpuPerFrame).count, std::size_t(1));
    QVERIFY(summaryOf(results, {0, 0, rc4}, Metric::CpuPerFrame).mean < 6000);
    const auto compared = plannedContrasts(results, 0, 0, Metric::CpuPerFrame);
    QVERIFY(compared.size() < pairs);
    for (const Contrast &pair : compared)
        QVERIFY(pair.first != rc4 && pair.second != rc4);
    const std::string said = "4 of " + std::to_string(results.samples.size()) + " runs are not valid";
    QVERIFY(invalidRuns(results).text().starts_with(said));
    const std::string page = htmlReport({results, {}, {}, {}});
    QVERIFY(page.find(said) < page.find("<h2>Figures"));
    QVERIFY(page.find("left out of every comparison, not saturated") != std::string::npos);
    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(sweepJson(results, {}))).object();
    int valid = 0;
    for (const QJsonValue sample : json[QLatin1String("samples")].toArray()) {
        valid += sample[QLatin1String("valid")].toBool();
        QCOMPARE(sample[QLatin1String("valid")].toBool(), sample[QLatin1String("invalid")].isUndefined());
        QCOMPARE(sample[QLatin1String("attempts")].toInt(), sample[QLatin1String("valid")].toBool() ? 1 : 3);
    }
    QCOMPARE(valid, static_cast<int>(results.samples.size()) - 4);
    const QByteArray csv = QByteArray::fromStdString(sweepCsv(results));
    QCOMPARE(csv.count(",0,3,\"not saturated: "), qsizetype(4));
    const QByteArray ratios = QByteArray::fromStdString(ratiosCsv(results));
    for (const auto &[table, dictionary] : {std::pair(csv, sweepColumnsCsv()), {ratios, ratioColumnsCsv()}}) {
        const QByteArrayList described = QByteArray::fromStdString(dictionary).trimmed().split('\n').mid(1);
        const QByteArrayList names = table.left(table.indexOf('\n')).split(',');
        QCOMPARE(described.size(), names.size());
        for (qsizetype i = 0; i < names.size(); ++i) {
            QVERIFY2(described[i].startsWith(names[i] + ",\""), described[i].constData());
            QVERIFY2(described[i].size() > names[i].size() + 15, described[i].constData());
        }
    }
    QVERIFY(runText(results.plan, *std::ranges::find(results.samples, 3u, &Sample::attempts), 10, 0)
                .find("NOT VALID, not saturated")
            != std::string::npos);
}

void ReportTest::memoryIsATable()
{
    Results results = resultsWith(Metric::Memory, [](SuiteId) { return 24e6; });
    QVERIFY(htmlReport({resultsWith(Metric::CpuPerFrame, [](SuiteId) { return 1.0; }), {}, {}, {}}).find("<h2>Memory")
            == std::string::npos);
    const auto ofRc4 = [&](const Sample &sample) { return results.plan.arms[sample.run.arm].suite == SuiteId::Rc4; };
    const auto last = std::ranges::find_if(results.samples.rbegin(), results.samples.rend(), ofRc4);
    last->values[Metric::Memory] = 25.5e6;
    last->values[Metric::SessionMemory] = 12'300;
    results.contextBytes[SuiteId::Rc4] = 1'234;
    const std::string page = htmlReport({results, {}, {}, {}});
    QVERIFY2(page.find("to 25.5</td><td>–</td><td>12.3</td><td>1.23</td>") != std::string::npos,
             page.substr(page.find("<h2>Memory"), 2000).c_str());
    QVERIFY(std::ranges::none_of(figuresOf(results),
                                 [](const ReportFigure &figure) { return figure.name.find("memory") != std::string::npos; }));
}

void ReportTest::tablesNameSweepAndMachine()
{
    Results results = resultsWith(Metric::CpuPerFrame, [](SuiteId suite) { return 1000.0 + static_cast<double>(suite); });
    results.plan.seed = 77;
    results.setting = {
        {"time", "2026-11-26T10:42:25Z"}, {"processor", "a \"fast\" one"}, {"cores", "2"}, {"commit", "3244914b"}};
    for (const std::string &table : {sweepCsv(results), ratiosCsv(results)}) {
        const QByteArrayList lines = QByteArray::fromStdString(table).trimmed().split('\n');
        QVERIFY(lines.size() > 5);
        QVERIFY(lines[0].endsWith(",sweep,seed,commit,machine"));
        for (const QByteArray &line : lines.mid(1))
            QVERIFY(line.endsWith(R"(,"2026-11-26T10:42:25Z","77","3244914b","a ""fast"" one, 2 cores")"));
    }
}

void ReportTest::reportIsWholeAndSafe()
{
    Results results = resultsWith(Metric::Packets, [](SuiteId suite) { return 1000.0 + static_cast<double>(suite); });
    results.setting = {{"command_line", "sweep --expect '1<2' <script>alert(1)</script>"}};
    const auto figures = figuresOf(results);
    QCOMPARE(figures.size(), std::size_t(2)); // the ratios and the means; nothing else was measured
    QVERIFY(isXml(figures[0].svg) && isXml(figures[1].svg));
    const auto claims = paperClaims(results);
    const auto verdicts = judge(*Expectation::parse("packets>=1"), results);
    const std::string html = htmlReport({results, figures, verdicts, claims});
    QVERIFY(isXml(html.substr(html.find("<html"))));
    QVERIFY(html.find("<script") == std::string::npos);
    QVERIFY(html.find("http") == html.find("http://www.w3.org/2000/svg")); // loads nothing
    QVERIFY(html.find("<svg") != std::string::npos);
    for (const char *part : {"Packets transmitted", "The machine's noise", "The paper's claims", "Every run", "packets&gt;=1"})
        QVERIFY2(html.find(part) != std::string::npos, part);
    QVERIFY(printReport({results, figures, verdicts, claims}).find("figures/packets-saturated.svg") != std::string::npos);
}

SKYSEAL_TEST_APPLESS(ReportTest)
#include "report_test.moc"
