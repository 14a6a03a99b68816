#include "core/experiment/analysis.h"

#include "core/experiment/least_squares.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

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

/// One test, not corrected yet: log(value) = arm + launch + slope × order, so that what differs between the starts of the
/// programs is no trend.
static std::optional<OrderTrend> orderTrendAt(const Results &results, std::size_t condition, std::size_t load, Metric metric)
{
    std::vector<const Sample *> runs;
    std::map<std::size_t, std::size_t> arms, launches; // numbered from 0, those with runs
    for (const Sample &sample : results.samples) {
        const double value = sample.values[metric];
        if (sample.run.condition != condition || sample.run.load != load || !sample.isValid() || !(value > 0)
            || !std::isfinite(value))
            continue;
        runs.push_back(&sample);
        arms.emplace(sample.run.arm, arms.size());
        launches.emplace(sample.run.launch, launches.size());
    }
    const std::size_t order = arms.size() + launches.size() - 1; // the last column; the first launch has none of its own
    std::vector<double> design(runs.size() * (order + 1)), logs;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        double *row = &design[i * (order + 1)];
        row[arms[runs[i]->run.arm]] = 1;
        if (const std::size_t launch = launches[runs[i]->run.launch]; launch > 0)
            row[arms.size() + launch - 1] = 1;
        row[order] = runs[i]->order;
        logs.push_back(std::log(runs[i]->values[metric]));
    }
    const auto fit = runs.empty() ? std::nullopt : leastSquares(design, order + 1, logs);
    if (!fit)
        return std::nullopt;
    constexpr double kRounding = 1e-11; // of logarithms
    const double slope = fit->coefficients[order], error = fit->errors[order];
    const double p = error > kRounding ? studentTwoSided(slope / error, fit->degrees) : std::abs(slope) <= kRounding ? 1 : 0;
    return OrderTrend{condition, load, metric, std::expm1(slope), p};
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
