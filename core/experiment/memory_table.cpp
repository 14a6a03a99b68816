#include "core/experiment/memory_table.h"

#include "core/experiment/html_parts.h"

#include <algorithm>
#include <cmath>

namespace skyseal::experiment {

namespace {

constexpr double kMegabyte = 1e6, kKilobyte = 1e3;

/// "24.4 to 24.7", of all valid runs of the arm, or "24.4"; empty if it was not measured.
std::string rangeOf(const Results &results, std::size_t arm, Metric metric, double unit)
{
    std::vector<double> all;
    for (const Cell &cell : cells(results.plan)) {
        if (cell.arm != arm)
            continue;
        const std::vector<double> values = valuesOf(results, cell, metric);
        std::ranges::copy_if(values, std::back_inserter(all), [](double value) { return std::isfinite(value); });
    }
    if (all.empty())
        return {};
    const auto [low, high] = std::ranges::minmax(all);
    const std::string from = readable(low / unit), to = readable(high / unit);
    return from == to ? from : from + " to " + to;
}

} // namespace

std::string memoryTable(const Results &results)
{
    std::string rows;
    for (std::size_t arm = 0; arm < results.plan.arms.size(); ++arm) {
        const SweepArm &one = results.plan.arms[arm];
        if (one.again || !exists(one))
            continue;
        const auto context = results.contextBytes.find(one.suite);
        std::vector<std::string> cells{rangeOf(results, arm, Metric::Memory, kMegabyte),
                                       rangeOf(results, arm, Metric::AgentMemory, kMegabyte),
                                       rangeOf(results, arm, Metric::SessionMemory, kKilobyte),
                                       context == results.contextBytes.end() ? "" : readable(context->second / kKilobyte)};
        if (std::ranges::all_of(cells, &std::string::empty))
            continue;
        std::ranges::replace(cells, std::string(), std::string("–"));
        cells.insert(cells.begin(), {armText(one), std::string(framingName(one))});
        rows += row(cells);
    }
    if (rows.empty())
        return rows;
    return "<p>The resident memory is that of one process through all suites, from its smallest to its largest value at the "
           "end of a run: its runs are not independent, and suites are not compared by it. The memory of a suite itself is the "
           "heap of a session and of one keyed cipher, each measured once in a process of its own.</p>\n"
           "<table border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n"
        + headOfTable({{"suite", "framing", "station, MB", "agent, MB", "a session, kB", "a keyed cipher, kB"}}) + rows
        + "</table>\n";
}

} // namespace skyseal::experiment
