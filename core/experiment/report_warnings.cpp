#include "core/experiment/report_warnings.h"

#include "core/experiment/analysis.h"
#include "core/experiment/disturbances.h"
#include "core/experiment/setting.h"
#include "core/experiment/sweep_text.h"

namespace skyseal::experiment {

/// Empty if no trend remains.
static Reason trendWarning(const Results &results)
{
    Reason list;
    for (const OrderTrend &trend : orderTrends(results)) {
        if (!trend.remains())
            continue;
        const Reason part = sentence("Reason", "%1, %2 load, %3 % for each run")(
            info(trend.metric).title, nameReason(results.plan.loads[trend.load]), readable(100 * trend.perRun));
        list = list.empty() ? part : sentence("Reason", "%1; %2")(list, part);
    }
    if (list.empty())
        return {};
    return sentence("Reason",
                    "values change with the order of the runs within a launch, so that the warm-up was too short or the "
                    "machine drifts: %1")(list);
}

std::vector<Reason> reportWarnings(const Results &results)
{
    std::vector<Reason> out = warningsOf(results.setting);
    out.insert(out.end(), results.unknown.begin(), results.unknown.end());
    if (const Reason ended = endedEarly(results); !ended.empty())
        out.push_back(sentence("Reason", "This sweep is incomplete: it %1")(ended));
    for (const Reason &reason : {failedRuns(results), invalidRuns(results), trendWarning(results), disturbedRuns(results)}) {
        if (!reason.empty())
            out.push_back(reason);
    }
    return out;
}

} // namespace skyseal::experiment
