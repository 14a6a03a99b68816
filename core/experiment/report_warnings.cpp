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

std::vector<std::string> reportWarnings(const Results &results)
{
    std::vector<std::string> out = warningsOf(results.setting);
    out.insert(out.end(), results.unknown.begin(), results.unknown.end());
    const std::string ended = endedEarly(results);
    for (const std::string &text : {ended.empty() ? ended : "This sweep is incomplete: it " + ended, failedRuns(results),
                                    invalidRuns(results), trendWarning(results), disturbedRuns(results)}) {
        if (!text.empty())
            out.push_back(text);
    }
    return out;
}

} // namespace skyseal::experiment
