#include "core/experiment/disturbances.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace skyseal::experiment {

namespace {

struct Threshold
{
    Metric metric{};
    double most = 0; ///< not a disturbance yet
    const char *before, *after;
    std::optional<Metric> wakeUps{}; ///< as many more as half of these are none either
};

// Loose enough for an idle machine: its background services and the timer of its kernel stay below. A program that sends wakes
// the receiver, which the scheduler may prefer to the sender: on an idle machine of two cores the agent gave up its core at up
// to a third of its wake-ups.
constexpr Threshold kThresholds[] = {
    {Metric::OtherCpu, 10, "other programs used ", " % of a core"},
    {Metric::Steal, 1, "the hypervisor took ", " % of a core"},
    {Metric::Preemptions, 50, "the station's I/O thread had to give up its core ", " times a second", Metric::WakeUps},
    {Metric::AgentPreemptions, 50, "the agent had to give up its core ", " times a second", Metric::AgentWakeUps},
    {Metric::FrequencyChange, 5, "the frequency of the cores differed by ", " % between begin and end"},
    {Metric::LoadBegin, 1.5, "the load average at the start was ", " per core"},
    {Metric::LoadEnd, 1.5, "the load average at the end was ", " per core"},
    {Metric::IdlePowerChange, 5, "the power of the idle machine differed by ", " % before and after"},
    {Metric::Throttlings, 0, "the processor was throttled ", " times"},
    {Metric::MeterCpu, 2, "the measurement itself took ", " % of the CPU time of the station's I/O thread"},
    {Metric::SimulatorCpu, 95, "the simulator (which makes the load) used ", " % of a core"},
};

bool isBeyond(const Sample &sample, const Threshold &threshold)
{
    const double wakeUps = threshold.wakeUps ? sample.values[*threshold.wakeUps] : 0;
    const double most = threshold.most + (std::isfinite(wakeUps) ? wakeUps / 2 : 0);
    return sample.problem.empty() && sample.values[threshold.metric] > most;
}

} // namespace

std::vector<std::string> disturbances(const Sample &sample)
{
    std::vector<std::string> out;
    for (const Threshold &threshold : kThresholds) {
        if (isBeyond(sample, threshold))
            out.push_back(threshold.before + readable(sample.values[threshold.metric]) + threshold.after);
    }
    return out;
}

std::string meterText(const Results &results)
{
    std::string out;
    for (std::size_t load = 0; load < results.plan.loads.size(); ++load) {
        double highest = 0;
        for (const Sample &sample : results.samples) {
            const double share = sample.values[Metric::MeterCpu];
            highest = sample.run.load == load && share > highest ? share : highest;
        }
        if (highest > 0)
            out += (out.empty() ? "up to " : ", up to ") + readable(highest) + " % under the "
                + std::string(name(results.plan.loads[load])) + " load";
    }
    return out.empty()
        ? out
        : "A run is the difference of two readings, taken by the thread that is measured. Of its CPU time, taking "
          "and publishing readings was "
            + out + " (meter_cpu)";
}

std::string disturbedRuns(const Results &results)
{
    std::string list;
    std::size_t disturbed = 0;
    for (const Sample &sample : results.samples)
        disturbed += !disturbances(sample).empty();
    if (disturbed == 0)
        return {};
    for (const Threshold &threshold : kThresholds) {
        double highest = 0;
        std::size_t runs = 0;
        for (const Sample &sample : results.samples) {
            if (!isBeyond(sample, threshold))
                continue;
            highest = std::max(highest, sample.values[threshold.metric]);
            ++runs;
        }
        if (runs > 0)
            list += (list.empty() ? "" : "; ") + std::string(threshold.before) + "up to " + readable(highest) + threshold.after
                + " (" + std::to_string(runs) + (runs == 1 ? " run)" : " runs)");
    }
    return std::to_string(disturbed) + " of " + std::to_string(results.samples.size())
        + " runs were disturbed, so that their figures are noisier and may be wrong: " + list;
}

} // namespace skyseal::experiment
