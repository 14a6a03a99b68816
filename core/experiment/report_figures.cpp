#include "core/experiment/report_figures.h"

#include "core/experiment/analysis.h"
#include "core/experiment/bar_chart.h"
#include "core/experiment/contrast.h"
#include "core/experiment/forest_chart.h"
#include "core/experiment/sweep_text.h"

#include <algorithm>

namespace skyseal::experiment {

/// Each arm against the reference.
static ForestChart ratioChart(const Results &results, std::size_t condition, std::size_t load, Metric metric)
{
    const Plan &plan = results.plan;
    const auto reference = referenceArm(plan);
    ForestChart out;
    out.title = info(metric).title.english();
    out.subtitle = "link: " + conditionText(plan.conditions[condition]) + "; load: " + std::string(name(plan.loads[load]));
    out.axis = "ratio to " + referenceText(plan);
    out.margin = plan.margin;
    const std::vector<Contrast> contrasts = plannedContrasts(results, condition, load, metric);
    for (std::size_t arm = 0; arm < plan.arms.size(); ++arm) {
        if (arm == reference || plan.arms[arm].again || !exists(plan.arms[arm]))
            continue;
        ForestRow row;
        row.label = name(plan.arms[arm]);
        row.hollow = isInsecure(plan.arms[arm]);
        const auto found = std::ranges::find_if(
            contrasts, [&](const Contrast &one) { return one.first == reference && one.second == arm; });
        if (found != contrasts.end()) {
            row.value = found->value();
            row.low = found->low();
            row.high = found->high();
        }
        out.rows.push_back(std::move(row));
    }
    out.legend = "95 % intervals from " + std::to_string(plan.launches) + (plan.launches == 1 ? " launch" : " launches")
        + " of " + std::to_string(plan.repeats) + (plan.repeats == 1 ? " run" : " runs")
        + " each; ring: insecure; grey: within " + readable(100 * plan.margin) + " %";
    return out;
}

std::vector<ReportFigure> figuresOf(const Results &results)
{
    std::vector<ReportFigure> out;
    const auto fileOf = [&](Metric metric, std::size_t condition, std::size_t load) {
        std::string file = std::string(info(metric).key) + "-" + std::string(name(results.plan.loads[load]));
        return results.plan.conditions.size() > 1 ? file + "-" + std::to_string(condition + 1) : file;
    };
    for (const Metric metric : metricsShownIn(kRatio)) {
        forEachPlace(results.plan, [&](std::size_t condition, std::size_t load) {
            if (!plannedContrasts(results, condition, load, metric).empty())
                out.push_back({"ratio-" + fileOf(metric, condition, load), svg(ratioChart(results, condition, load, metric))});
        });
    }
    std::vector<Metric> shown = metricsShownIn(kFigure);
    std::stable_partition(shown.begin(), shown.end(), [](Metric metric) { return info(metric).isShownIn(kPaperFigure); });
    for (const Metric metric : shown) {
        if (!wasMeasured(results, metric))
            continue;
        forEachPlace(results.plan, [&](std::size_t condition, std::size_t load) {
            out.push_back({fileOf(metric, condition, load), svg(chartOf(results, condition, load, metric))});
        });
    }
    return out;
}

} // namespace skyseal::experiment
