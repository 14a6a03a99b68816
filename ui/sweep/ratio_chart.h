// The ratios of a sweep as bars: one for each arm, with its 95 % interval, beside the reference, which is 1.
#pragma once

#include "core/experiment/bar_chart.h"

namespace skyseal::ui {

/// Of one metric under one condition and load. The reference and arms without a ratio have no interval, the latter no bar.
experiment::BarChart ratioChart(const experiment::Results &results, std::size_t condition, std::size_t load,
                                experiment::Metric metric);

} // namespace skyseal::ui
