#include "core/experiment/pooled_report.h"

#include "core/experiment/bar_chart.h"
#include "core/experiment/contrast.h"
#include "core/experiment/csv.h"
#include "core/experiment/forest_chart.h"
#include "core/experiment/html_parts.h"
#include "core/experiment/random_effects.h"
#include "core/experiment/report_warnings.h"
#include "core/experiment/statistics.h"
#include "core/experiment/sweep_text.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace skyseal::experiment {

namespace {

/// A ratio as several machines found it.
struct Pooling
{
    Metric metric{};
    std::size_t condition = 0, load = 0;
    std::string arm;
    bool insecure = false;
    std::vector<std::pair<std::string, std::optional<Contrast>>> machines;
    std::optional<RandomEffects> common;
};

std::optional<Contrast> contrastOf(const Results &results, const Pooling &wanted)
{
    const auto reference = referenceArm(results.plan);
    for (const Contrast &one : plannedContrasts(results, wanted.condition, wanted.load, wanted.metric)) {
        if (one.first == reference && fullName(results.plan.arms[one.second]) == wanted.arm && std::isfinite(one.low()))
            return one;
    }
    return std::nullopt;
}

/// The joint result of several days of a machine. Days may differ by more than their own errors say.
MachineEffect joined(const std::vector<MachineEffect> &days)
{
    const auto n = static_cast<double>(days.size());
    double mean = 0, own = 0, between = 0;
    for (const MachineEffect &day : days) {
        mean += day.estimate / n;
        own += day.error * day.error / n;
    }
    for (const MachineEffect &day : days)
        between += (day.estimate - mean) * (day.estimate - mean) / std::max(n - 1, 1.0);
    return {mean, std::sqrt(std::max(own, between) / n)};
}

std::optional<RandomEffects> commonOf(const std::vector<Machine> &machines, const Pooling &pooling)
{
    std::vector<MachineEffect> effects;
    for (const std::vector<std::size_t> &sweeps : daysOfMachines(machines)) {
        std::vector<MachineEffect> days;
        for (const std::size_t sweep : sweeps) {
            const std::optional<Contrast> &one = pooling.machines[sweep].second;
            if (one && one->error > 0)
                days.push_back({one->estimate, one->error});
        }
        if (!days.empty())
            effects.push_back(joined(days));
    }
    return pooled(effects);
}

/// Of all sweeps, each once.
std::vector<SweepArm> armsOf(const std::vector<Machine> &machines)
{
    std::vector<SweepArm> out;
    for (const Machine &machine : machines) {
        for (const SweepArm &arm : machine.results.plan.arms) {
            if (!arm.again && exists(arm) && std::ranges::find(out, arm) == out.end())
                out.push_back(arm);
        }
    }
    return out;
}

std::vector<Pooling> poolingsOf(const std::vector<Machine> &machines)
{
    std::vector<Pooling> out;
    const std::vector<SweepArm> arms = armsOf(machines);
    for (const Metric metric : metricsShownIn(kRatio)) {
        forEachPlace(machines.front().results.plan, [&](std::size_t condition, std::size_t load) {
            for (const SweepArm &arm : arms) {
                Pooling pooling{metric, condition, load, fullName(arm), isInsecure(arm), {}, {}};
                for (const Machine &machine : machines)
                    pooling.machines.emplace_back(machine.label, contrastOf(machine.results, pooling));
                const auto measured = std::ranges::count_if(pooling.machines,
                                                            [](const auto &one) { return one.second.has_value(); });
                if (measured < 2)
                    continue;
                pooling.common = commonOf(machines, pooling);
                out.push_back(std::move(pooling));
            }
        });
    }
    return out;
}

/// The arms that not every sweep has, and the machines with several sweeps; as sentences.
std::string designText(const std::vector<Machine> &machines)
{
    std::string out;
    for (const SweepArm &arm : armsOf(machines)) {
        std::string missing;
        for (const Machine &machine : machines) {
            if (std::ranges::find(machine.results.plan.arms, arm) == machine.results.plan.arms.end())
                missing += (missing.empty() ? "" : ", ") + machine.label;
        }
        if (!missing.empty())
            out += " " + fullName(arm) + " is not in " + missing + ".";
    }
    for (const std::vector<std::size_t> &sweeps : daysOfMachines(machines)) {
        std::string labels;
        for (const std::size_t sweep : sweeps)
            labels += (labels.empty() ? "" : ", ") + machines[sweep].label;
        if (sweeps.size() > 1)
            out += " " + labels + " are days of one machine, since their hardware and vehicle are the same.";
    }
    return out;
}

/// As much of both ends as the column of labels has room for. UTF-8.
std::string shortened(const std::string &label)
{
    constexpr std::size_t kMost = 18, kHead = 5;
    std::vector<std::size_t> starts; ///< of the characters
    for (std::size_t i = 0; i < label.size(); ++i) {
        if ((static_cast<unsigned char>(label[i]) & 0xc0) != 0x80)
            starts.push_back(i);
    }
    if (starts.size() <= kMost)
        return label;
    return label.substr(0, starts[kHead]) + "…" + label.substr(starts[starts.size() - (kMost - kHead - 1)]);
}

ForestChart chartOf(const Plan &plan, const Pooling &pooling)
{
    ForestChart out;
    out.title = pooling.arm + (pooling.insecure ? " (insecure)" : "") + ": "
        + std::string(info(pooling.metric).title.english());
    out.subtitle = "link: " + conditionText(plan.conditions[pooling.condition])
        + "; load: " + std::string(name(plan.loads[pooling.load]));
    out.axis = "ratio to " + referenceText(plan);
    out.margin = plan.margin;
    out.legend = pooling.common ? "95 % intervals; below, all machines by random effects (REML, Hartung–Knapp), grey line: a "
                                  "further machine"
                                : "95 % intervals; each sweep stands alone";
    for (const auto &[label, contrast] : pooling.machines) {
        ForestRow row;
        row.label = shortened(label);
        if (contrast) {
            row.value = contrast->value();
            row.low = contrast->low();
            row.high = contrast->high();
        }
        out.rows.push_back(std::move(row));
    }
    if (pooling.common) {
        ForestRow row;
        row.label = "all machines";
        row.value = std::exp(pooling.common->mean);
        row.low = std::exp(pooling.common->low);
        row.high = std::exp(pooling.common->high);
        row.expectedLow = std::exp(pooling.common->predictionLow);
        row.expectedHigh = std::exp(pooling.common->predictionHigh);
        row.isSummary = true;
        out.rows.push_back(std::move(row));
    }
    return out;
}

std::string cellsOf(const std::vector<std::string> &cells, const char *tag = "td")
{
    std::string out = "<tr>";
    for (const std::string &cell : cells)
        out += std::string("<") + tag + ">" + escaped(cell) + "</" + tag + ">";
    return out + "</tr>\n";
}

/// Every entry of the settings, the machines beside each other.
std::string machineTable(const std::vector<Machine> &machines)
{
    std::vector<std::string> keys, head{"setting"};
    for (const Machine &machine : machines) {
        head.push_back(machine.label);
        for (const auto &[key, value] : machine.results.setting) {
            if (std::ranges::find(keys, key) == keys.end())
                keys.push_back(key);
        }
    }
    std::string out = "<table border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n<thead>\n" + cellsOf(head, "th")
        + "</thead>\n";
    std::vector<std::string> design{"launches × repeats × seconds; seed"};
    for (const Machine &machine : machines) {
        const Plan &plan = machine.results.plan;
        design.push_back(std::to_string(plan.launches) + " × " + std::to_string(plan.repeats) + " × "
                         + readable(seconds(plan.measure)) + "; " + std::to_string(plan.seed)
                         + (machine.results.complete ? "" : " (incomplete)"));
    }
    out += cellsOf(design);
    for (const std::string &key : keys) {
        std::vector<std::string> cells{key};
        for (const Machine &machine : machines)
            cells.push_back(settingOf(machine.results, key));
        out += cellsOf(cells);
    }
    return out + "</table>\n";
}

std::string nameOf(const Pooling &pooling, const Plan &plan)
{
    std::string out = "forest-" + std::string(info(pooling.metric).key) + "-" + std::string(name(plan.loads[pooling.load]))
        + "-" + pooling.arm + (plan.conditions.size() > 1 ? "-" + std::to_string(pooling.condition + 1) : "");
    std::ranges::replace(out, ' ', '-');
    return out;
}

std::vector<ReportFigure> figuresOf(const std::vector<Pooling> &poolings, const Plan &plan)
{
    std::vector<ReportFigure> out;
    out.reserve(poolings.size());
    for (const Pooling &pooling : poolings)
        out.push_back({nameOf(pooling, plan), svg(chartOf(plan, pooling))});
    return out;
}

} // namespace

