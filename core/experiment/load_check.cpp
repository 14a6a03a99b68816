#include "core/experiment/load_check.h"

#include <array>
#include <cmath>

namespace skyseal::experiment {

std::string loadProblem(Load load, const Values &values)
{
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
