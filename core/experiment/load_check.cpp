#include "core/experiment/load_check.h"

#include <array>
#include <cmath>

namespace skyseal::experiment {

namespace {

Reason paceProblem(Load load, const Values &values)
{
    const double time = values[Metric::Packets] / values[Metric::FrameRate];
    const double missed = 100 * values[Metric::MissedSends] / (load.perSecond * time);
    if (missed <= kMayMiss)
        return {};
    if (std::isnan(missed))
        return sentence("Reason", "the generator of the load did not count its sends");
    return sentence("Reason", "the generator missed %1 % of its sends")(readable(missed));
}

} // namespace

Reason loadProblem(Load load, const Values &values)
{
    if (load.isPaced())
        return paceProblem(load, values);
    constexpr std::array kParts{std::pair(Metric::LineLoad, sentence("Reason", "%1 % of the line's rate")),
                                std::pair(Metric::Cpu, sentence("Reason", "%1 % of the station's core")),
                                std::pair(Metric::AgentCpu, sentence("Reason", "%1 % of the agent's core"))};
    if (load != Load::Saturated)
        return {};
    Reason used;
    for (const auto &[metric, what] : kParts) {
        if (values[metric] >= kUsedUp)
            return {};
        if (std::isnan(values[metric]))
            continue;
        const Reason part = what(readable(values[metric]));
        used = used.empty() ? part : sentence("Reason", "%1; %2")(used, part);
    }
    return sentence("Reason", "not saturated: nothing reached %1 % (%2)")(readable(kUsedUp), used);
}

} // namespace skyseal::experiment
