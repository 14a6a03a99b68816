// From samples to what a chart plots: over time in runs of one colour for as long as one suite was in use, with a mark where
// something happened; or suite over suite, by the time that each was in use; and bars to compare them by.
#pragma once

#include "ui/charts/chart_range.h"
#include "ui/charts/sample_history.h"

namespace skyseal::ui {

/// Values that are not finite break the line, and so does a gap of more than two seconds. Runs are thinned to about
/// `mostPoints` in all, keeping highest and lowest of what each point stands for.
ChartContent buildTimeLine(const SampleHistory &history, const Quantity &quantity, const ChartRange &range,
                           std::size_t mostPoints);

/// Every suite used so far over the same axis: the last range.span() seconds of its use.
ChartContent buildOverlay(const SampleHistory &history, const Quantity &quantity, const ChartRange &range,
                          std::size_t mostPoints);

/// One bar for each suite used so far; `firstTally` is the place of the quantity's first line among the tallies.
std::vector<ChartBar> buildBars(const SampleHistory &history, const Quantity &quantity, std::size_t firstTally);

/// Switches, lost and found links, new keys, and records that were refused, within the range.
std::vector<ChartMark> buildMarks(const SampleHistory &history, const ChartRange &range, const QColor &alarm,
                                  const QColor &dim);

/// The greatest value of all runs and bars; 0 when there is none.
double highestOf(const ChartContent &content);

/// The suites used so far, in the order of their first use.
std::vector<crypto::SuiteId> suitesUsed(const SampleHistory &history);

} // namespace skyseal::ui
