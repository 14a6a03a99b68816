#include "ui/sweep/ratio_chart.h"

#include "core/experiment/contrast.h"
#include "ui/sweep/sweep_labels.h"
#include "ui/text/vehicle_text.h"

#include <limits>

namespace skyseal::ui {

experiment::BarChart ratioChart(const experiment::Results &results, std::size_t condition, std::size_t load,
                                experiment::Metric metric)
{
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    const experiment::Plan &plan = results.plan;
    const auto reference = experiment::referenceArm(plan);
    experiment::BarChart out;
    out.title = metricTitle(metric).toStdString();
    out.axis = out.title + ": " + ratiosText(plan).toStdString();
    for (const experiment::SweepArm &arm : plan.arms) {
        experiment::Bar bar;
        bar.suite = arm.suite;
        bar.insecure = experiment::isInsecure(arm);
        bar.mean = bar.low = bar.high = kNaN;
        out.bars.push_back(std::move(bar));
    }
    for (const experiment::Contrast &one : experiment::plannedContrasts(results, condition, load, metric)) {
        if (one.first != reference)
            continue;
        experiment::Bar &bar = out.bars[one.second];
        bar.mean = one.value();
        bar.low = one.low();
        bar.high = one.high();
        bar.text = ratioText(one).toStdString();
        out.bars[*reference].mean = 1;
        out.bars[*reference].text = "1";
    }
    return out;
}

} // namespace skyseal::ui
