#include "core/experiment/verdicts.h"

#include "core/experiment/analysis.h"

#include <algorithm>
#include <limits>

namespace skyseal::experiment {

using channel::Framing;

Result<void, InputError> fits(const Expectation &expectation, const Plan &plan)
{
    for (const crypto::SuiteId suite : expectation.suites()) {
        const auto has = [suite](const Arm &arm) { return arm.suite == suite && !arm.again; };
        if (std::none_of(plan.arms.begin(), plan.arms.end(), has))
            return tl::unexpected(InputError{"the sweep does not measure " + std::string(crypto::suiteInfo(suite).name),
                                             expectation.text()});
    }
    for (const Load load : expectation.loads()) {
        if (std::find(plan.loads.begin(), plan.loads.end(), load) == plan.loads.end())
            return tl::unexpected(
                InputError{"the sweep does not measure the " + std::string(name(load)) + " load", expectation.text()});
    }
    const std::vector<channel::Framing> framings = framingsOf(plan);
    for (const channel::Framing framing : expectation.framings()) {
        if (std::find(framings.begin(), framings.end(), framing) == framings.end())
            return tl::unexpected(
                InputError{"the sweep does not measure the framing " + std::string(name(framing)), expectation.text()});
    }
    return {};
}

std::vector<Verdict> judge(const Expectation &expectation, const Results &results)
{
    const Plan &plan = results.plan;
    std::vector<Verdict> out;
    for (std::size_t condition = 0; condition < plan.conditions.size(); ++condition) {
        const auto lookup = [&](Metric metric, crypto::SuiteId suite, std::optional<Framing> framing,
                                std::optional<Load> load) {
            const auto at = std::find(plan.loads.begin(), plan.loads.end(), load.value_or(plan.loads.front()));
            const auto arm = std::find_if(plan.arms.begin(), plan.arms.end(), [&](const Arm &one) {
                const bool fits = suite == crypto::SuiteId::None || !framing || one.framing == *framing;
                return one.suite == suite && !one.again && fits;
            });
            return arm == plan.arms.end()
                       ? std::numeric_limits<double>::quiet_NaN()
                       : meanOf(results, condition, static_cast<std::size_t>(at - plan.loads.begin()), *arm, metric);
        };
        if (!expectation.isForEachSuite()) {
            out.push_back({expectation.text(), condition, {}, expectation.check({}, lookup)});
            continue;
        }
        std::vector<Verdict> each;
        for (const Arm &arm : plan.arms) {
            const Framing asked = expectation.onlyFraming().value_or(arm.framing);
            const bool meant = arm.suite == crypto::SuiteId::None || asked == arm.framing;
            if (!arm.again && meant && exists(arm))
                each.push_back({expectation.text(), condition, name(arm), expectation.check(arm, lookup)});
        }
        const bool anyMeasured =
            std::any_of(each.begin(), each.end(), [](const Verdict &verdict) { return verdict.outcome.measured; });
        if (anyMeasured)
            std::erase_if(each, [](const Verdict &verdict) { return !verdict.outcome.measured; });
        out.insert(out.end(), each.begin(), each.end());
    }
    return out;
}

std::string sentence(const Verdict &verdict, const Plan &plan)
{
    std::string out = verdict.expectation;
    if (!verdict.suite.empty())
        out += " [" + verdict.suite + "]";
    if (plan.conditions.size() > 1)
        out += " [" + plan.conditions[verdict.condition].name + "]";
    if (!verdict.outcome.measured)
        return out + ": was not measured: FAILS";
    return out + ": " + readable(verdict.outcome.left) + " against " + readable(verdict.outcome.right)
           + (verdict.outcome.holds ? ": holds" : ": FAILS");
}

} // namespace skyseal::experiment
