#include "core/experiment/bar_chart.h"

#include "core/experiment/analysis.h"
#include "core/experiment/append_format.h"
#include "core/experiment/chart_parts.h"
#include "core/experiment/sweep_text.h"

#include <algorithm>
#include <cmath>

namespace skyseal::experiment {

namespace {

/// A row is a line of text, the arm and its mean, and the bar below it.
constexpr int kLeft = 3, kRight = 12, kRow = 27, kBar = 9, kBottom = 36;
constexpr double kBarMiddle = 18; ///< below the top of its row

struct Scale
{
    double factor = 1;
    std::string unit;
};

Scale scaleFor(Metric metric, double highest)
{
    const std::string_view unit = info(metric).unit;
    if (info(metric).isShare())
        return {100, "%"};
    if (unit == "B" && highest >= 1e6)
        return {1e-6, "MB"};
    if (unit == "B" && highest >= 1e4)
        return {1e-3, "kB"};
    if (unit == "B/s" && highest >= 1e6)
        return {1e-6, "MB/s"};
    if (unit == "B/s" && highest >= 1e4)
        return {1e-3, "kB/s"};
    if (unit == "ns" && highest >= 1e4)
        return {1e-3, "µs"};
    return {1, std::string(unit)};
}

double highestOf(const std::vector<Bar> &bars)
{
    double highest = 0;
    for (const Bar &bar : bars) {
        for (const double value : {bar.mean, bar.high})
            highest = std::isfinite(value) ? std::max(highest, value) : highest;
        for (const double value : bar.samples)
            highest = std::isfinite(value) ? std::max(highest, value) : highest;
    }
    return highest;
}

struct Axis
{
    double step, end;
    double x(double value) const { return kLeft + (kChartWidth - kLeft - kRight) * std::clamp(value / end, 0.0, 1.0); }
};

void drawAxis(std::string &out, const Axis &axis, const BarChart &chart, double top, double bottom)
{
    const bool isCrowded = axis.end / axis.step > 6.5; // every other tick has its number
    for (int i = 0; i * axis.step <= axis.end * 1.0001; ++i) {
        const double x = axis.x(i * axis.step);
        putLine(out, x, top, x, bottom, i == 0 ? "#333333" : "#dddddd", 1);
        if (!isCrowded || i % 2 == 0)
            putText(out, x, bottom + kChartLine,
                    i == 0                     ? "start"
                        : x > kChartWidth - 20 ? "end"
                                               : "middle",
                    readable(i * axis.step));
    }
    putText(out, (kChartWidth - kRight + kLeft) / 2.0, bottom + 2 * kChartLine, "middle", chart.axis);
}

/// Hatching by single lines at 45 degrees, since SVG Tiny, the profile that Qt supports, has no patterns.
void hatch(std::string &out, double left, double top, double right)
{
    constexpr double kSpacing = 5;
    for (double x = left - kBar + kSpacing; x < right; x += kSpacing) {
        const double from = std::max(x, left), to = std::min(x + kBar, right);
        if (to > from)
            put(out, "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"#b5532a\" stroke-width=\"1.1\"/>\n", from,
                top + kBar - (from - x), to, top + kBar - (to - x));
    }
}

/// `top`: of the row.
void drawBar(std::string &out, const Axis &axis, const Bar &bar, double top)
{
    const double middle = top + kBarMiddle;
    const bool isMeasured = std::isfinite(bar.mean);
    putText(out, kLeft, top + 10, "start", bar.label + (bar.insecure ? " (insecure)" : ""));
    putText(out, kChartWidth - 3, top + 10, "end", isMeasured ? readable(bar.mean, bar.low, bar.high) : bar.missing,
            isMeasured ? "" : " font-style=\"italic\"");
    if (!isMeasured)
        return;
    put(out, "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" stroke=\"{}\"/>\n", kLeft, middle - kBar / 2.0,
        std::max(0.0, axis.x(bar.mean) - kLeft), kBar, bar.insecure ? "#f3d9cc" : "#8fb3d9",
        bar.insecure ? "#b5532a" : "#5b86b5");
    if (bar.insecure)
        hatch(out, kLeft, middle - kBar / 2.0, axis.x(bar.mean));
    if (std::isfinite(bar.low) && std::isfinite(bar.high)) {
        const double low = axis.x(bar.low), high = axis.x(bar.high);
        putLine(out, low, middle, high, middle, "#111111", 1.2);
        if (bar.low > 0) // no end mark where the interval is cut off at zero
            putLine(out, low, middle - 3.5, low, middle + 3.5, "#111111", 1.2);
        putLine(out, high, middle - 3.5, high, middle + 3.5, "#111111", 1.2);
    }
    for (std::size_t i = 0; i < bar.samples.size(); ++i) {
        if (!std::isfinite(bar.samples[i]))
            continue;
        put(out, "<circle cx=\"{}\" cy=\"{}\" r=\"1.8\" fill=\"{}\" stroke=\"{}\" stroke-width=\"0.6\"/>\n",
            axis.x(bar.samples[i]), middle, bar.outlier[i] ? "#ffffff" : "#1d3f66", bar.outlier[i] ? "#c00000" : "#ffffff");
    }
}

} // namespace

std::string escaped(std::string_view text)
{
    std::string out;
    for (const char c : text) {
        switch (c) {
        case '&': out += "&amp;"; break;
        case '<': out += "&lt;"; break;
        case '>': out += "&gt;"; break;
        case '"': out += "&quot;"; break;
        default: out += c;
        }
    }
    return out;
}

double axisStep(double highest)
{
    if (!(highest > 0) || !std::isfinite(highest))
        return 0.2;
    const double decade = std::pow(10, std::floor(std::log10(highest / 4)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (highest / (step * decade) <= 8)
            return step * decade;
    }
    return 10 * decade;
}

/// Number of runs and meaning of the drawing. `counts`: the runs of each arm.
static std::string legendOf(const Plan &plan, Metric metric, const std::vector<std::size_t> &counts, bool anyInterval,
                            bool anyOutlier)
{
    std::string out = runsText(counts) + " of " + readable(seconds(plan.measure))
        + " s for each; bar: mean, hatched: insecure, " + (anyInterval ? "whisker: 95 % confidence interval, " : "")
        + "dots: single runs";
    if (info(metric).oncePerSuite)
        out = "measured once for each suite with separate sessions; hatched: insecure";
    if (!info(metric).independent)
        out += "; one process runs all suites: not a suite's own";
    if (anyOutlier)
        out += ", white ones: outliers";
    return out;
}

BarChart chartOf(const Results &results, std::size_t condition, std::size_t load, Metric metric)
{
    const Plan &plan = results.plan;
    BarChart out;
    out.title = info(metric).title.english();
    out.subtitle = "link: " + conditionText(plan.conditions[condition]) + "; load: " + std::string(name(plan.loads[load]));
    bool anyOutlier = false, anyInterval = false;
    std::vector<std::size_t> counts;
    for (std::size_t arm = 0; arm < plan.arms.size(); ++arm) {
        Bar bar;
        bar.label = fullName(plan.arms[arm]);
        bar.missing = missingText(plan.arms[arm]);
        bar.suite = plan.arms[arm].suite;
        bar.insecure = isInsecure(plan.arms[arm]);
        bar.samples = valuesOf(results, {condition, load, arm}, metric);
        const Summary summary = summaryOf(results, {condition, load, arm}, metric);
        bar.mean = summary.mean;
        bar.low = summary.low();
        bar.high = summary.high();
        counts.push_back(summary.count);
        anyInterval = anyInterval || std::isfinite(summary.halfWidth);
        bar.outlier.assign(bar.samples.size(), false);
        anyOutlier = anyOutlier || !summary.outliers.empty();
        for (const std::size_t index : summary.outliers)
            bar.outlier[index] = true;
        out.bars.push_back(std::move(bar));
    }
    out.legend = legendOf(plan, metric, counts, anyInterval, anyOutlier);
    const Scale scale = scaleFor(metric, highestOf(out.bars));
    for (Bar &bar : out.bars) {
        for (double *value : {&bar.mean, &bar.low, &bar.high})
            *value *= scale.factor;
        for (double &value : bar.samples)
            value *= scale.factor;
    }
    out.unit = scale.unit;
    out.axis = out.title + (out.unit.empty() ? "" : ", " + out.unit);
    return out;
}

std::string svg(const BarChart &chart)
{
    std::vector<std::string> lines = wrappedText(chart.subtitle);
    for (std::string &line : wrappedText(chart.legend))
        lines.push_back(std::move(line));
    const double top = chartTop(lines), bottom = top + kRow * static_cast<double>(chart.bars.size()) + 2;
    const double highest = highestOf(chart.bars), step = axisStep(highest);
    const Axis axis{step, step * (highest > 0 ? std::ceil(highest / step - 1e-9) : 5)};
    std::string out = chartHead(bottom + kBottom, chart.title, lines);
    drawAxis(out, axis, chart, top, bottom);
    for (std::size_t i = 0; i < chart.bars.size(); ++i)
        drawBar(out, axis, chart.bars[i], top + kRow * static_cast<double>(i));
    return out + "</svg>\n";
}

} // namespace skyseal::experiment
