#include "core/experiment/forest_chart.h"

#include "core/base/number_text.h"
#include "core/experiment/append_format.h"
#include "core/experiment/chart_parts.h"
#include "core/experiment/metric.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace skyseal::experiment {

namespace {

constexpr int kLabels = 126, kFigures = 100, kForestRow = 17; ///< room at the left and at the right, height of a row

struct RatioAxis
{
    double low, high;
    double x(double value) const
    {
        const double share = std::log(value / low) / std::log(high / low);
        return kLabels + (kChartWidth - kLabels - kFigures) * std::clamp(share, 0.0, 1.0);
    }
};

/// Of everything that is drawn, and of 1.
RatioAxis axisOf(const ForestChart &chart)
{
    double low = 1 / (1 + chart.margin), high = 1 + chart.margin;
    for (const ForestRow &row : chart.rows) {
        for (const double value : {row.value, row.low, row.high, row.expectedLow, row.expectedHigh}) {
            if (std::isfinite(value) && value > 0) {
                low = std::min(low, value);
                high = std::max(high, value);
            }
        }
    }
    const double space = std::max(std::pow(high / low, 0.05), 1.005);
    return {low / space, high * space};
}

/// Numbers that would touch are omitted, but never that of 1.
void drawTicks(std::string &out, const RatioAxis &axis, double bottom)
{
    constexpr double kCharacter = 0.64 * kChartText, kGap = 5;
    const std::vector<double> ticks = ratioTicks(axis.low, axis.high);
    const auto isOne = [](double tick) { return std::abs(tick - 1) < 1e-9; };
    const auto one = std::ranges::find_if(ticks, isOne) - ticks.begin();
    bool isCrowded = false;
    for (std::size_t i = 1; i < ticks.size(); ++i) {
        const auto characters = static_cast<double>(readable(ticks[i - 1]).size() + readable(ticks[i]).size());
        isCrowded = isCrowded || axis.x(ticks[i]) - axis.x(ticks[i - 1]) < characters / 2 * kCharacter + kGap;
    }
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        const double x = axis.x(ticks[i]);
        putLine(out, x, bottom, x, bottom + 3, "#111111", 1);
        if (!isCrowded || (static_cast<std::ptrdiff_t>(i) - one) % 2 == 0)
            putText(out, x, bottom + 13, "middle", readable(ticks[i]));
    }
}

void drawRow(std::string &out, const RatioAxis &axis, const ForestRow &row, double y)
{
    putText(out, kLabels - 6, y + 3.3, "end", row.label, row.isSummary ? " font-weight=\"bold\"" : "");
    if (!std::isfinite(row.value)) {
        putText(out, kLabels + 4, y + 3.3, "start", row.missing, " font-style=\"italic\"");
        return;
    }
    if (std::isfinite(row.expectedLow) && std::isfinite(row.expectedHigh))
        putLine(out, axis.x(row.expectedLow), y + 4, axis.x(row.expectedHigh), y + 4, "#888888", 1);
    const bool hasInterval = std::isfinite(row.low) && std::isfinite(row.high);
    if (hasInterval) {
        putLine(out, axis.x(row.low), y, axis.x(row.high), y, "#111111", row.isSummary ? 2.4 : 1.2);
        for (const double end : {row.low, row.high})
            putLine(out, axis.x(end), y - 3, axis.x(end), y + 3, "#111111", 1.2);
    }
    put(out, "<circle cx=\"{}\" cy=\"{}\" r=\"3\" fill=\"{}\" stroke=\"#111111\"/>\n", axis.x(row.value), y,
        row.hollow ? "#ffffff" : "#111111");
    putText(out, kChartWidth - 3, y + 3.3, "end",
            hasInterval ? intervalText(row.value, row.low, row.high) : fixedText(row.value, 3));
}

} // namespace

std::vector<double> ratioTicks(double low, double high)
{
    for (const double step : {0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5}) {
        std::vector<double> out;
        for (double i = std::ceil(low / step - 1e-9); i * step <= high * (1 + 1e-9) && out.size() < 6; ++i)
            out.push_back(i * step);
        if (out.size() <= 5)
            return out;
    }
    std::vector<double> out; // far apart: 1, 2, 5 of each decade, or decades alone
    const bool decades = high / low > 100;
    for (double decade = std::pow(10, std::floor(std::log10(low))); decade <= high && out.size() < 12; decade *= 10) {
        for (const double part : {1.0, 2.0, 5.0}) {
            const double tick = part * decade;
            if (tick >= low * (1 - 1e-9) && tick <= high * (1 + 1e-9) && (part == 1 || !decades))
                out.push_back(tick);
        }
    }
    return out;
}

std::string svg(const ForestChart &chart)
{
    std::vector<std::string> lines = wrappedText(chart.subtitle);
    for (std::string &line : wrappedText(chart.legend))
        lines.push_back(std::move(line));
    const double top = chartTop(lines), bottom = top + kForestRow * static_cast<double>(chart.rows.size());
    const RatioAxis axis = axisOf(chart);
    std::string out = chartHead(bottom + 2 * kChartLine + 8, chart.title, lines);
    if (chart.margin > 0) {
        const double left = axis.x(1 / (1 + chart.margin)), right = axis.x(1 + chart.margin);
        put(out, "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#e4e4e4\"/>\n", left, top, right - left,
            bottom - top);
    }
    drawTicks(out, axis, bottom);
    putLine(out, kLabels, bottom, kChartWidth - kFigures, bottom, "#111111", 1);
    putLine(out, axis.x(1), top, axis.x(1), bottom, "#555555", 1);
    putText(out, kLabels + (kChartWidth - kLabels - kFigures) / 2.0, bottom + 26, "middle", chart.axis);
    for (std::size_t i = 0; i < chart.rows.size(); ++i) {
        const double middle = top + kForestRow * (static_cast<double>(i) + 0.5);
        if (chart.rows[i].isSummary && i > 0 && !chart.rows[i - 1].isSummary)
            putLine(out, 3, middle - kForestRow / 2.0, kChartWidth - 3, middle - kForestRow / 2.0, "#111111", 0.6);
        drawRow(out, axis, chart.rows[i], middle);
    }
    return out + "</svg>\n";
}

} // namespace skyseal::experiment
