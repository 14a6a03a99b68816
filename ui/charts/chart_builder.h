// From samples to what a chart plots: runs of one colour for as long as one suite was in use, a mark where it changed.
#pragma once

#include "ui/charts/chart.h"
#include "ui/charts/sample_history.h"

#include <functional>

namespace skyseal::ui {

using SampleValue = std::function<double(const engine::MetricsSample &)>;

struct ChartLine
{
    SampleValue value;
    bool dashed = false;
};

/// The newest sample stands at x = 0. Values that are not finite break the line, and so does a gap of more than two seconds.
/// Runs are thinned to at most `mostPoints` in all, keeping highest and lowest of what each point stands for.
ChartContent buildChart(const SampleHistory &history, const std::vector<ChartLine> &lines, double span,
                        std::size_t mostPoints);

/// The greatest value of all runs; 0 when there is none.
double highestOf(const ChartContent &content);

/// The suites that occur in the last `span` seconds, in the order of their first use.
std::vector<crypto::SuiteId> suitesIn(const SampleHistory &history, double span);

} // namespace skyseal::ui
