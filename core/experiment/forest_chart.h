// Ratios with their intervals, one line each, on a logarithmic axis around 1: what an arm costs relative to plain MAVLink, or
// what several machines found. Written as SVG for a column of 88 mm with text of 7 pt, readable in black and white.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace skyseal::experiment {

struct ForestRow
{
    std::string label;
    double value = std::numeric_limits<double>::quiet_NaN(), low = value, high = value; ///< NaN: `missing` is shown
    std::string missing = "not measured";
    bool hollow = false; ///< drawn as a ring
    /// Where another machine is expected to lie; NaN: none.
    double expectedLow = std::numeric_limits<double>::quiet_NaN(), expectedHigh = expectedLow;
    bool isSummary = false; ///< below a line
};

struct ForestChart
{
    std::string title;
    std::string subtitle; ///< link and load
    std::string legend;
    std::string axis;  ///< "ratio to plain MAVLink"
    double margin = 0; ///< shaded around 1
    std::vector<ForestRow> rows;
};

/// A complete SVG document, see chart_parts.h.
std::string svg(const ForestChart &chart);

/// Ticks of a logarithmic axis that holds `low` to `high`, both above 0: three to seven.
std::vector<double> ratioTicks(double low, double high);

} // namespace skyseal::experiment
