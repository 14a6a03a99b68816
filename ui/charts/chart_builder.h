// Makes the content of charts from samples: over time, with one run per suite and marks for events; suite over suite, by the
// time in use of each suite; and bars that compare the suites.
#pragma once

#include "ui/charts/chart_range.h"
#include "ui/charts/sample_history.h"

namespace skyseal::ui {

/// Values that are not finite and gaps of more than two seconds break the line. The runs are thinned to about `mostPoints`
/// points in all, which keep the highest and lowest values.
ChartContent buildTimeLine(const SampleHistory &history, const Quantity &quantity, const ChartRange &range,
                           std::size_t mostPoints);

/// All suites used so far on one axis: the last range.span() seconds of the time in use of each.
ChartContent buildOverlay(const SampleHistory &history, const Quantity &quantity, const ChartRange &range,
                          std::size_t mostPoints);

/// One bar for each suite used so far; `firstTally` is the index of the quantity's first line among the tallies.
std::vector<ChartBar> buildBars(const SampleHistory &history, const Quantity &quantity, std::size_t firstTally);

/// Switches, new keys, lost and recovered links, and refused records within the range.
std::vector<ChartMark> buildMarks(const SampleHistory &history, const ChartRange &range, const QColor &alarm,
                                  const QColor &dim);

/// The greatest value of all runs and bars; 0 when there is none.
double highestOf(const ChartContent &content);

/// The suites used so far, in the order of their first use.
std::vector<crypto::SuiteId> suitesUsed(const SampleHistory &history);

} // namespace skyseal::ui
