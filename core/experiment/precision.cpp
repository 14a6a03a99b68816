#include "core/experiment/precision.h"

#include "core/experiment/analysis.h"
#include "core/experiment/contrast.h"
#include "core/experiment/statistics.h"

#include <algorithm>
#include <cmath>

namespace skyseal::experiment {

namespace {

constexpr unsigned kMostLaunches = 100000;

/// By the error of so many launches, which falls with the root of their number, and the degrees of freedom that grow with it.
unsigned launchesNeeded(const Contrast &contrast, unsigned launches, double goal)
{
    const double freeOfEach = contrast.degrees / (launches - 1);
    const auto reaches = [&](unsigned count) {
        const double error = contrast.error * std::sqrt(static_cast<double>(launches) / count);
        return studentQuantile(0.975, freeOfEach * (count - 1)) * error <= std::log1p(goal);
    };
    unsigned least = 2, most = kMostLaunches;
    while (least < most) {
        const unsigned middle = least + (most - least) / 2;
        if (reaches(middle))
            most = middle;
        else
            least = middle + 1;
    }
    return least;
}

/// Those that each condition and load compares with the reference.
std::size_t armsToCompare(const Plan &plan)
{
    std::size_t out = 0;
    for (std::size_t arm = 0; arm < plan.arms.size(); ++arm)
        out += arm != referenceArm(plan) && !plan.arms[arm].again && exists(plan.arms[arm]);
    return out;
}

} // namespace

unsigned launchesIn(const Results &results)
{
    unsigned out = 0;
    for (const Sample &sample : results.samples)
        out = std::max(out, sample.run.launch + 1);
    return out;
}

std::optional<Precision> precisionOf(const Results &results, double goal)
{
    const unsigned launches = launchesIn(results);
    if (launches < 2)
        return std::nullopt;
    std::optional<Precision> out;
    for (std::size_t condition = 0; condition < results.plan.conditions.size(); ++condition) {
        for (std::size_t load = 0; load < results.plan.loads.size(); ++load) {
            for (const Metric metric : {Metric::CpuPerFrame, Metric::AgentCpuPerFrame}) {
                std::size_t missing = wasMeasured(results, metric) ? armsToCompare(results.plan) : 0;
                for (const Contrast &one : plannedContrasts(results, condition, load, metric)) {
                    if (one.first != referenceArm(results.plan))
                        continue;
                    if (!std::isfinite(one.halfWidth()))
                        return std::nullopt;
                    --missing;
                    if (!out)
                        out.emplace();
                    out->halfWidth = std::max(out->halfWidth, std::expm1(one.halfWidth()));
                    out->launchesNeeded = std::max(out->launchesNeeded, launchesNeeded(one, launches, goal));
                }
                if (missing > 0) // Too few of an arm's runs here are valid, and nothing is known about its ratio.
                    return std::nullopt;
            }
        }
    }
    return out;
}

} // namespace skyseal::experiment
