#include "core/experiment/sweep_text.h"

#include "core/experiment/analysis.h"
#include "core/experiment/contrast.h"
#include "core/experiment/disturbances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace skyseal::experiment {

namespace {

constexpr std::size_t kNameWidth = 32, kColumnWidth = 22;

/// Width on a terminal: characters, not bytes of UTF-8.
std::string padded(const std::string &text, std::size_t width, bool right)
{
    std::size_t characters = 0;
    for (const char c : text)
        characters += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    const std::string space(characters < width ? width - characters : 0, ' ');
    return right ? space + text : text + space;
}

/// The ratios of one condition and load: a line of metrics, then one for each arm. Empty without any.
std::vector<std::string> ratioLines(const Results &results, std::size_t condition, std::size_t load)
{
    const auto reference = referenceArm(results.plan);
    std::string head = padded("ratio to " + referenceText(results.plan), kNameWidth, false);
    std::vector<std::string> lines(results.plan.arms.size());
    for (const Metric metric : metricsShownIn(kRatio)) {
        const std::vector<Contrast> contrasts = plannedContrasts(results, condition, load, metric);
        if (contrasts.empty())
            continue;
        head += padded(std::string(info(metric).key), kColumnWidth, true);
        for (const Contrast &one : contrasts) {
            if (one.first != reference)
                continue;
            const std::string text = std::isfinite(one.low()) ? intervalText(one.value(), one.low(), one.high())
                                                              : readable(one.value());
            lines[one.second] += padded(text, kColumnWidth, true);
        }
    }
    std::vector<std::string> out;
    for (std::size_t arm = 0; arm < lines.size(); ++arm) {
        if (lines[arm].empty())
            continue;
        if (out.empty())
            out.push_back(head);
        out.push_back(padded(fullName(results.plan.arms[arm]) + (isInsecure(results.plan.arms[arm]) ? " (insecure)" : ""),
                             kNameWidth, false)
                      + lines[arm]);
    }
    return out;
}

/// Two lines: the metrics and their units.
std::array<std::string, 2> header()
{
    std::string keys = padded("", kNameWidth, false), units = keys;
    for (const Metric metric : metricsShownIn(kTerminal)) {
        keys += padded(std::string(info(metric).key), kColumnWidth, true);
        units += padded(std::string(info(metric).unit), kColumnWidth, true);
    }
    return {keys, units};
}

std::string leftText(double time)
{
    const long whole = std::lround(time);
    char out[48];
    if (whole >= 60)
        std::snprintf(out, sizeof out, "%ld min %ld s left", whole / 60, whole % 60);
    else
        std::snprintf(out, sizeof out, "%ld s left", whole);
    return out;
}

} // namespace

std::string referenceText(const Plan &plan)
{
    const auto reference = referenceArm(plan);
    if (!reference)
        return "nothing";
    return plan.arms[*reference].suite == crypto::SuiteId::None ? "plain MAVLink" : fullName(plan.arms[*reference]);
}

const char *missingText(const SweepArm &arm)
{
    return exists(arm) ? "not measured" : "not in this framing";
}

std::string meanText(const Results &results, const Cell &cell, Metric metric)
{
    const Summary summary = summaryOf(results, cell, metric);
    if (summary.count == 0)
        return exists(results.plan.arms[cell.arm]) ? "–" : missingText(results.plan.arms[cell.arm]);
    return readable(summary.mean, summary.low(), summary.high()) + (summary.outliers.empty() ? "" : " *");
}

std::string runsText(const std::vector<std::size_t> &counts)
{
    std::size_t least = 0, most = 0;
    for (const std::size_t count : counts) {
        least = count > 0 && (least == 0 || count < least) ? count : least;
        most = std::max(most, count);
    }
    return (least == most ? "" : std::to_string(least) + " to ") + std::to_string(most) + (most == 1 ? " run" : " runs");
}

std::string runsText(const Results &results)
{
    std::vector<std::size_t> counts;
    for (const Cell &cell : cells(results.plan)) {
        counts.push_back(static_cast<std::size_t>(
            std::count_if(results.samples.begin(), results.samples.end(), [&cell](const Sample &sample) {
                return Cell{sample.run.condition, sample.run.load, sample.run.arm} == cell && sample.isValid();
            })));
    }
    return runsText(counts);
}

Reason endedEarly(const Results &results)
{
    const std::size_t planned = schedule(results.plan).size();
    if (results.complete && results.samples.size() >= planned)
        return {};
    if (results.samples.size() >= planned)
        return sentence("Reason", "was given up or cancelled after its last run");
    return sentence("Reason", "ended after %1 of %2 runs")(results.samples.size(), planned);
}

/// Arm, load, and link if there are several: "none (natural load): " and what happened.
static Reason ofRun(const Plan &plan, const Run &run, const Reason &arm, const Reason &what)
{
    const Reason load = nameReason(plan.loads[run.load]);
    if (plan.conditions.size() > 1)
        return sentence("Reason", "%1 (%2 load, link %3): %4")(arm, load, plan.conditions[run.condition].name, what);
    return sentence("Reason", "%1 (%2 load): %3")(arm, load, what);
}

