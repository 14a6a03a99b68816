#include "core/experiment/analysis.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skyseal::experiment {

/// Frames or records that a share is of, in one sample.
static double trialsOf(const Sample &sample, ShareOf share)
{
    const auto grown = [&sample](channel::ReceiveCounters Counted::*records) {
        return static_cast<double>((sample.end.*records).good) - static_cast<double>((sample.begin.*records).good);
    };
    switch (share) {
    case ShareOf::Frames: return sample.values[Metric::Packets];
    case ShareOf::RecordsToStation: return grown(&Counted::rx);
    case ShareOf::RecordsToAgent: return grown(&Counted::tx);
    case ShareOf::Nothing: break;
    }
    return 0;
}

/// The sum over all runs of a cell in which the metric was measured.
static double trialsOf(const Results &results, const Cell &cell, const MetricInfo &metric)
{
    double out = 0;
    for (const Sample &sample : results.samples) {
        if (Cell{sample.run.condition, sample.run.load, sample.run.arm} == cell && sample.isValid()
            && std::isfinite(sample.values[metric.metric]))
            out += trialsOf(sample, metric.shareOf);
    }
    return out;
}

Summary summaryOf(const Results &results, const Cell &cell, Metric metric)
{
    const MetricInfo &described = info(metric);
    Summary out = summarise(valuesOf(results, cell, metric));
    out.least = 0; // loads, shares, times and sizes
    if (described.isShare())
        out.most = 1;
    if (described.isShare() && out.max == 0)
        out.halfWidth = boundOfNone(trialsOf(results, cell, described));
    if (!described.independent)
        out.halfWidth = std::numeric_limits<double>::quiet_NaN();
    return out;
}

/// One test, not corrected yet.
static std::optional<OrderTrend> orderTrendAt(const Results &results, std::size_t condition, std::size_t load, Metric metric)
{
    std::vector<double> places, residuals;
    std::size_t groups = 0;
    for (std::size_t arm = 0; arm < results.plan.arms.size(); ++arm) {
        const std::vector<double> values = valuesOf(results, {condition, load, arm}, metric);
        const std::vector<unsigned> orders = ordersOf(results, {condition, load, arm});
        std::vector<double> logs, at;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (!(values[i] > 0) || !std::isfinite(values[i]))
                continue;
            logs.push_back(std::log(values[i]));
            at.push_back(orders[i]);
        }
        if (logs.size() < 2)
            continue;
        ++groups;
        const double mean = summarise(logs).mean, meanPlace = summarise(at).mean;
        for (std::size_t i = 0; i < logs.size(); ++i) {
            residuals.push_back(logs[i] - mean);
            places.push_back(at[i] - meanPlace);
        }
    }
    const Trend trend = trendOf(places, residuals, groups);
    if (std::isnan(trend.p))
        return std::nullopt;
    return OrderTrend{condition, load, metric, std::expm1(trend.slope), trend.p};
}

std::vector<OrderTrend> orderTrends(const Results &results)
{
    std::vector<OrderTrend> out;
    std::vector<double> p;
    for (std::size_t condition = 0; condition < results.plan.conditions.size(); ++condition) {
        for (std::size_t load = 0; load < results.plan.loads.size(); ++load) {
            for (const Metric metric : {Metric::CpuPerFrame, Metric::AgentCpuPerFrame, Metric::OpenP50, Metric::Latency}) {
                if (const auto trend = orderTrendAt(results, condition, load, metric)) {
                    out.push_back(*trend);
                    p.push_back(trend->p);
                }
            }
        }
    }
    const std::vector<double> adjusted = holm(p);
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i].p = adjusted[i];
    return out;
}

double meanOf(const Results &results, std::size_t condition, std::size_t load, const SweepArm &wanted, Metric metric)
{
    const std::vector<SweepArm> &arms = results.plan.arms;
    const auto found = std::find(arms.begin(), arms.end(), wanted);
    if (found == arms.end())
        return std::numeric_limits<double>::quiet_NaN();
    const auto arm = static_cast<std::size_t>(found - arms.begin());
    return summarise(valuesOf(results, {condition, load, arm}, metric)).mean;
}

bool wasMeasured(const Results &results, Metric metric)
{
    return std::any_of(results.samples.begin(), results.samples.end(),
                       [metric](const Sample &sample) { return sample.isValid() && std::isfinite(sample.values[metric]); });
}

} // namespace skyseal::experiment
