#include "ui/charts/chart_builder.h"

#include "ui/theme/suite_style.h"

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

using engine::MetricsSample;

namespace {

constexpr double kGapSeconds = 2;

/// Keeps the lowest and highest point of each bucket, in their order: peaks survive the thinning.
std::vector<QPointF> thinned(const std::vector<QPointF> &points, std::size_t most)
{
    if (points.size() <= most || most < 4)
        return points;
    std::vector<QPointF> out;
    const std::size_t buckets = most / 2;
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
        const auto first = points.begin() + static_cast<std::ptrdiff_t>(bucket * points.size() / buckets);
        const auto last = points.begin() + static_cast<std::ptrdiff_t>((bucket + 1) * points.size() / buckets);
        const auto [low, high]
            = std::minmax_element(first, last, [](const QPointF &a, const QPointF &b) { return a.y() < b.y(); });
        out.push_back(low < high ? *low : *high);
        if (low != high)
            out.push_back(low < high ? *high : *low);
    }
    return out;
}

std::deque<MetricsSample>::const_iterator firstWithin(const SampleHistory &history, double span)
{
    const auto &samples = history.samples();
    const double from = samples.empty() ? 0 : samples.back().time - span;
    return std::ranges::find_if(samples, [&](const MetricsSample &s) { return s.time >= from; });
}

void appendRuns(ChartContent &content, const SampleHistory &history, const ChartLine &line, double span)
{
    const auto &samples = history.samples();
    const double now = samples.back().time;
    const MetricsSample *before = nullptr;
    bool open = false;
    for (auto at = firstWithin(history, span); at != samples.end(); ++at) {
        const double value = line.value(*at);
        const bool continues = open && before && before->suite == at->suite && at->time - before->time <= kGapSeconds;
        if (!std::isfinite(value)) {
            open = false;
        } else {
            const QPointF point(at->time - now, value);
            if (!continues) {
                const bool joins = open && before && at->time - before->time <= kGapSeconds;
                if (joins) // the old colour reaches to the first point of the new one, so that the line has no hole
                    content.runs.back().points.push_back(point);
                content.runs.push_back({suiteColor(at->suite), line.dashed, {}});
            }
            content.runs.back().points.push_back(point);
            open = true;
        }
        before = &*at;
    }
}

} // namespace

ChartContent buildChart(const SampleHistory &history, const std::vector<ChartLine> &lines, double span,
                        std::size_t mostPoints)
{
    ChartContent content;
    content.span = span;
    if (history.empty())
        return content;
    for (const ChartLine &line : lines)
        appendRuns(content, history, line, span);
    std::size_t total = 0;
    for (const ChartRun &run : content.runs)
        total += run.points.size();
    if (total > mostPoints)
        for (ChartRun &run : content.runs)
            run.points = thinned(run.points, std::max<std::size_t>(4, run.points.size() * mostPoints / total));

    const auto &samples = history.samples();
    const MetricsSample *before = nullptr;
    for (auto at = firstWithin(history, span); at != samples.end(); ++at) {
        if (!at->linkUp)
            continue; // no suite was in use
        if (before && before->suite != at->suite)
            content.marks.push_back({at->time - samples.back().time, suiteColor(at->suite), suiteName(at->suite)});
        before = &*at;
    }
    return content;
}

double highestOf(const ChartContent &content)
{
    double highest = 0;
    for (const ChartRun &run : content.runs)
        for (const QPointF &point : run.points)
            highest = std::max(highest, point.y());
    return highest;
}

std::vector<crypto::SuiteId> suitesIn(const SampleHistory &history, double span)
{
    std::vector<crypto::SuiteId> out;
    for (auto at = firstWithin(history, span); at != history.samples().end(); ++at)
        if (at->linkUp && std::ranges::find(out, at->suite) == out.end())
            out.push_back(at->suite);
    return out;
}

} // namespace skyseal::ui
