// A figure as a publication prints it: one horizontal bar a suite with its 95 % confidence interval and every single sample,
// on an axis that begins at zero and names its unit. Written as SVG, readable in black and white.
#pragma once

#include "core/experiment/results.h"

#include <string>
#include <vector>

namespace skyseal::experiment {

struct Bar
{
    std::string label;
    bool insecure = false; ///< drawn hatched and said so
    std::string missing;   ///< what stands there without a finite mean: "not measured"
    crypto::SuiteId suite{};
    double mean = 0, low = 0, high = 0; ///< low and high NaN with one sample
    std::vector<double> samples;
    std::vector<bool> outlier; ///< one for each sample
};

struct BarChart
{
    std::string title;
    std::string subtitle; ///< link and load
    std::string legend;   ///< how often it was measured, and what is drawn
    std::string axis;     ///< "CPU time per frame, ns"
    std::vector<Bar> bars;
};

/// The chart of one metric in one place of the design; large units are scaled (B to MB, ns to µs), shares are per cent.
BarChart chartOf(const Results &results, std::size_t condition, std::size_t load, Metric metric);

/// A whole SVG document, 800 wide, of rect, line, circle and text alone, so that it is easily drawn elsewhere.
std::string svg(const BarChart &chart);

/// Steps of an axis that ends at or above `highest`: 1, 2 or 5 times a power of ten, four to eight of them.
double axisStep(double highest);

/// Text for XML and HTML.
std::string escaped(std::string_view text);

} // namespace skyseal::experiment
