#include "core/experiment/report_warnings.h"

#include "core/experiment/analysis.h"
#include "core/experiment/disturbances.h"
#include "core/experiment/setting.h"
#include "core/experiment/sweep_text.h"

namespace skyseal::experiment {

/// Empty if no trend remains.
static std::string trendWarning(const Results &results)
{
    std::string list;
    for (const OrderTrend &trend : orderTrends(results)) {
        if (trend.remains())
            list += (list.empty() ? "" : "; ") + std::string(info(trend.metric).title) + ", "
                + std::string(name(results.plan.loads[trend.load])) + " load, " + readable(100 * trend.perRun)
                + " % for each run";
    }
    return list.empty() ? list
                        : "values change with the order of the runs within a launch, so that the warm-up was too short or the "
                          "machine drifts: "
            + list;
}

std::vector<Reason> reportWarnings(const Results &results)
{
    std::vector<Reason> out;
    for (const std::vector<std::string> &texts : {warningsOf(results.setting), results.unknown})
        out.insert(out.end(), texts.begin(), texts.end());
    if (const Reason ended = endedEarly(results); !ended.empty())
        out.push_back(sentence("Reason", "This sweep is incomplete: it %1")(ended));
    for (const Reason &reason :
         {failedRuns(results), invalidRuns(results), Reason(trendWarning(results)), disturbedRuns(results)}) {
        if (!reason.empty())
            out.push_back(reason);
    }
    return out;
}

} // namespace skyseal::experiment
