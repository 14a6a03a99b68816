#include "core/experiment/results.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace skyseal::experiment {

namespace {

std::vector<const Sample *> samplesOf(const Results &results, const Cell &cell)
{
    std::vector<const Sample *> out;
    for (const Sample &sample : results.samples) {
        if (Cell{sample.run.condition, sample.run.load, sample.run.arm} == cell)
            out.push_back(&sample);
    }
    std::stable_sort(out.begin(), out.end(), [](const Sample *a, const Sample *b) {
        return std::pair(a->run.launch, a->run.repeat) < std::pair(b->run.launch, b->run.repeat);
    });
    return out;
}

} // namespace

std::string settingOf(const Setting &setting, std::string_view key)
{
    const auto found = std::ranges::find(setting, key, &Setting::value_type::first);
    return found == setting.end() ? std::string() : found->second;
}

std::string settingOf(const Results &results, std::string_view key)
{
    return settingOf(results.setting, key);
}

std::vector<Cell> cells(const Plan &plan)
{
    std::vector<Cell> out;
    for (std::size_t condition = 0; condition < plan.conditions.size(); ++condition) {
        for (std::size_t load = 0; load < plan.loads.size(); ++load) {
            for (std::size_t arm = 0; arm < plan.arms.size(); ++arm)
                out.push_back({condition, load, arm});
        }
    }
    return out;
}

std::vector<double> valuesOf(const Results &results, const Cell &cell, Metric metric)
{
    std::vector<double> out;
    for (const Sample *sample : samplesOf(results, cell))
        out.push_back(sample->isValid() ? sample->values[metric] : std::numeric_limits<double>::quiet_NaN());
    return out;
}

std::vector<unsigned> ordersOf(const Results &results, const Cell &cell)
{
    std::vector<unsigned> out;
    for (const Sample *sample : samplesOf(results, cell))
        out.push_back(sample->order);
    return out;
}

} // namespace skyseal::experiment
