#include "core/experiment/sweep_csv.h"

#include "core/experiment/contrast.h"
#include "core/experiment/csv.h"
#include "core/experiment/disturbances.h"
#include "core/experiment/relay_comparison.h"
#include "core/experiment/setting.h"

#include <string_view>
#include <utility>
#include <vector>

namespace skyseal::experiment {

namespace {

struct Column
{
    std::string_view name, unit, what;
};
/// Those of sweepCsv() before and after the metrics.
constexpr Column kBefore[] = {
    {"order", "", "position among all runs of the sweep, from 0"},
    {"condition", "", "link condition: clean, or the impairments of both directions"},
    {"load", "", "natural, saturated, or pps and the frames a second of a paced load"},
    {"suite", "", "cipher suite; none: plain MAVLink"},
    {"framing", "", "sealed: whole frames in records; inline: payloads sealed in place; bare: not authenticated; plain: none"},
    {"again", "", "1: the repetition of another arm under a second name (A/A)"},
    {"launch", "", "which start of all programs, from 0"},
    {"repeat", "", "block of the launch, condition and load, from 0; every arm is in it once"},
    {"phase", "", "of the flight in which the run was measured, from 0; empty without flights"},
    {"start", "s", "since the sweep began"},
    {"seconds", "s", "length of the measurement"}};
constexpr Column kRatios[] = {{"condition", "", "link condition: clean, or the impairments of both directions"},
                              {"load", "", "natural, saturated, or pps and the frames a second of a paced load"},
                              {"metric", "", "what is compared; a column of sweep.csv"},
                              {"first", "", "cipher suite to which the second is compared; none: plain MAVLink"},
                              {"first_framing", "", "its framing: sealed, inline, bare, or plain"},
                              {"second", "", "cipher suite that is compared"},
                              {"second_framing", "", "its framing"},
                              {"again", "", "1: the second is the first under another name (A/A)"},
                              {"scale", "", "ratio: the value is second / first; difference: it is second - first, of shares"},
                              {"value", "", "the ratio, or the difference in the unit of the metric"},
                              {"ci95_low", "", "lower end of its 95 % interval; empty without one"},
                              {"ci95_high", "", "upper end of its 95 % interval"},
                              {"p", "", "of no ratio but 1, no difference but 0; empty without a test"},
                              {"p_holm", "", "the same, by Holm for all comparisons of the metric, condition and load"},
                              {"df", "", "degrees of freedom of Student's t"},
                              {"units", "", "launches or blocks that were measured"},
                              {"unit", "", "of the error: launch, or block of the only launch"},
                              {"sweep", "", "when the sweep began (UTC)"},
                              {"seed", "", "of the order of runs and of the impairment"},
                              {"commit", "", "the programs' version in the repository"},
                              {"machine", "", "processor, number of cores, architecture and system"}};
constexpr Column kAfter[] = {
    {"valid", "",
     "1: the values count; 0: they are left out of every mean and comparison; empty: not checked (an older sweep)"},
    {"attempts", "", "how often the run was measured; the values are those of the last attempt; empty: not recorded"},
    {"invalid", "", "why the values are not those of the load; empty if they are"},
    {"disturbances", "", "what may have disturbed the run"},
    {"problem", "", "why nothing was measured; empty on success"},
    {"relay_unit", "", "what is counted in the next two columns: records, or frames; empty without a relay"},
    {"relay_lost", "", "lost in the run on the way to the station, as it measured"},
    {"relay_dropped", "", "in the datagrams that the relay dropped, by its own log"},
    {"source", "", "what the vehicle is: the sweep's own simulator, or the autopilot on which link"},
    {"sweep", "", "when the sweep began (UTC)"},
    {"seed", "", "of the order of runs and of the impairment"},
    {"commit", "", "the programs' version in the repository"},
    {"machine", "", "processor, number of cores, architecture and system"}};

/// The last columns of each table: which sweep it is, and on which machine.
std::string originColumns(const Results &results)
{
    std::string machine;
    for (const auto &[key, unit] : {std::pair("processor", ""), {"cores", " cores"}, {"architecture", ""}, {"system", ""}})
        if (const std::string value = settingOf(results, key); !value.empty())
            machine += (machine.empty() ? "" : ", ") + value + unit;
    std::string out;
    for (const std::string &text :
         {settingOf(results, "time"), std::to_string(results.plan.seed), settingOf(results, "commit"), machine})
        out += "," + (text.empty() ? std::string() : csvText(text));
    return out;
}

std::vector<Column> sampleColumns()
{
    std::vector<Column> out(std::begin(kBefore), std::end(kBefore));
    for (const MetricInfo &metric : metrics())
        out.push_back({metric.key, metric.unit, metric.description.english()});
    out.insert(out.end(), std::begin(kAfter), std::end(kAfter));
    return out;
}

std::string headOf(const std::vector<Column> &columns)
{
    std::string out;
    for (const Column &column : columns)
        out.append(out.empty() ? "" : ",").append(column.name);
    return out + "\n";
}

std::string dictionaryOf(const std::vector<Column> &columns)
{
    std::string out = "column,unit,description\n";
    for (const auto &[name, unit, what] : columns)
        out += std::string(name) + "," + csvText(std::string(unit)) + "," + csvText(std::string(what)) + "\n";
    return out;
}

} // namespace

std::string sweepColumnsCsv()
{
    return dictionaryOf(sampleColumns());
}

std::string ratioColumnsCsv()
{
    return dictionaryOf({std::begin(kRatios), std::end(kRatios)});
}

std::string ratiosCsv(const Results &results)
{
    const Plan &plan = results.plan;
    std::string out = headOf({std::begin(kRatios), std::end(kRatios)});
    const std::string origin = originColumns(results);
    const auto add = [&](const Contrast &contrast) {
        const SweepArm &first = plan.arms[contrast.first], &second = plan.arms[contrast.second];
        out += csvText(plan.conditions[contrast.condition].name) + ",";
        out.append(name(plan.loads[contrast.load])).append(",").append(info(contrast.metric).key);
        for (const SweepArm *arm : {&first, &second})
            out.append(",").append(crypto::suiteInfo(arm->suite).name).append(",").append(framingName(*arm));
        out.append(second.again ? ",1," : ",0,").append(contrast.relative ? "ratio" : "difference");
        for (const double value : {contrast.value(), contrast.low(), contrast.high(), contrast.p, contrast.adjusted,
                                   contrast.degrees, static_cast<double>(contrast.units)})
            out += "," + csvNumber(value);
        out.append(contrast.ofLaunches ? ",launch" : ",block").append(origin).append("\n");
    };
    forEachPlace(plan, [&](std::size_t condition, std::size_t load) {
        for (const MetricInfo &metric : metrics())
            for (const Contrast &contrast : plannedContrasts(results, condition, load, metric.metric))
                add(contrast);
    });
    for (const Contrast &noise : noiseContrasts(results))
        add(noise);
    return out;
}

std::string sweepCsv(const Results &results)
{
    std::string out = headOf(sampleColumns());
    const std::string origin = originColumns(results);
    for (const Sample &sample : results.samples) {
        const Plan &plan = results.plan;
        const SweepArm &one = plan.arms[sample.run.arm];
        out += std::to_string(sample.order) + "," + csvText(plan.conditions[sample.run.condition].name) + ",";
        out.append(name(plan.loads[sample.run.load])).append(",").append(crypto::suiteInfo(one.suite).name);
        out.append(",").append(framingName(one));
        out += std::string(one.again ? ",1," : ",0,") + std::to_string(sample.run.launch) + ","
            + std::to_string(sample.run.repeat) + ","
            + (plan.flight.empty() ? std::string() : std::to_string(phaseOf(plan, sample.run))) + "," + csvNumber(sample.start)
            + "," + csvNumber(sample.seconds);
        for (const MetricInfo &metric : metrics())
            out += "," + csvNumber(sample.values[metric.metric]);
        out += sample.isJudged ? std::string(sample.isValid() ? ",1," : ",0,") + std::to_string(sample.attempts) : ",,";
        std::string disturbed;
        for (const std::string &text : disturbances(sample))
            disturbed += (disturbed.empty() ? "" : "; ") + text;
        const auto add = [&out](const std::string &text) { out += "," + (text.empty() ? std::string() : csvText(text)); };
        for (const std::string &text : {sample.invalid.text(), disturbed, sample.problem.text()})
            add(text);
        if (const auto relay = comparedWithRelay(plan, sample))
            out += "," + std::string(relay->unit) + "," + std::to_string(relay->lost) + "," + std::to_string(relay->dropped);
        else
            out += ",,,";
        add(results.source);
        out += origin + "\n";
    }
    return out;
}

} // namespace skyseal::experiment
