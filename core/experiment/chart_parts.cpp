#include "core/experiment/chart_parts.h"

#include "core/experiment/append_format.h"
#include "core/experiment/bar_chart.h"

#include <algorithm>
#include <cmath>

namespace skyseal::experiment {

namespace {

constexpr std::size_t kCharacters = 58; ///< of a line of text, at this size

/// Whole characters, of which UTF-8 may take several bytes.
std::size_t lengthOf(const std::string &text, std::size_t begin, std::size_t end)
{
    return static_cast<std::size_t>(std::count_if(text.begin() + static_cast<std::ptrdiff_t>(begin),
                                                  text.begin() + static_cast<std::ptrdiff_t>(end),
                                                  [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

} // namespace

void putText(std::string &out, double x, double y, const char *anchor, const std::string &text, const char *more)
{
    put(out, "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"#111111\"{}>", x, y, kChartText, anchor, more);
    out += escaped(text) + "</text>\n";
}

void putLine(std::string &out, double x1, double y1, double x2, double y2, const char *colour, double width)
{
    put(out, "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"{}\" stroke-width=\"{}\"/>\n", x1, y1, x2, y2, colour,
        width);
}

std::vector<std::string> wrappedText(const std::string &text)
{
    std::vector<std::string> out;
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t end = text.size();
        while (lengthOf(text, begin, end) > kCharacters) {
            const std::size_t space = text.rfind(' ', end - 1);
            if (space == std::string::npos || space <= begin)
                break; // a word that is longer than the line
            end = space;
        }
        out.push_back(text.substr(begin, end - begin));
        begin = text.find_first_not_of(' ', end);
    }
    return out;
}

double chartTop(const std::vector<std::string> &lines)
{
    return 24 + kChartLine * static_cast<double>(lines.size());
}

std::string chartHead(double height, const std::string &title, const std::vector<std::string> &lines)
{
    const long pixels = std::lround(height);
    std::string out;
    put(out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\" "
        "font-family=\"DejaVu Sans, Verdana, sans-serif\">\n",
        kChartWidth, pixels, kChartWidth, pixels);
    put(out, "<rect x=\"0\" y=\"0\" width=\"{}\" height=\"{}\" fill=\"#ffffff\"/>\n", kChartWidth, pixels);
    put(out, "<text x=\"3\" y=\"13\" font-size=\"{}\" font-weight=\"bold\" fill=\"#111111\">", kChartTitle);
    out += escaped(title) + "</text>\n";
    double y = 13;
    for (const std::string &line : lines)
        putText(out, 3, y += kChartLine, "start", line);
    return out;
}

} // namespace skyseal::experiment
