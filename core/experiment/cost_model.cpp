#include "core/experiment/cost_model.h"

#include "core/experiment/bar_chart.h"
#include "core/experiment/html_parts.h"
#include "core/experiment/random_intercept.h"
#include "core/experiment/statistics.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace skyseal::experiment {

namespace {

constexpr double kNanosecondsOfPercent = 1e7; ///< of one core, in a second

struct EndMetrics
{
    LinkEnd end;
    Metric cpu, wakeUps;
};
constexpr EndMetrics kEnds[] = {{LinkEnd::Station, Metric::Cpu, Metric::WakeUps},
                                {LinkEnd::Agent, Metric::AgentCpu, Metric::AgentWakeUps}};

std::optional<CostModel> modelOf(const Results &results, std::size_t condition, std::size_t arm, const EndMetrics &end)
{
    CostModel out;
    out.condition = condition;
    out.arm = arm;
    out.end = end.end;
    std::vector<double> design;
    std::vector<std::size_t> launches;
    std::set<std::size_t> loads;
    for (const Sample &sample : results.samples) {
        const bool isOne = sample.run.condition == condition && sample.run.arm == arm && sample.isValid()
            && results.plan.loads[sample.run.load].isPaced();
        const double frames = sample.values[Metric::FrameRate], wakeUps = sample.values[end.wakeUps],
                     cost = sample.values[end.cpu] * kNanosecondsOfPercent;
        if (!isOne || !std::isfinite(frames) || !std::isfinite(wakeUps) || !std::isfinite(cost))
            continue;
        loads.insert(sample.run.load);
        out.runs.push_back(&sample);
        out.values.push_back(cost);
        launches.push_back(sample.run.launch);
        design.insert(design.end(), {1, frames, wakeUps});
    }
    if (loads.size() < 2)
        return std::nullopt;
    if (auto fit = randomIntercept(design, CostModel::kTerms, out.values, launches)) {
        out.fit = std::move(fit->fit);
        out.launchDeviation = fit->groupDeviation;
        out.launches = static_cast<unsigned>(fit->groups);
        return out;
    }
    auto fit = leastSquares(design, CostModel::kTerms, out.values);
    if (!fit)
        return std::nullopt;
    out.fit = std::move(*fit);
    return out;
}

/// "612.3 ± 20.4"
std::string termText(const CostModel &model, std::size_t term, double scale = 1)
{
    const double value = scale * model.fit.coefficients[term], half = scale * model.halfWidth(term);
    return readable(value, value - half, value + half);
}

/// The mean residual of the runs of this load and the greatest one, per cent of the CPU time of the run.
std::string residualText(const CostModel &model, std::size_t load)
{
    double sum = 0, greatest = 0;
    int count = 0;
    for (std::size_t i = 0; i < model.runs.size(); ++i) {
        if (model.runs[i]->run.load != load)
            continue;
        const double share = 100 * model.fit.residuals[i] / model.values[i];
        sum += share;
        greatest = std::max(greatest, std::abs(share));
        ++count;
    }
    return count == 0 ? "–" : readable(sum / count) + " (≤ " + readable(greatest) + ")";
}

std::string missedText(const Results &results)
{
    double missed = 0;
    for (const Sample &sample : results.samples) {
        if (const double one = sample.values[Metric::MissedSends]; sample.isValid() && one > 0)
            missed += one;
    }
    return "The generator missed " + readable(missed) + " of its sends in the valid runs.";
}

} // namespace

double CostModel::halfWidth(std::size_t term) const
{
    return term == kConstant && launches > 1 ? studentQuantile(0.975, launches - 1) * fit.errors[term] : fit.halfWidth(term);
}

std::string_view name(LinkEnd end)
{
    return end == LinkEnd::Station ? "station" : "agent";
}

std::vector<CostModel> costModels(const Results &results)
{
    std::vector<CostModel> out;
    for (std::size_t condition = 0; condition < results.plan.conditions.size(); ++condition) {
        for (std::size_t arm = 0; arm < results.plan.arms.size(); ++arm) {
            for (const EndMetrics &end : kEnds) {
                if (results.plan.arms[arm].again)
                    continue;
                if (auto model = modelOf(results, condition, arm, end))
                    out.push_back(std::move(*model));
            }
        }
    }
    return out;
}

std::string costModelHtml(const Results &results)
{
    const Plan &plan = results.plan;
    std::vector<std::string> head{"suite",
                                  "framing",
                                  "end",
                                  "link",
                                  "runs",
                                  "a (µs per second)",
                                  "b (ns per frame)",
                                  "c (ns per wake-up)",
                                  "standard deviation between launches (µs per second)",
                                  "of the residuals (µs per second)"};
    std::vector<std::size_t> paced;
    for (std::size_t load = 0; load < plan.loads.size(); ++load) {
        if (!plan.loads[load].isPaced())
            continue;
        paced.push_back(load);
        head.push_back("residuals at " + std::to_string(plan.loads[load].perSecond) + " frames/s (%)");
    }
    if (paced.empty())
        return {};
    const std::string title = "<h2>Cost against rate</h2>\n";
    const std::vector<CostModel> models = costModels(results);
    if (models.empty())
        return title
            + "<p>Not fitted: a + b × frames + c × wake-ups needs four valid runs of a suite, at two rates or more "
              "(--pps).</p>\n";
    std::string rows;
    for (const CostModel &model : models) {
        std::vector<std::string> cells{armText(plan.arms[model.arm]),          std::string(framingName(plan.arms[model.arm])),
                                       std::string(name(model.end)),           escaped(plan.conditions[model.condition].name),
                                       std::to_string(model.runs.size()),      termText(model, CostModel::kConstant, 1e-3),
                                       termText(model, CostModel::kPerFrame),  termText(model, CostModel::kPerWakeUp),
                                       readable(model.launchDeviation / 1000), readable(model.fit.deviation / 1000)};
        for (const std::size_t load : paced)
            cells.push_back(residualText(model, load));
        rows += row(cells);
    }
    return title
        + "<p>CPU time = a + b × frames + c × wake-ups, for each second, fitted to the runs of the paced loads by least "
          "squares with the launch as a random effect (REML), ± half of the 95 % interval (Student's t). Of a single launch "
          "the intervals hold for that one start of the programs. "
          "If frames and wake-ups grow together, b and c cannot be told apart well, "
          "and both intervals are wide. Residuals: their mean over the runs of a load and, in brackets, the greatest one, per "
          "cent of the measured CPU time; means of one sign at the lowest and highest rates and of the other in between show "
          "that the cost is not linear. "
        + missedText(results)
        + "</p>\n"
          "<div class=\"wide\"><table border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n"
        + headOfTable({head}) + rows + "</table></div>\n";
}

} // namespace skyseal::experiment
