// The figures of a report: ratios to plain MAVLink, and means with every single run.
#pragma once

#include "core/experiment/results.h"

#include <string>
#include <vector>

namespace skyseal::experiment {

struct ReportFigure
{
    std::string name; ///< of its files, without extension: "packets-natural"
    std::string svg;
};

/// The ratios to plain MAVLink by each metric with kRatio; then one figure for each metric with kFigure that was measured,
/// condition and load; those of the paper (packets, CPU, memory) first.
std::vector<ReportFigure> figuresOf(const Results &results);

} // namespace skyseal::experiment