std::vector<ReportFigure> forestsOf(const std::vector<Machine> &machines)
{
    return figuresOf(poolingsOf(machines), machines.front().results.plan);
}

constexpr std::pair<std::string_view, std::string_view> kPooledColumns[] = {
    {"condition", "link condition: clean, or the impairments of both directions"},
    {"load", "natural, saturated, or pps and the frames a second of a paced load"},
    {"metric", "what is compared; a column of sweep.csv"},
    {"arm", "suite and framing that are compared with the reference"},
    {"machine", "name of the sweep's folder; all machines: what they have in common"},
    {"ratio", "the arm to the reference"},
    {"ci95_low", "lower end of its 95 % interval"},
    {"ci95_high", "upper end of its 95 % interval"},
    {"log_ratio", "natural logarithm of the ratio"},
    {"error", "its standard error"},
    {"tau2", "variance of the logarithms between machines; of all machines only"},
    {"prediction_low", "above it, a further machine lies at 95 %; of all machines only"},
    {"prediction_high", "below it; of all machines only"},
    {"insecure", "1: a research suite, or a cipher without authentication"},
    {"sweep", "when the sweep began (UTC); empty for all machines, as are the columns that follow"},
    {"seed", "of the order of runs and of the impairment"},
    {"commit", "the programs' version in the repository"},
    {"hardware", "processor, cores, memory and vehicle; sweeps of one hardware are days of one machine"}};