Reason failedRuns(const Results &results)
{
    std::vector<Reason> reasons;
    std::size_t failed = 0;
    for (const Sample &sample : results.samples) {
        if (sample.problem.empty())
            continue;
        ++failed;
        Reason reason = ofRun(results.plan, sample.run, nameReason(results.plan.arms[sample.run.arm]), sample.problem);
        if (std::find(reasons.begin(), reasons.end(), reason) == reasons.end())
            reasons.push_back(std::move(reason));
    }
    if (failed == 0)
        return {};
    Reason list;
    for (const Reason &reason : reasons)
        list = list.empty() ? reason : sentence("Reason", "%1; %2")(list, reason);
    const std::size_t all = results.samples.size();
    return all == 1 ? sentence("Reason", "1 of 1 run failed: %1")(list)
                    : sentence("Reason", "%1 of %2 runs failed: %3")(failed, all, list);
}

Reason invalidRuns(const Results &results)
{
    std::size_t invalid = 0;
    const Sample *first = nullptr;
    for (const Sample &sample : results.samples) {
        if (sample.invalid.empty())
            continue;
        first = first ? first : &sample;
        ++invalid;
    }
    if (!first)
        return {};
    const Plan &plan = results.plan;
    return sentence("Reason",
                    "%1 of %2 runs are not valid and left out of every comparison; the first of them, %3 (%4 load): %5")(
        invalid, results.samples.size(), fullNameReason(plan.arms[first->run.arm]), nameReason(plan.loads[first->run.load]),
        first->invalid);
}

std::vector<std::string> sweepText(const Results &results)
{
    const Plan &plan = results.plan;
    std::vector<std::string> out;
    bool anyOutlier = false, anyCut = false;
    for (std::size_t condition = 0; condition < plan.conditions.size(); ++condition) {
        for (std::size_t load = 0; load < plan.loads.size(); ++load) {
            if (!out.empty())
                out.emplace_back();
            out.push_back("Link: " + plan.conditions[condition].name + ", load: " + std::string(name(plan.loads[load])));
            for (std::string &line : header())
                out.push_back(std::move(line));
            for (std::size_t arm = 0; arm < plan.arms.size(); ++arm) {
                const bool insecure = isInsecure(plan.arms[arm]);
                std::string line = padded(fullName(plan.arms[arm]) + (insecure ? " (insecure)" : ""), kNameWidth, false);
                if (!exists(plan.arms[arm])) {
                    out.push_back(line + "   " + missingText(plan.arms[arm]));
                    continue;
                }
                for (const Metric metric : metricsShownIn(kTerminal)) {
                    const std::string text = meanText(results, {condition, load, arm}, metric);
                    anyOutlier = anyOutlier || text.ends_with('*');
                    anyCut = anyCut || text.find("≤") != std::string::npos;
                    line += padded(text, kColumnWidth, true);
                }
                out.push_back(line);
            }
            for (std::string &line : ratioLines(results, condition, load))
                out.push_back(std::move(line));
        }
    }
    out.push_back("mean ± half of the 95 % confidence interval (from two runs on) over " + runsText(results) + " of "
                  + readable(seconds(plan.measure)) + " s each" + (anyCut ? "; ≤ its end, where it begins at zero" : "")
                  + (anyOutlier ? "; * with outliers" : ""));
    if (const Reason ended = endedEarly(results); !ended.empty())
        out.push_back("This sweep " + ended.text() + ".");
    return out;
}

/// Loss of frames; of records where sequence numbers cannot count frames.
static std::string lossText(const Values &values)
{
    const double frames = values[Metric::Loss], records = values[Metric::RecordLoss];
    if (!std::isnan(frames))
        return readable(100 * frames) + " % lost";
    return std::isnan(records) ? "loss unknown" : readable(100 * records) + " % of the records lost";
}

std::string runText(const Plan &plan, const Sample &sample, std::size_t runs, double remaining)
{
    std::string out = "[" + std::to_string(sample.order + 1) + "/" + std::to_string(runs) + "] ";
    if (plan.conditions.size() > 1)
        out += plan.conditions[sample.run.condition].name + ", ";
    if (plan.launches > 1)
        out += "launch " + std::to_string(sample.run.launch + 1) + ", ";
    if (!plan.flight.empty())
        out += "flight " + std::to_string(sample.run.repeat / plan.phases + 1) + ", phase "
            + std::to_string(phaseOf(plan, sample.run) + 1) + ", ";
    out += std::string(name(plan.loads[sample.run.load])) + ", " + fullName(plan.arms[sample.run.arm]) + ": ";
    if (sample.problem.empty())
        out += readable(sample.values[Metric::Packets]) + " packets, " + lossText(sample.values) + ", CPU "
            + readable(sample.values[Metric::Cpu]) + " %";
    else
        out += sample.problem.text();
    if (!sample.invalid.empty())
        out += "; NOT VALID, " + sample.invalid.text()
            + (sample.attempts > 1 ? ", in " + std::to_string(sample.attempts) + " attempts" : "");
    for (const std::string &text : disturbances(sample))
        out += "; disturbed: " + text;
    return out + "; " + leftText(remaining);
}

} // namespace skyseal::experiment
