#include "core/experiment/pooled_report.h"

#include "core/experiment/bar_chart.h"
#include "core/experiment/contrast.h"
#include "core/experiment/csv.h"
#include "core/experiment/forest_chart.h"
#include "core/experiment/html_parts.h"
#include "core/experiment/random_effects.h"
#include "core/experiment/report_warnings.h"
#include "core/experiment/sweep_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace skyseal::experiment {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::string framingsText(const Plan &plan)
{
    std::string out;
    for (const ArmFraming framing : framingsOf(plan))
        out += (out.empty() ? "" : ", ") + std::string(name(framing));
    return out.empty() ? "plain MAVLink only" : out;
}

std::string loadsText(const Plan &plan)
{
    std::string out;
    for (const Load load : plan.loads)
        out += (out.empty() ? "" : ", ") + std::string(name(load));
    return out;
}

std::string conditionsText(const Plan &plan)
{
    std::string out;
    for (const Condition &condition : plan.conditions)
        out += (out.empty() ? "" : "; ") + condition.name;
    return out;
}

struct Fact
{
    const char *what;
    std::string (*of)(const Machine &machine);
};

/// Settings that must match for ratios of several sweeps to be comparable.
const Fact kFacts[] = {
    {"schema version", [](const Machine &one) { return std::to_string(one.schemaVersion); }},
    {"framing", [](const Machine &one) { return framingsText(one.results.plan); }},
    {"load", [](const Machine &one) { return loadsText(one.results.plan); }},
    {"link", [](const Machine &one) { return conditionsText(one.results.plan); }},
    {"seconds of a run", [](const Machine &one) { return readable(seconds(one.results.plan.measure)); }},
    {"warm-up", [](const Machine &one) { return readable(seconds(one.results.plan.warmUp)) + " s"; }},
    {"reference", [](const Machine &one) { return referenceText(one.results.plan); }},
    {"message mix", [](const Machine &one) { return settingOf(one.results, "message_mix"); }},
    {"commit", [](const Machine &one) { return settingOf(one.results, "commit"); }},
};

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

std::vector<Pooling> poolingsOf(const std::vector<Machine> &machines)
{
    std::vector<Pooling> out;
    const Plan &plan = machines.front().results.plan;
    for (const Metric metric : metricsShownIn(kRatio)) {
        for (std::size_t condition = 0; condition < plan.conditions.size(); ++condition) {
            for (std::size_t load = 0; load < plan.loads.size(); ++load) {
                for (const SweepArm &arm : plan.arms) {
                    if (arm.again || !exists(arm))
                        continue;
                    Pooling pooling{metric, condition, load, fullName(arm), isInsecure(arm), {}, {}};
                    std::vector<MachineEffect> effects;
                    for (const Machine &machine : machines) {
                        const auto contrast = contrastOf(machine.results, pooling);
                        pooling.machines.emplace_back(machine.label, contrast);
                        if (contrast && contrast->error > 0)
                            effects.push_back({contrast->estimate, contrast->error});
                    }
                    pooling.common = pooled(effects);
                    const auto measured = std::ranges::count_if(pooling.machines,
                                                                [](const auto &one) { return one.second.has_value(); });
                    if (measured >= 2)
                        out.push_back(std::move(pooling));
                }
            }
        }
    }
    return out;
}

ForestChart chartOf(const Plan &plan, const Pooling &pooling)
{
    ForestChart out;
    out.title = pooling.arm + ": " + std::string(info(pooling.metric).title);
    out.subtitle = "link: " + conditionText(plan.conditions[pooling.condition])
        + "; load: " + std::string(name(plan.loads[pooling.load]));
    out.axis = "ratio to " + referenceText(plan);
    out.margin = plan.margin;
    out.legend = pooling.common ? "95 % intervals; below, all machines by random effects (REML, Hartung–Knapp), grey line: a "
                                  "further machine"
                                : "95 % intervals; each machine stands alone";
    for (const auto &[label, contrast] : pooling.machines) {
        ForestRow row;
        row.label = label;
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

std::string mismatchOf(const std::vector<Machine> &machines)
{
    for (const Machine &other : machines) {
        for (const Fact &fact : kFacts) {
            const std::string one = fact.of(machines.front()), two = fact.of(other);
            if (one != two)
                return "the sweeps cannot be joined: " + std::string(fact.what) + " of " + machines.front().label + " is "
                    + (one.empty() ? "not recorded" : one) + ", of " + other.label + " " + (two.empty() ? "not recorded" : two);
        }
    }
    return {};
}

std::vector<ReportFigure> forestsOf(const std::vector<Machine> &machines)
{
    return figuresOf(poolingsOf(machines), machines.front().results.plan);
}

std::string pooledCsv(const std::vector<Machine> &machines)
{
    const Plan &plan = machines.front().results.plan;
    std::string out = "condition,load,metric,arm,machine,ratio,ci95_low,ci95_high,log_ratio,error,tau2,prediction_low,"
                      "prediction_high\n";
    for (const Pooling &pooling : poolingsOf(machines)) {
        std::string place = csvText(plan.conditions[pooling.condition].name) + ",";
        place.append(name(plan.loads[pooling.load])).append(",").append(info(pooling.metric).key).append(",");
        place += csvText(pooling.arm) + ",";
        const auto line = [&](const std::string &label, const std::vector<double> &values) {
            out += place + csvText(label);
            for (const double value : values)
                out += "," + csvNumber(value);
            out += "\n";
        };
        for (const auto &[label, one] : pooling.machines) {
            if (one)
                line(label, {one->value(), one->low(), one->high(), one->estimate, one->error, kNaN, kNaN, kNaN});
        }
        if (const auto &all = pooling.common)
            line("all machines",
                 {std::exp(all->mean), std::exp(all->low), std::exp(all->high), all->mean, all->error, all->variance,
                  std::exp(all->predictionLow), std::exp(all->predictionHigh)});
    }
    return out;
}

static std::string pooledBody(const std::vector<Machine> &machines, bool inlineFigures)
{
    const Plan &plan = machines.front().results.plan;
    const std::vector<Pooling> poolings = poolingsOf(machines);
    std::string out = "<h1>What each cipher suite costs on several machines</h1>\n";
    for (const Machine &machine : machines) {
        for (const std::string &warning : reportWarnings(machine.results))
            out += "<p class=\"bad\">" + escaped(machine.label + ": " + warning) + ".</p>\n";
    }
    out += "<p>" + std::to_string(machines.size()) + " sweeps. Each ratio to " + escaped(referenceText(plan))
        + " and its 95 % interval come from the launches of one sweep. "
        + (machines.size() < kLeastMachines
               ? "With fewer than three machines nothing can be said of others: each stands alone."
               : "All machines are joined by random effects: the variance between machines by REML, the "
                 "interval of the mean by "
                 "Hartung and Knapp, and a prediction interval, in which a further machine lies at 95 %.")
        + "</p>\n<h2>Ratios</h2>\n";
    const std::vector<ReportFigure> figures = figuresOf(poolings, plan);
    if (!inlineFigures)
        out += figuresInPairs(figures);
    for (std::size_t i = 0; inlineFigures && i < figures.size(); ++i)
        out += "<figure>" + figures[i].svg + "</figure>\n";
    if (poolings.empty())
        out += "<p>No ratio was measured often enough on two machines.</p>\n";
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
