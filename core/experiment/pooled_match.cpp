// Which sweeps may be joined in one analysis, and which of them are of the same machine.
#include "core/experiment/message_mix.h"
#include "core/experiment/plan.h"
#include "core/experiment/pooled_report.h"
#include "core/experiment/sweep_text.h"

#include <algorithm>
#include <set>

namespace skyseal::experiment {

namespace {

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

/// The programs of a sweep, by their hashes.
Setting programsOf(const Machine &machine)
{
    Setting out;
    for (const auto &[key, value] : machine.results.setting) {
        if (key.starts_with("sha256_"))
            out.emplace_back(key, value);
    }
    std::ranges::sort(out);
    return out;
}

/// False for one that says no more than that the programs may be any.
bool namesPrograms(const std::string &commit)
{
    return !commit.empty() && commit != "unknown" && !commit.ends_with("-changed");
}

/// Two trees that differ from the same commit may differ from each other: only equal programs are the same then.
std::string programsMismatch(const Machine &one, const Machine &two)
{
    const std::string commit = settingOf(one.results, "commit");
    if (namesPrograms(commit) || (programsOf(one) == programsOf(two) && !programsOf(one).empty()))
        return {};
    return "the sweeps cannot be joined: the programs of " + one.label + " and " + two.label
        + " are not known to be the same: their commit is " + (commit.empty() ? "not recorded" : commit)
        + ", and their SHA-256 " + (programsOf(one).empty() ? "is not recorded" : "differs");
}

bool isCopyOf(const Machine &one, const Machine &two)
{
    const std::string time = settingOf(one.results, "time");
    return !time.empty() && time == settingOf(two.results, "time") && one.results.plan.seed == two.results.plan.seed
        && programsOf(one) == programsOf(two);
}

/// Without the clock rate of that moment.
std::string processorOf(const Results &results)
{
    std::string out = settingOf(results, "processor");
    if (out.ends_with(" MHz"))
        out.erase(std::min(out.rfind(", "), out.size()));
    return out;
}

} // namespace

std::string mismatchOf(const std::vector<Machine> &machines)
{
    for (std::size_t i = 1; i < machines.size(); ++i) {
        const Machine &first = machines.front(), &other = machines[i];
        for (const Fact &fact : kFacts) {
            const std::string one = fact.of(first), two = fact.of(other);
            if (one != two)
                return "the sweeps cannot be joined: " + std::string(fact.what) + " of " + first.label + " is "
                    + (one.empty() ? "not recorded" : one) + ", of " + other.label + " " + (two.empty() ? "not recorded" : two);
        }
        if (const std::string mix = mixDifference(first.results, first.label, other.results, other.label); !mix.empty())
            return "the sweeps cannot be joined: their vehicles sent other messages: " + mix;
        if (std::string problem = programsMismatch(first, other); !problem.empty())
            return problem;
        for (std::size_t before = 0; before < i; ++before) {
            if (isCopyOf(machines[before], other))
                return "the sweeps cannot be joined: " + machines[before].label + " and " + other.label
                    + " are the same sweep, begun at " + settingOf(other.results, "time") + " with the seed "
                    + std::to_string(other.results.plan.seed);
        }
    }
    return {};
}

std::string hardwareOf(const Machine &machine)
{
    const Results &results = machine.results;
    std::string out = processorOf(results);
    if (out.empty() || out == "unknown")
        return {};
    for (const auto &[key, unit] : {std::pair("cores", " cores"), {"memory", ""}, {"architecture", ""}}) {
        if (const std::string value = settingOf(results, key); !value.empty())
            out += ", " + value + unit;
    }
    return results.source.empty() ? out : out + "; " + results.source;
}

std::vector<std::vector<std::size_t>> daysOfMachines(const std::vector<Machine> &machines)
{
    std::vector<std::vector<std::size_t>> out;
    for (std::size_t i = 0; i < machines.size(); ++i) {
        const std::string hardware = hardwareOf(machines[i]);
        const auto same = std::ranges::find_if(out, [&](const std::vector<std::size_t> &days) {
            return !hardware.empty() && hardwareOf(machines[days.front()]) == hardware;
        });
        if (same == out.end())
            out.push_back({i});
        else
            same->push_back(i);
    }
    return out;
}

} // namespace skyseal::experiment
