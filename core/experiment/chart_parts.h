// Parts that the charts of a report share. They are drawn for a column of a publication: 88 mm wide, with text of 7 pt or more,
// as SVG of rect, line, circle and text only, which app/figures draws as well. Pure functions.
#pragma once

#include <string>
#include <vector>

namespace skyseal::experiment {

/// Pixels of 1/96 inch: 333 are 88 mm, and 9.4 are 7 pt.
inline constexpr int kChartWidth = 333, kChartLine = 13;
inline constexpr double kChartText = 9.4, kChartTitle = 10.5;

/// `anchor`: start, middle or end; `more`: further attributes.
void putText(std::string &out, double x, double y, const char *anchor, const std::string &text, const char *more = "");
void putLine(std::string &out, double x1, double y1, double x2, double y2, const char *colour, double width);

/// Lines that fit the width of a chart.
std::vector<std::string> wrappedText(const std::string &text);

/// The begin of a document of this height in white, with a title and the lines of text below it.
std::string chartHead(double height, const std::string &title, const std::vector<std::string> &lines);
/// Where the drawing below such a head begins.
double chartTop(const std::vector<std::string> &lines);

} // namespace skyseal::experiment
