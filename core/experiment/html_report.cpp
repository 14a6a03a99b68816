#include "core/experiment/html_report.h"

#include "core/experiment/analysis.h"
#include "core/experiment/bar_chart.h"
#include "core/experiment/disturbances.h"
#include "core/experiment/setting.h"
#include "core/experiment/sweep_text.h"

#include <algorithm>
#include <cmath>

namespace skyseal::experiment {

namespace {

constexpr const char *kStyle =
    "body{font-family:'DejaVu Sans',Verdana,sans-serif;font-size:14px;line-height:1.45;max-width:1180px;margin:2em auto;"
    "padding:0 1em;color:#111;background:#fff}h1{font-size:24px}h2{font-size:19px;margin-top:2em;border-bottom:1px solid #ccc}"
    "h3{font-size:15px}table{border-collapse:collapse;font-size:12px;margin:.6em 0}th,td{border:1px solid #ccc;padding:3px 7px;"
    "text-align:right;white-space:nowrap}th:first-child,td:first-child{text-align:left}"
    "td.text{text-align:left;white-space:normal}th{background:#f0f3f7}.insecure{color:#a33c10}"
    ".bad{color:#c00000;font-weight:bold}.wide{overflow-x:auto}figure{margin:1em 0}svg{max-width:100%;height:auto}";

std::string row(const std::vector<std::string> &cells, const char *tag = "td")
{
    std::string out = "<tr>";
    for (const std::string &cell : cells)
        out += std::string("<") + tag + ">" + cell + "</" + tag + ">";
    return out + "</tr>\n";
}

std::string armText(const SweepArm &arm)
{
    return isInsecure(arm) ? "<span class=\"insecure\">" + escaped(name(arm)) + " (insecure)</span>" : escaped(name(arm));
}

std::string placeText(const Plan &plan, std::size_t condition, std::size_t load)
{
    return "link " + escaped(conditionText(plan.conditions[condition])) + "; " + std::string(name(plan.loads[load])) + " load";
}

template<typename Each> void forEachPlace(const Plan &plan, Each each)
{
    for (std::size_t condition = 0; condition < plan.conditions.size(); ++condition) {
        for (std::size_t load = 0; load < plan.loads.size(); ++load)
            each(condition, load);
    }
}

std::string summaryTable(const Results &results, std::size_t condition, std::size_t load)
{
    const Plan &plan = results.plan;
    std::vector<std::string> head{"metric"};
    for (const SweepArm &arm : plan.arms)
        head.push_back(armText(arm));
    std::vector<std::string> framings{"framing"};
    for (const SweepArm &arm : plan.arms)
        framings.emplace_back(framingName(arm));
    std::string out = "<table border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n" + row(head, "th") + row(framings, "th");
    for (const MetricInfo &metric : metrics()) {
        std::vector<std::string> cells{
            escaped(std::string(metric.title) + (metric.unit.empty() ? "" : ", " + std::string(metric.unit)))};
        bool any = false;
        for (std::size_t arm = 0; arm < plan.arms.size(); ++arm) {
            cells.push_back(meanText(results, {condition, load, arm}, metric.metric));
            any = any || (exists(plan.arms[arm]) && cells.back() != "–");
        }
        if (any)
            out += row(cells);
    }
    return out + "</table>\n";
}

/// "aes-256-gcm is 12 % lower than chacha20 (p = 0.003)"
std::string pairText(const Plan &plan, const ArmComparison &pair)
{
    const double second = pair.firstMean + pair.comparison.test.difference;
    const bool lower = second < pair.firstMean;
    const double percent = 100 * std::abs(second / pair.firstMean - 1);
    const auto named = [&plan](std::size_t arm) { return escaped(fullName(plan.arms[arm])); };
    std::string out = named(pair.second) + (lower ? " lower than " : " higher than ") + named(pair.first);
    if (std::isfinite(percent))
        out += " by " + readable(percent) + " %";
    const double p = pair.comparison.adjusted;
    return out + (p < 0.001 ? " (p &lt; 0.001)" : " (p = " + readable(p) + ")");
}

std::string differences(const Results &results, std::size_t condition, std::size_t load)
{
    std::string out = "<table border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n"
        + row({"metric", "pairs compared", "significant differences (Welch, Holm-corrected, 5 %)"}, "th");
    for (const Metric metric : metricsShownIn(kDifferences)) {
        const auto pairs = compareArms(results, condition, load, metric);
        if (pairs.empty())
            continue;
        std::string list;
        std::size_t unknown = 0;
        for (const ArmComparison &pair : pairs) {
            if (pair.comparison.significant())
                list += (list.empty() ? "" : "; ") + pairText(results.plan, pair);
            unknown += !pair.comparison.known();
        }
        if (unknown > 0)
            list += (list.empty() ? "" : "; ") + ("of " + std::to_string(unknown))
                + " it cannot be said, as neither of the two varies";
        out += "<tr><td>" + escaped(info(metric).title) + "</td><td>" + std::to_string(pairs.size())
            + "</td><td class=\"text\">" + (list.empty() ? "none" : list) + "</td></tr>\n";
    }
    out += "</table>\n";
    const auto &arms = results.plan.arms;
    if (std::any_of(arms.begin(), arms.end(), [](const SweepArm &arm) { return arm.suite == crypto::SuiteId::None; }))
        out +=
            "<p>A comparison with none shows the whole cost of sealing: in plain MAVLink, too, the agent joins the frames of "
            "one wake-up into one datagram. Besides the cipher, sealing adds a header and a tag to each record, look-up, "
            "replay window, counters, and one report per second from each end.</p>\n";
    return out;
}

const char *verdictText(const Comparison &comparison, bool differs)
{
    return !comparison.known() ? "cannot be said" : differs ? "differs" : "no difference";
}

/// "-3.1 to 4.2 %" of the mean.
std::string intervalText(const NoiseCheck &noise)
{
    const WelchTest &test = noise.comparison.test;
    const double low = 100 * (test.difference - test.halfWidth(0.95)) / noise.mean;
    const double high = 100 * (test.difference + test.halfWidth(0.95)) / noise.mean;
    return std::isfinite(low) && std::isfinite(high) ? readable(low) + " to " + readable(high) + " %" : "–";
}

/// How the report tells a difference from noise; `families`: groups of comparisons that were made.
std::string criterion(std::size_t families)
{
    if (families == 0)
        return "No two suites were measured twice each under the same conditions, so no difference can be distinguished "
               "from noise: that takes two runs or more of each.";
    return "Two suites differ significantly by Welch's t test at 5 %, its p values corrected by Holm's method over all pairs "
           "of one metric, link and load: of the "
        + std::to_string(families)
        + " such families of this sweep (sweep.json has them all) about one in twenty shows a difference by chance. Two frames "
          "in a run, and a step of the histogram in a percentile, are no difference. Where neither of two suites varies in "
          "fewer than five runs, it cannot be said.";
}

std::string noiseTable(const Results &results)
{
    std::string rows;
    std::size_t tests = 0;
    for (const NoiseCheck &noise : noiseOf(results)) {
        const Comparison &pair = noise.comparison;
        tests += !std::isnan(pair.test.p);
        if (!info(noise.metric).isShownIn(kDifferences))
            continue;
        const double percent = 100 * (noise.meanAgain / noise.mean - 1);
        rows += row({placeText(results.plan, noise.condition, noise.load) + ": " + escaped(info(noise.metric).title),
                     readable(noise.mean), readable(noise.meanAgain), readable(percent) + (std::isfinite(percent) ? " %" : ""),
                     intervalText(noise), readable(pair.test.p), verdictText(pair, pair.significantAlone()),
                     readable(pair.adjusted), verdictText(pair, noise.differs())});
    }
    if (rows.empty())
        return "<p>No suite was measured under two names, which takes two runs or more of each.</p>\n";
    return "<p>One suite was measured under two names, so that what differs between the two is noise. The 95 % confidence "
           "interval of the difference, in per cent of the mean, says how large a difference these runs could have missed: a "
           "smaller one between two suites means nothing. \"As two suites\" is the criterion by which two suites differ above: "
           "this pair is the only one of its metric, link and load, so its p stays as it is, and about one line in twenty "
           "differs by chance. The last two columns are corrected by Holm's method over all "
        + std::to_string(tests)
        + " A/A tests of the sweep (sweep.json has them all): together they say \"differs\" by chance in one sweep of twenty."
          "</p>\n<table border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n"
        + row({"metric", "mean", "mean again", "difference", "95 % interval", "p", "as two suites", "p corrected", "A/A"}, "th")
        + rows + "</table>\n";
}

/// For the first page; empty if no trend remains.
std::string trendWarning(const Results &results)
{
    std::string list;
    for (const OrderTrend &trend : orderTrends(results)) {
        if (trend.remains())
            list += (list.empty() ? "" : "; ") + std::string(info(trend.metric).title) + ", "
                + std::string(name(results.plan.loads[trend.load])) + " load, " + readable(100 * trend.perRun)
                + " % for each run";
    }
    return list.empty()
        ? list
        : "values change with the order of the runs, so that the warm-up was too short or the machine drifts: " + list;
}

std::string trendTable(const Results &results)
{
    std::string rows;
    for (const OrderTrend &trend : orderTrends(results))
        rows += row({placeText(results.plan, trend.condition, trend.load) + ": " + escaped(info(trend.metric).title),
                     readable(100 * trend.perRun) + " %", readable(trend.p), trend.remains() ? "remains" : "none found"});
    if (rows.empty())
        return "<p>No suite was measured twice, so that no trend can be tested.</p>\n";
    return "<p>Test whether values rise or fall with the order of the runs: a line through the logarithms of all runs, each "
           "less the mean of its suite, and Student's t test of its slope, corrected by Holm's method over these "
           "lines.</p>\n<table border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n"
        + row({"metric", "change for each run", "p corrected", "trend"}, "th") + rows + "</table>\n";
}

/// How much of the thread that is measured is the measurement.
std::string meterText(const Results &results)
{
    std::string out;
    for (std::size_t load = 0; load < results.plan.loads.size(); ++load) {
        double highest = 0;
        for (const Sample &sample : results.samples) {
            const double share = sample.values[Metric::MeterCpu];
            highest = sample.run.load == load && share > highest ? share : highest;
        }
        if (highest > 0)
            out += (out.empty() ? "" : ", ") + ("up to " + readable(highest)) + " % under the "
                + std::string(name(results.plan.loads[load])) + " load";
    }
    return out.empty()
        ? out
        : "<p>A run is the difference of two readings, taken by the thread that is measured. Of its CPU time, taking and "
          "publishing readings was "
            + out + " (meter_cpu).</p>\n";
}

/// Number of combinations of metric, condition and load in which at least one pair of suites was tested.
std::size_t familiesOf(const Results &results)
{
    std::size_t out = 0;
    forEachPlace(results.plan, [&](std::size_t condition, std::size_t load) {
        for (const MetricInfo &metric : metrics()) {
            const auto pairs = compareArms(results, condition, load, metric.metric);
            out += std::any_of(pairs.begin(), pairs.end(),
                               [](const ArmComparison &pair) { return !std::isnan(pair.comparison.test.p); });
        }
    });
    return out;
}

std::string claimsTable(const std::vector<Claim> &claims)
{
    std::string out =
        "<p>A. Allouch et al., <i>MAVSec: Securing the MAVLink Protocol for Ardupilot/PX4 Unmanned Aerial Systems</i>, "
        "2019, arXiv:1905.00265.</p>\n<table border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n"
        + row({"claim", "finding", "because"}, "th");
    for (const Claim &claim : claims)
        out += "<tr><td class=\"text\">" + escaped(claim.text) + "</td><td class=\"text\"><b>"
            + std::string(findingText(claim.finding)) + "</b></td><td class=\"text\">" + escaped(claim.reason) + "</td></tr>\n";
    return out + "</table>\n";
}

std::string expectationList(const Results &results, const std::vector<Verdict> &verdicts)
{
    if (verdicts.empty())
        return {};
    std::string out = "<h2>Assertions</h2>\n<ul>\n";
    for (const Verdict &verdict : verdicts)
        out += std::string("<li") + (verdict.outcome.holds ? ">" : " class=\"bad\">") + escaped(sentence(verdict, results.plan))
            + "</li>\n";
    return out + "</ul>\n";
}

std::string framingText(const Plan &plan)
{
    std::string out;
    for (const channel::Framing framing : framingsOf(plan))
        out += std::string(out.empty() ? "" : "; ")
            + (framing == channel::Framing::Inline
                   ? "inline: payloads sealed in place, headers clear and authenticated, tags of 8 bytes (only suites "
                     "that are a cipher and an HMAC; a frame that cannot be sealed in place travels in a record)"
                   : "sealed: whole frames in records, tags of 16 bytes");
    return out.empty() ? "none, plain MAVLink only" : out;
}

std::string settingTable(const Results &results)
{
    const Plan &plan = results.plan;
    std::string out = "<table border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n";
    const auto line = [&out](const std::string &key, const std::string &value) {
        out += "<tr><td>" + escaped(key) + "</td><td class=\"text\">" + escaped(value) + "</td></tr>\n";
    };
    line("seed", std::to_string(plan.seed));
    line("runs",
         std::to_string(results.samples.size()) + " of " + readable(seconds(plan.measure)) + " s, after "
             + readable(seconds(plan.warmUp)) + " s of warm-up each; the sweep took " + readable(results.seconds) + " s");
    if (!results.placement.empty())
        line("placement", results.placement);
    line("framing", framingText(plan));
    for (const Condition &condition : plan.conditions)
        line("link",
             condition.clean()
                 ? "clean, without impairment"
                 : conditionText(condition) + ", in both directions, by a relay: skyseal-cli impair (" + condition.name + ")");
    for (const auto &[key, value] : results.setting)
        line(key, value);
    return out + "</table>\n";
}

std::string rawTable(const Results &results)
{
    const std::vector<Metric> shown = metricsShownIn(kEveryRun);
    std::vector<std::string> head{"run", "place", "suite", "framing", "repeat"};
    for (const Metric metric : shown)
        head.emplace_back(info(metric).key);
    std::string out = "<table border=\"1\" cellspacing=\"0\" cellpadding=\"2\">\n" + row(head, "th");
    for (const Sample &sample : results.samples) {
        std::vector<std::string> cells{
            std::to_string(sample.order + 1), placeText(results.plan, sample.run.condition, sample.run.load),
            armText(results.plan.arms[sample.run.arm]), std::string(framingName(results.plan.arms[sample.run.arm])),
            std::to_string(sample.run.repeat + 1)};
        for (const Metric metric : shown)
            cells.push_back(readable(sample.values[metric]));
        out += row(cells);
        const auto note = [&](const std::string &text) {
            if (!text.empty())
                out += "<tr><td colspan=\"" + std::to_string(head.size()) + "\" class=\"bad\">" + escaped(text)
                    + "</td></tr>\n";
        };
        note(sample.problem);
        for (const std::string &text : disturbances(sample))
            note("disturbed: " + text);
        if (!sample.invalid.empty())
            note("left out of every comparison, " + sample.invalid
                 + (sample.attempts > 1 ? ", the last of " + std::to_string(sample.attempts) + " attempts" : ""));
    }
    return out + "</table>\n";
}

std::string metricList()
{
    std::string out = "<ul>\n";
    for (const MetricInfo &metric : metrics())
        out += "<li><b>" + escaped(metric.title) + "</b> (" + escaped(metric.key) + "): " + escaped(metric.description)
            + "</li>\n";
    return out + "</ul>\n";
}

std::string inlined(const std::vector<ReportFigure> &figures)
{
    std::string out;
    for (const ReportFigure &figure : figures)
        out += "<figure>" + figure.svg + "</figure>\n";
    return out;
}

/// Two figures side by side, for the PDF.
std::string inPairs(const std::vector<ReportFigure> &figures)
{
    std::string out;
    for (std::size_t i = 0; i < figures.size(); ++i) {
        out += i % 2 == 0 ? "<table><tr><td>" : "<td>";
        out += "<img src=\"figures/" + figures[i].name + ".svg\"/></td>";
        out += i % 2 == 1 || i + 1 == figures.size() ? "</tr></table>\n" : "";
    }
    return out;
}

std::string body(const ReportParts &parts, bool inlineFigures)
{
    const Results &results = parts.results;
    std::string out = "<h1>What each cipher suite costs on a MAVLink link</h1>\n";
    for (const std::string &warning : warningsOf(results.setting))
        out += "<p class=\"bad\">" + escaped(warning) + ".</p>\n";
    if (const std::string ended = endedEarly(results); !ended.empty())
        out += "<p class=\"bad\">This sweep is incomplete: it " + ended + ".</p>\n";
    if (const std::string failed = failedRuns(results); !failed.empty())
        out += "<p class=\"bad\">" + escaped(failed) + "</p>\n";
    if (const std::string invalid = invalidRuns(results); !invalid.empty())
        out += "<p class=\"bad\">" + escaped(invalid) + ".</p>\n";
    if (const std::string trend = trendWarning(results); !trend.empty())
        out += "<p class=\"bad\">" + escaped(trend) + ".</p>\n";
    if (const std::string disturbed = disturbedRuns(results); !disturbed.empty())
        out += "<p class=\"bad\">" + escaped(disturbed) + ".</p>\n";
    out += "<p>Means of " + runsText(results)
        + " each, in random order, ± half of the 95 % confidence interval (Student's t, from two runs on), or (≤ its end) "
          "where it begins at zero, below which nothing can be; where nothing was lost in any run, that end is the 95 % bound "
          "by all frames of these runs together, about 3 divided by their number; * marks outliers by Tukey's fences, which "
          "stay in. Resident memory is that of one process through all suites: its runs are not independent, so it has no "
          "interval, and suites are not compared by it.</p>\n<p>"
        + criterion(familiesOf(results)) + "</p>\n" + meterText(results) + "<h2>Figures</h2>\n";
    out += inlineFigures ? inlined(parts.figures) : inPairs(parts.figures);
    // In the PDF each section begins a page, so that no table head is left alone at the bottom of one.
    const std::string section = inlineFigures ? "<h2>" : "<h2 style=\"page-break-before:always\">";
    forEachPlace(results.plan, [&](std::size_t condition, std::size_t load) {
        out += section + "Results: " + placeText(results.plan, condition, load) + "</h2>\n<div class=\"wide\">"
            + summaryTable(results, condition, load) + "</div>\n<h3>Which suites differ</h3>\n"
            + differences(results, condition, load);
    });
    out += section + "The machine's noise (A/A)</h2>\n<div class=\"wide\">" + noiseTable(results) + "</div>\n";
    out += "<h2>Trend with the order of the runs</h2>\n<div class=\"wide\">" + trendTable(results) + "</div>\n";
    out += "<h2>The paper's claims</h2>\n" + claimsTable(parts.claims);
    out += expectationList(results, parts.verdicts);
    out += section + "Setting</h2>\n" + settingTable(results);
    out += "<h2>What was measured</h2>\n" + metricList();
    return out + "<h2>Every run</h2>\n<div class=\"wide\">" + rawTable(results) + "</div>\n";
}

} // namespace

std::vector<ReportFigure> figuresOf(const Results &results)
{
    std::vector<Metric> shown = metricsShownIn(kFigure);
    std::stable_partition(shown.begin(), shown.end(), [](Metric metric) { return info(metric).isShownIn(kPaperFigure); });
    std::vector<ReportFigure> out;
    for (const Metric metric : shown) {
        if (!wasMeasured(results, metric))
            continue;
        forEachPlace(results.plan, [&](std::size_t condition, std::size_t load) {
            std::string file = std::string(info(metric).key) + "-" + std::string(name(results.plan.loads[load]));
            if (results.plan.conditions.size() > 1)
                file += "-" + std::to_string(condition + 1);
            out.push_back({file, svg(chartOf(results, condition, load, metric))});
        });
    }
    return out;
}

std::string htmlReport(const ReportParts &parts)
{
    return std::string("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
                       "<meta name=\"color-scheme\" content=\"light\"/>\n<title>Skyseal sweep</title>\n<style>")
        + kStyle + "</style>\n</head>\n<body>\n" + body(parts, true) + "</body>\n</html>\n";
}

std::string printReport(const ReportParts &parts)
{
    return "<html><body>" + body(parts, false) + "</body></html>";
}

} // namespace skyseal::experiment