std::string pooledColumnsCsv()
{
    std::string out = "column,unit,description\n";
    for (const auto &[name, what] : kPooledColumns)
        out += std::string(name) + ",," + csvText(std::string(what)) + "\n";
    return out;
}

std::string pooledCsv(const std::vector<Machine> &machines)
{
    const Plan &plan = machines.front().results.plan;
    std::string out;
    for (const auto &[name, what] : kPooledColumns)
        out += (out.empty() ? "" : ",") + std::string(name);
    out += "\n";
    for (const Pooling &pooling : poolingsOf(machines)) {
        std::string place = csvText(plan.conditions[pooling.condition].name) + ",";
        place.append(name(plan.loads[pooling.load])).append(",").append(info(pooling.metric).key).append(",");
        place += csvText(pooling.arm) + ",";
        const auto line = [&](const std::string &label, const std::vector<double> &values) {
            out += place + csvText(label);
            for (const double value : values)
                out += "," + csvNumber(value);
            out += pooling.insecure ? ",1" : ",0";
        };
        for (std::size_t i = 0; i < machines.size(); ++i) {
            const auto &[label, one] = pooling.machines[i];
            if (!one)
                continue;
            line(label, {one->value(), one->low(), one->high(), one->estimate, one->error, kNaN, kNaN, kNaN});
            const Results &results = machines[i].results;
            for (const std::string &text : {settingOf(results, "time"), std::to_string(results.plan.seed),
                                            settingOf(results, "commit"), hardwareOf(machines[i])})
                out += "," + (text.empty() ? std::string() : csvText(text));
            out += "\n";
        }
        if (const auto &all = pooling.common) {
            line("all machines",
                 {std::exp(all->mean), std::exp(all->low), std::exp(all->high), all->mean, all->error, all->variance,
                  std::exp(all->predictionLow), std::exp(all->predictionHigh)});
            out += ",,,,\n";
        }
    }
    return out;
}

static std::string pooledBody(const std::vector<Machine> &machines, bool inlineFigures)
{
    const Plan &plan = machines.front().results.plan;
    const std::vector<Pooling> poolings = poolingsOf(machines);
    std::string out = "<h1>What each cipher suite costs on several machines</h1>\n";
    for (const Machine &machine : machines) {
        for (const Reason &warning : reportWarnings(machine.results))
            out += "<p class=\"bad\">" + escaped(machine.label + ": " + warning.text()) + ".</p>\n";
    }
    out += "<p>" + std::to_string(machines.size()) + " sweeps. Each ratio to " + escaped(referenceText(plan))
        + " and its 95 % interval come from the launches of one sweep. "
        + (daysOfMachines(machines).size() < kLeastMachines
               ? "With fewer than three machines nothing can be said of others: each stands alone."
               : "All machines are joined by random effects: the variance between machines by REML, the "
                 "interval of the mean by "
                 "Hartung and Knapp, and a prediction interval, in which a further machine lies at 95 %.")
        + escaped(designText(machines)) + "</p>\n<h2>Ratios</h2>\n";
    const std::vector<ReportFigure> figures = figuresOf(poolings, plan);
    if (!inlineFigures)
        out += figuresInPairs(figures);
    for (std::size_t i = 0; inlineFigures && i < figures.size(); ++i)
        out += "<figure>" + figures[i].svg + "</figure>\n";
    if (poolings.empty())
        out += "<p>No ratio was measured often enough in two sweeps.</p>\n";
    return out + "<h2>Machines</h2>\n" + machineTable(machines);
}

std::string pooledHtml(const std::vector<Machine> &machines)
{
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta name=\"color-scheme\" "
           "content=\"light\"/>\n<title>Skyseal sweeps</title>\n<style>body{font-family:'DejaVu "
           "Sans',Verdana,sans-serif;font-size:14px;max-width:1180px;margin:2em auto;padding:0 "
           "1em}.bad{color:#c00000;font-weight:bold}table{border-collapse:collapse;font-size:12px}th,td{border:1px solid "
           "#ccc;padding:3px 7px;text-align:left}figure{display:inline-block;margin:.5em}</style>\n</head>\n<body>\n"
        + pooledBody(machines, true) + "</body>\n</html>\n";
}

std::string pooledPrint(const std::vector<Machine> &machines)
{
    return "<html><body>" + pooledBody(machines, false) + "</body></html>";
}

} // namespace skyseal::experiment
