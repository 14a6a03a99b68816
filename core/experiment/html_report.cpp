#include "core/experiment/html_report.h"

#include "core/experiment/analysis.h"
#include "core/experiment/bar_chart.h"
#include "core/experiment/contrast.h"
#include "core/experiment/cost_model.h"
#include "core/experiment/disturbances.h"
#include "core/experiment/html_parts.h"
#include "core/experiment/memory_table.h"
#include "core/experiment/message_mix.h"
#include "core/experiment/relay_comparison.h"
#include "core/experiment/report_warnings.h"
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
    "thead{display:table-header-group}tr,figure{break-inside:avoid}.bad{color:#c00000;font-weight:bold}"
    ".wide{overflow-x:auto}figure{margin:1em 0}svg{max-width:100%;height:auto}";

std::string placeText(const Plan &plan, std::size_t condition, std::size_t load)
{
    return "link " + escaped(conditionText(plan.conditions[condition])) + "; " + std::string(name(plan.loads[load])) + " load";
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
    std::string out = "<table border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n" + headOfTable({head, framings});
    for (const MetricInfo &metric : metrics()) {
        std::vector<std::string> cells{
            escaped(std::string(metric.title.english()) + (metric.unit.empty() ? "" : ", " + std::string(metric.unit)))};
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

/// "1.08 (1.05 to 1.11)", bold where it is significant; of others than ratios the difference, of shares in per cent.
std::string contrastCell(const Contrast &contrast)
{
    const double scale = info(contrast.metric).isShare() ? 100 : 1;
    std::string out = readable(scale * contrast.value());
    if (std::isfinite(contrast.low()) && std::isfinite(contrast.high()))
        out += " (" + readable(scale * contrast.low()) + " to " + readable(scale * contrast.high()) + ")";
    return contrast.significant() ? "<b>" + out + "</b>" : out;
}

std::string contrastTitle(Metric metric)
{
    const MetricInfo &described = info(metric);
    const std::string unit = described.isShare() ? "%" : described.canBeNegative ? std::string(described.unit) : "";
    return escaped(std::string(described.title.english()) + (unit.empty() ? "" : ", difference in " + unit));
}

/// The main result: each arm against the reference by each metric.
std::string ratioTable(const Results &results, std::size_t condition, std::size_t load)
{
    const Plan &plan = results.plan;
    const auto reference = referenceArm(plan);
    std::vector<std::size_t> arms;
    for (std::size_t arm = 0; arm < plan.arms.size(); ++arm) {
        if (arm != reference && !plan.arms[arm].again && exists(plan.arms[arm]))
            arms.push_back(arm);
    }
    std::vector<std::string> head{"metric"}, framings{"framing"};
    for (const std::size_t arm : arms) {
        head.push_back(armText(plan.arms[arm]));
        framings.emplace_back(framingName(plan.arms[arm]));
    }
    std::string rows;
    for (const Metric metric : metricsShownIn(kDifferences)) {
        const std::vector<Contrast> contrasts = plannedContrasts(results, condition, load, metric);
        std::vector<std::string> cells{contrastTitle(metric)};
        bool any = false;
        for (const std::size_t arm : arms) {
            const auto found = std::ranges::find_if(
                contrasts, [&](const Contrast &one) { return one.first == reference && one.second == arm; });
            cells.push_back(found == contrasts.end() ? "–" : contrastCell(*found));
            any = any || found != contrasts.end();
        }
        if (any)
            rows += row(cells);
    }
    if (rows.empty())
        return "<p>No two suites were measured twice each under this load.</p>\n";
    return "<table border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n" + headOfTable({head, framings}) + rows + "</table>\n";
}

/// The pairs of the paper's claims, and what authentication adds to a bare cipher.
std::string pairTable(const Results &results, std::size_t condition, std::size_t load)
{
    const Plan &plan = results.plan;
    std::string rows;
    for (const Metric metric : metricsShownIn(kRatio)) {
        for (const Contrast &one : plannedContrasts(results, condition, load, metric)) {
            if (one.first != referenceArm(plan))
                rows += row({contrastTitle(metric), escaped(fullName(plan.arms[one.second])),
                             escaped(fullName(plan.arms[one.first])), contrastCell(one), readable(one.adjusted)});
        }
    }
    return rows.empty() ? rows
                        : std::string("<h3>Pairs that a claim of the paper names")
            + (std::ranges::count(framingsOf(plan), ArmFraming::Bare) > 0 ? ", and bare ciphers with and without their HMAC"
                                                                          : "")
            + "</h3>\n<table border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n"
            + headOfTable({{"metric", "suite", "to", "ratio", "p corrected"}}) + rows + "</table>\n";
}

std::string plainText(const Plan &plan)
{
    if (std::ranges::none_of(plan.arms, [](const SweepArm &arm) { return arm.suite == crypto::SuiteId::None; }))
        return {};
    return "<p>A comparison with none shows the whole cost of sealing: in plain MAVLink, too, the agent joins the frames of "
           "one wake-up into one datagram. Besides the cipher, sealing adds a header and a tag to each record, look-up, "
           "replay window, counters, and one report per second from each end.</p>\n";
}

const char *verdictText(const Contrast &contrast, bool differs)
{
    return !contrast.known() ? "cannot be said" : differs ? "differs" : "no difference";
}

/// How the ratios came about, and what their intervals hold for.
std::string methodText(const Results &results)
{
    const unsigned launches = results.plan.launches;
    std::string out = "Ratios to " + escaped(referenceText(results.plan))
        + " with their 95 % confidence intervals are the result; bold ones differ significantly at 5 % by "
          "Holm's method over the "
          "comparisons of one metric, link and load that were planned: each suite against the reference, and the pairs that "
          "the paper's claims name. They rest on log(value) = arm + block with the launch as a random effect, "
          "so that what a block "
          "shares cancels; for shares, on differences. Two frames in a run, and a step of the histogram in a percentile, are "
          "no difference. Under the natural load the vehicle decides how many packets there are; they are not compared.";
    if (launches == 1)
        out += " <b>All programs were started once only: the intervals hold for this one start, and another may differ by more "
               "(--launches).</b>";
    else
        out += " All programs started anew " + std::to_string(launches)
            + " times, and the intervals say what other starts would show.";
    return out;
}

std::string noiseTable(const Results &results)
{
    std::string rows;
    std::size_t tests = 0;
    for (const Contrast &noise : noiseContrasts(results)) {
        tests += !std::isnan(noise.p);
        if (!info(noise.metric).isShownIn(kDifferences))
            continue;
        rows += row({placeText(results.plan, noise.condition, noise.load) + ": " + contrastTitle(noise.metric),
                     readable(noise.firstMean), readable(noise.secondMean), contrastCell(noise), readable(noise.p),
                     verdictText(noise, noise.significantAlone()), readable(noise.adjusted),
                     verdictText(noise, noise.significant())});
    }
    if (rows.empty())
        return "<p>No suite was measured under two names, which takes two runs or more of each.</p>\n";
    return "<p>One suite was measured under two names, so that what differs between the two is noise. The 95 % confidence "
           "interval of the ratio says how large a difference these runs could have missed: a smaller one "
           "between two suites means "
           "nothing. \"Alone\" is the verdict by p as it is: about one line in twenty differs by chance. The "
           "last two columns are "
           "corrected by Holm's method over all "
        + std::to_string(tests)
        + " A/A tests of the sweep (sweep.json has them all): together they say \"differs\" by chance in one sweep of twenty."
          "</p>\n<table border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n"
        + headOfTable({{"metric", "mean", "mean again", "ratio", "p", "alone", "p corrected", "A/A"}}) + rows + "</table>\n";
}

std::string trendTable(const Results &results)
{
    std::string rows;
    for (const OrderTrend &trend : orderTrends(results))
        rows += row({placeText(results.plan, trend.condition, trend.load) + ": " + escaped(info(trend.metric).title.english()),
                     readable(100 * trend.perRun) + " %", readable(trend.p), trend.remains() ? "remains" : "none found"});
    if (rows.empty())
        return "<p>No suite was measured twice, so that no trend can be tested.</p>\n";
    return "<p>Test whether values rise or fall with the order of the runs, since programs had not warmed up: log(value) = "
           "suite + launch + slope × order by least squares, and Student's t test of the slope, corrected by Holm's method "
           "over these lines. A difference between launches is no trend, but part of the intervals.</p>\n"
           "<table border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n"
        + headOfTable({{"metric", "change for each run", "p corrected", "trend"}}) + rows + "</table>\n";
}

std::string meterHtml(const Results &results)
{
    const std::string text = meterText(results).text();
    return text.empty() ? text : "<p>" + escaped(text) + ".</p>\n";
}

/// "12 %; below 2 %", or a dash where no other margin would decide.
std::string marginText(const Claim &claim)
{
    std::string out;
    if (std::isfinite(claim.decidable))
        out = readable(100 * claim.decidable) + " %";
    if (std::isfinite(claim.decidableBelow))
        out += (out.empty() ? "below " : "; below ") + readable(100 * claim.decidableBelow) + " %";
    return out.empty() ? "–" : out;
}

std::string claimsTable(const Results &results, const std::vector<Claim> &claims)
{
    std::string out =
        "<p>A. Allouch et al., <i>MAVSec: Securing the MAVLink Protocol for Ardupilot/PX4 Unmanned Aerial Systems</i>, "
        "2019, arXiv:1905.00265. Each claim is judged by equivalence within a margin of "
        + readable(100 * results.plan.margin)
        + " %: an interval that lies wholly on one side of the margin decides, one that reaches over it does not.</p>\n<table "
          "border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n"
        + headOfTable({{"claim", "finding", "would be decided by", "because"}});
    for (const Claim &claim : claims)
        out += "<tr><td class=\"text\">" + escaped(claim.text) + "</td><td class=\"text\"><b>"
            + std::string(findingText(claim.finding)) + "</b></td><td>" + marginText(claim) + "</td><td class=\"text\">"
            + escaped(claim.reason) + "</td></tr>\n";
    return out + "</table>\n";
}

std::string orderingTable(const Results &results)
{
    std::string rows;
    for (const Ordering &ordering : orderings(results))
        rows += "<tr><td>" + escaped(ordering.quantity) + "</td><td class=\"text\">" + escaped(ordering.paper)
            + "</td><td class=\"text\">" + escaped(ordering.here) + "</td></tr>\n";
    return rows.empty() ? rows
                        : "<h3>The paper's orderings beside these</h3>\n<p>Ratios to plain MAVLink with their 95 % intervals; "
                          "two neighbours whose intervals overlap widely are in no order.</p>\n<table border=\"1\" "
                          "cellspacing=\"0\" cellpadding=\"3\">\n"
            + headOfTable({{"quantity", "the paper", "here"}}) + rows + "</table>\n";
}

std::string expectationList(const Results &results, const std::vector<Verdict> &verdicts)
{
    if (verdicts.empty())
        return {};
    std::string out = "<h2>Assertions</h2>\n<ul>\n";
    for (const Verdict &verdict : verdicts)
        out += std::string("<li") + (verdict.outcome.holds ? ">" : " class=\"bad\">")
            + escaped(verdictText(verdict, results.plan)) + "</li>\n";
    return out + "</ul>\n";
}

std::string framingText(ArmFraming framing)
{
    switch (framing) {
    case ArmFraming::Inline:
        return "inline: payloads sealed in place, headers clear and authenticated, tags of 8 bytes (only suites that are a "
               "cipher and an HMAC; a frame that cannot be sealed in place travels in a record)";
    case ArmFraming::Bare:
        return "bare: INSECURE, as in the paper: the simulator encrypts the payloads that it sends by the cipher alone, under "
               "a fixed key and nonce, without authentication, and the way back is clear. The agent passes the frames on as "
               "plain MAVLink, so that its figures contain no cipher: compare those of the station, which decrypts each frame";
    case ArmFraming::Sealed: break;
    }
    return "sealed: whole frames in records, tags of 16 bytes";
}

std::string framingText(const Plan &plan)
{
    std::string out;
    for (const ArmFraming framing : framingsOf(plan))
        out += (out.empty() ? "" : "; ") + framingText(framing);
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
    if (!results.source.empty())
        line("vehicle", results.source);
    if (!plan.flight.empty())
        line("flight", plan.flight + ", repeated; each of its phases (" + std::to_string(plan.phases) + ") is a block of runs");
    line("framing", framingText(plan));
    for (const Condition &condition : plan.conditions)
        line("link",
             condition.clean()
                 ? "clean, without impairment"
                 : conditionText(condition) + ", in both directions, by a relay: skyseal-cli impair (" + condition.name + ")");
    for (std::size_t load = 0; load < plan.loads.size(); ++load) {
        if (const std::string mix = messageMixText(messageMixOf(results, load)); !mix.empty())
            line("messages received, " + std::string(name(plan.loads[load])) + " load", mix);
    }
    for (const auto &[key, value] : results.setting)
        line(key, value);
    return out + "</table>\n";
}

/// "2"; "2 (flight 1, phase 2)".
std::string repeatText(const Plan &plan, const Run &run)
{
    std::string out = std::to_string(run.repeat + 1);
    if (!plan.flight.empty())
        out += " (flight " + std::to_string(run.repeat / plan.phases + 1) + ", phase " + std::to_string(phaseOf(plan, run) + 1)
            + ")";
    return out;
}

std::string rawTable(const Results &results)
{
    const std::vector<Metric> shown = metricsShownIn(kEveryRun);
    std::vector<std::string> head{"run", "place", "suite", "framing", "launch", "repeat"};
    for (const Metric metric : shown)
        head.emplace_back(info(metric).key);
    std::string out = "<table border=\"1\" cellspacing=\"0\" cellpadding=\"2\">\n" + headOfTable({head});
    for (const Sample &sample : results.samples) {
        std::vector<std::string> cells{
            std::to_string(sample.order + 1),           placeText(results.plan, sample.run.condition, sample.run.load),
            armText(results.plan.arms[sample.run.arm]), std::string(framingName(results.plan.arms[sample.run.arm])),
            std::to_string(sample.run.launch + 1),      repeatText(results.plan, sample.run)};
        for (const Metric metric : shown)
            cells.push_back(readable(sample.values[metric]));
        out += row(cells);
        const auto note = [&](const std::string &text) {
            if (!text.empty())
                out += "<tr><td colspan=\"" + std::to_string(head.size()) + "\" class=\"bad\">" + escaped(text)
                    + "</td></tr>\n";
        };
        note(sample.problem.text());
        for (const std::string &text : disturbances(sample))
            note("disturbed: " + text);
        if (!sample.invalid.empty())
            note("left out of every comparison, " + sample.invalid.text()
                 + (sample.attempts > 1 ? ", the last of " + std::to_string(sample.attempts) + " attempts" : ""));
    }
    return out + "</table>\n";
}

std::string metricList()
{
    std::string out = "<ul>\n";
    for (const MetricInfo &metric : metrics())
        out += "<li><b>" + escaped(metric.title.english()) + "</b> (" + escaped(metric.key)
            + "): " + escaped(metric.description.english()) + "</li>\n";
    return out + "</ul>\n";
}

std::string inlined(const std::vector<ReportFigure> &figures)
{
    std::string out;
    for (const ReportFigure &figure : figures)
        out += "<figure>" + figure.svg + "</figure>\n";
    return out;
}

std::string body(const ReportParts &parts, bool inlineFigures)
{
    const Results &results = parts.results;
    std::string out = "<h1>What each cipher suite costs on a MAVLink link</h1>\n";
    for (const Reason &warning : reportWarnings(results))
        out += "<p class=\"bad\">" + escaped(warning.text()) + ".</p>\n";
    out += "<p>Means of " + runsText(results)
        + " each, in random order, ± half of the 95 % confidence interval (Student's t, from two runs on), or (≤ its end) "
          "where it begins at zero, below which nothing can be; where nothing was lost in any run, that end is the 95 % bound "
          "by all frames of these runs together, about 3 divided by their number; * marks outliers by Tukey's fences, which "
          "stay in.</p>\n<p>"
        + methodText(results) + "</p>\n" + meterHtml(results) + "<h2>Figures</h2>\n";
    out += inlineFigures ? inlined(parts.figures) : figuresInPairs(parts.figures);
    // In the PDF each section begins a page, so that no table head is left alone at the bottom of one.
    const std::string section = inlineFigures ? "<h2>" : "<h2 style=\"page-break-before:always\">";
    forEachPlace(results.plan, [&](std::size_t condition, std::size_t load) {
        out += section + "Results: " + placeText(results.plan, condition, load) + "</h2>\n<h3>Ratios to "
            + escaped(referenceText(results.plan)) + "</h3>\n<div class=\"wide\">" + ratioTable(results, condition, load)
            + "</div>\n" + plainText(results.plan) + pairTable(results, condition, load)
            + "<h3>Means</h3>\n<div class=\"wide\">" + summaryTable(results, condition, load) + "</div>\n";
    });
    if (const std::string memory = memoryTable(results); !memory.empty())
        out += "<h2>Memory</h2>\n" + memory;
    out += costModelHtml(results);
    if (const std::string relay = relayTable(results); !relay.empty())
        out += section + "Loss against the relay's log</h2>\n<div class=\"wide\">" + relay + "</div>\n";
    out += section + "The machine's noise (A/A)</h2>\n<div class=\"wide\">" + noiseTable(results) + "</div>\n";
    out += "<h2>Trend with the order of the runs</h2>\n<div class=\"wide\">" + trendTable(results) + "</div>\n";
    out += "<h2>The paper's claims</h2>\n" + claimsTable(results, parts.claims) + orderingTable(results);
    out += expectationList(results, parts.verdicts);
    out += section + "Setting</h2>\n" + settingTable(results);
    out += "<h2>What was measured</h2>\n" + metricList();
    return out + "<h2>Every run</h2>\n<div class=\"wide\">" + rawTable(results) + "</div>\n";
}

} // namespace

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
