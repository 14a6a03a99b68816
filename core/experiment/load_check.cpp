#include "core/experiment/load_check.h"

#include <array>
#include <cmath>

namespace skyseal::experiment {

namespace {

std::string paceProblem(Load load, const Values &values)
{
    const double time = values[Metric::Packets] / values[Metric::FrameRate];
    const double missed = 100 * values[Metric::MissedSends] / (load.perSecond * time);
    if (missed <= kMayMiss)
        return {};
    return std::isnan(missed) ? "the generator of the load did not count its sends"
                              : "the generator missed " + readable(missed) + " % of its sends";
}

} // namespace

std::string loadProblem(Load load, const Values &values)
{
    if (load.isPaced())
        return paceProblem(load, values);
    constexpr std::array kParts{std::pair(Metric::LineLoad, "of the line's rate"),
                                std::pair(Metric::Cpu, "of the station's core"),
                                std::pair(Metric::AgentCpu, "of the agent's core")};
    if (load != Load::Saturated)
        return {};
    std::string used;
    for (const auto &[metric, what] : kParts) {
        if (values[metric] >= kUsedUp)
            return {};
        if (!std::isnan(values[metric]))
            used += (used.empty() ? "" : "; ") + readable(values[metric]) + " % " + what;
    }
    return "not saturated: nothing reached " + readable(kUsedUp) + " % (" + used + ")";
}

} // namespace skyseal::experiment
