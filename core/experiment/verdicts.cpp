#include "core/experiment/verdicts.h"

#include "core/experiment/analysis.h"

#include <algorithm>
#include <limits>

namespace skyseal::experiment {

Result<void, InputError> fits(const Expectation &expectation, const Plan &plan)
{
    for (const crypto::SuiteId suite : expectation.suites()) {
        const auto has = [suite](const SweepArm &arm) { return arm.suite == suite && !arm.again; };
        if (std::none_of(plan.arms.begin(), plan.arms.end(), has))
            return tl::unexpected(
                InputError{"the sweep does not measure " + std::string(crypto::suiteInfo(suite).name), expectation.text()});
    }
    for (const Load load : expectation.loads()) {
        if (std::find(plan.loads.begin(), plan.loads.end(), load) == plan.loads.end())
            return tl::unexpected(
                InputError{"the sweep does not measure the " + std::string(name(load)) + " load", expectation.text()});
    }
    const std::vector<ArmFraming> framings = framingsOf(plan);
    for (const ArmFraming framing : expectation.framings()) {
        if (std::find(framings.begin(), framings.end(), framing) == framings.end())
            return tl::unexpected(
                InputError{"the sweep does not measure the framing " + std::string(name(framing)), expectation.text()});
    }
    return {};
}

namespace {

/// True if any run of the cell succeeded and was valid.
bool ran(const Results &results, const Cell &cell)
{
    return std::any_of(results.samples.begin(), results.samples.end(), [&](const Sample &sample) {
        return Cell{sample.run.condition, sample.run.load, sample.run.arm} == cell && sample.isValid();
    });
}

/// Under one condition. `load` is used for metrics that name none, if the assertion is checked for each load.
std::vector<Verdict> judgeAt(const Expectation &expectation, const Results &results, std::size_t condition,
                             std::optional<std::size_t> load)
{
    const Plan &plan = results.plan;
    bool allRan = true; // every cell that was looked up
    const auto lookup = [&](Metric metric, crypto::SuiteId suite, std::optional<ArmFraming> framing,
                            std::optional<Load> named) {
        const auto at = std::find(plan.loads.begin(), plan.loads.end(), named.value_or(plan.loads[load.value_or(0)]));
        const auto arm = std::find_if(plan.arms.begin(), plan.arms.end(), [&](const SweepArm &one) {
            const bool fits = suite == crypto::SuiteId::None || !framing || one.framing == *framing;
            return one.suite == suite && !one.again && fits;
        });
        const auto loadAt = static_cast<std::size_t>(at - plan.loads.begin());
        allRan = allRan && arm != plan.arms.end()
            && ran(results, {condition, loadAt, static_cast<std::size_t>(arm - plan.arms.begin())});
        return arm == plan.arms.end() ? std::numeric_limits<double>::quiet_NaN()
                                      : meanOf(results, condition, loadAt, *arm, metric);
    };
    if (!expectation.isForEachSuite())
        return {{expectation.text(), condition, {}, load, expectation.check({}, lookup)}};
    std::vector<Verdict> each, without;
    for (const SweepArm &arm : plan.arms) {
        const ArmFraming wanted = expectation.onlyFraming().value_or(arm.framing);
        const bool included = arm.suite == crypto::SuiteId::None || wanted == arm.framing;
        if (arm.again || !included || !exists(arm))
            continue;
        allRan = true;
        Verdict verdict{expectation.text(), condition, name(arm), load, expectation.check(arm, lookup)};
        const bool hasNone = !verdict.outcome.measured && allRan;
        (hasNone ? without : each).push_back(std::move(verdict));
    }
    return each.empty() ? without : each;
}

} // namespace

std::vector<Verdict> judge(const Expectation &expectation, const Results &results)
{
    const Plan &plan = results.plan;
    std::vector<Verdict> out;
    const auto add = [&](std::size_t condition, std::optional<std::size_t> load) {
        const auto judged = judgeAt(expectation, results, condition, load);
        out.insert(out.end(), judged.begin(), judged.end());
    };
    for (std::size_t condition = 0; condition < plan.conditions.size(); ++condition) {
        if (!expectation.isForEachLoad())
            add(condition, std::nullopt);
        for (std::size_t load = 0; expectation.isForEachLoad() && load < plan.loads.size(); ++load)
            add(condition, load);
    }
    return out;
}

std::string verdictText(const Verdict &verdict, const Plan &plan)
{
    std::string out = verdict.expectation;
    if (!verdict.suite.empty())
        out += " [" + verdict.suite + "]";
    if (verdict.load && plan.loads.size() > 1)
        out += " [" + std::string(name(plan.loads[*verdict.load])) + "]";
    if (plan.conditions.size() > 1)
        out += " [" + plan.conditions[verdict.condition].name + "]";
    if (!verdict.outcome.measured)
        return out + ": was not measured: FAILS";
    return out + ": " + readable(verdict.outcome.left) + " against " + readable(verdict.outcome.right)
        + (verdict.outcome.holds ? ": holds" : ": FAILS");
}

} // namespace skyseal::experiment
