// A bar chart for publications: one horizontal bar per arm with its 95 % confidence interval and every sample, on an axis that
// begins at zero and names its unit. Written as SVG for a column of 88 mm with text of 7 pt, readable in black and white.
#pragma once

#include "core/experiment/results.h"

#include <string>
#include <vector>

namespace skyseal::experiment {

struct Bar
{
    std::string label;
    bool insecure = false; ///< drawn hatched and labelled
    std::string missing;   ///< text in place of the bar if the mean is not finite: "not measured"
    crypto::SuiteId suite{};
    double mean = 0, low = 0, high = 0; ///< low and high NaN with one sample
    std::vector<double> samples;
    std::vector<bool> outlier; ///< one for each sample
    std::string text = {};     ///< beside the bar; empty: the mean with half of its interval
};

struct BarChart
{
    std::string title;
    std::string subtitle; ///< link and load
    std::string legend;   ///< number of runs, and the meaning of the drawing
    std::string unit;     ///< "ns"; empty for plain numbers
    std::string axis;     ///< "CPU time per frame, ns"
    std::vector<Bar> bars;
};

/// The chart of one metric under one condition and load. Large values are scaled (B to MB, ns to µs), shares are in per cent.
BarChart chartOf(const Results &results, std::size_t condition, std::size_t load, Metric metric);

/// A complete SVG document, see chart_parts.h.
std::string svg(const BarChart &chart);

/// Distance of the ticks of an axis up to `highest`: 1, 2 or 5 times a power of ten, so that there are four to eight.
double axisStep(double highest);

/// Escapes text for XML and HTML.
std::string escaped(std::string_view text);

} // namespace skyseal::experiment
