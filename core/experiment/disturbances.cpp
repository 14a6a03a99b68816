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
    double most = 0;                 ///< not a disturbance yet
    Sentence text;                   ///< %1: the value
    std::optional<Metric> wakeUps{}; ///< as many more as half of these are none either
};

// Loose enough for an idle machine: its background services and the timer of its kernel stay below. A program that sends wakes
// the receiver, which the scheduler may prefer to the sender: on an idle machine of two cores the agent gave up its core at up
// to a third of its wake-ups.
constexpr Threshold kThresholds[] = {
    {Metric::OtherCpu, 10, sentence("Reason", "other programs used %1 % of a core")},
    {Metric::Steal, 1, sentence("Reason", "the hypervisor took %1 % of a core")},
    {Metric::Preemptions, 50, sentence("Reason", "the station's I/O thread had to give up its core %1 times a second"),
     Metric::WakeUps},
    {Metric::AgentPreemptions, 50, sentence("Reason", "the agent had to give up its core %1 times a second"),
     Metric::AgentWakeUps},
    {Metric::FrequencyChange, 5, sentence("Reason", "the frequency of the cores differed by %1 % between begin and end")},
    {Metric::LoadBegin, 1.5, sentence("Reason", "the load average at the start was %1 per core")},
    {Metric::LoadEnd, 1.5, sentence("Reason", "the load average at the end was %1 per core")},
    {Metric::IdlePowerChange, 5, sentence("Reason", "the power of the idle machine differed by %1 % before and after")},
    {Metric::Throttlings, 0, sentence("Reason", "the processor was throttled %1 times")},
    {Metric::MeterCpu, 2, sentence("Reason", "the measurement itself took %1 % of the CPU time of the station's I/O thread")},
    {Metric::SimulatorCpu, 95, sentence("Reason", "the simulator (which makes the load) used %1 % of a core")},
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
            out.push_back(threshold.text(readable(sample.values[threshold.metric])).text());
    }
    return out;
}

Reason meterText(const Results &results)
{
    Reason list;
    for (std::size_t load = 0; load < results.plan.loads.size(); ++load) {
        double highest = 0;
        for (const Sample &sample : results.samples) {
            const double share = sample.values[Metric::MeterCpu];
            highest = sample.run.load == load && share > highest ? share : highest;
        }
        if (highest <= 0)
            continue;
        const Reason part = sentence("Reason", "up to %1 % under the %2 load")(readable(highest),
                                                                               nameReason(results.plan.loads[load]));
        list = list.empty() ? part : sentence("Reason", "%1, %2")(list, part);
    }
    if (list.empty())
        return {};
    return sentence(
        "Reason",
        "A run is the difference of two readings, taken by the thread that is measured. Of its CPU time, taking and "
        "publishing readings was %1 (meter_cpu)")(list);
}

Reason disturbedRuns(const Results &results)
{
    std::size_t disturbed = 0;
    for (const Sample &sample : results.samples)
        disturbed += !disturbances(sample).empty();
    if (disturbed == 0)
        return {};
    Reason list;
    for (const Threshold &threshold : kThresholds) {
        double highest = 0;
        std::size_t runs = 0;
        for (const Sample &sample : results.samples) {
            if (!isBeyond(sample, threshold))
                continue;
            highest = std::max(highest, sample.values[threshold.metric]);
            ++runs;
        }
        if (runs == 0)
            continue;
        const Reason what = threshold.text(sentence("Reason", "up to %1")(readable(highest)));
        const Reason part = runs == 1 ? sentence("Reason", "%1 (1 run)")(what) : sentence("Reason", "%1 (%2 runs)")(what, runs);
        list = list.empty() ? part : sentence("Reason", "%1; %2")(list, part);
    }
    return sentence("Reason", "%1 of %2 runs were disturbed, so that their figures are noisier and may be wrong: %3")(
        disturbed, results.samples.size(), list);
}

} // namespace skyseal::experiment
