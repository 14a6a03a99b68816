#include "ui/charts/chart_builder.h"

#include "ui/theme/suite_style.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

using engine::MetricsSample;

namespace {

/// The translation context of the functions below.
struct ChartBuilderText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::ChartBuilder)
};

/// Keeps the lowest and the highest point of each bucket in their order, so that peaks survive.
std::vector<QPointF> thinned(const std::vector<QPointF> &points, std::size_t most)
{
    if (points.size() <= most || most < 4)
        return points;
    std::vector<QPointF> out;
    const std::size_t buckets = most / 2;
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
        const auto first = points.begin() + static_cast<std::ptrdiff_t>(bucket * points.size() / buckets);
        const auto last = points.begin() + static_cast<std::ptrdiff_t>((bucket + 1) * points.size() / buckets);
        const auto [low, high] = std::minmax_element(first, last,
                                                     [](const QPointF &a, const QPointF &b) { return a.y() < b.y(); });
        out.push_back(low < high ? *low : *high);
        if (low != high)
            out.push_back(low < high ? *high : *low);
    }
    return out;
}

void thin(std::vector<ChartRun> &runs, std::size_t most)
{
    std::size_t total = 0;
    for (const ChartRun &run : runs)
        total += run.points.size();
    if (total <= most)
        return;
    for (ChartRun &run : runs)
        run.points = thinned(run.points, std::max<std::size_t>(4, run.points.size() * most / total));
}

/// Samples from the last one before the range to the first one after it, so that lines reach the edges.
std::pair<std::size_t, std::size_t> within(const std::deque<MetricsSample> &samples, double from, double to)
{
    const auto first = std::ranges::lower_bound(samples, from, {}, &MetricsSample::time);
    const auto last = std::ranges::upper_bound(samples, to, {}, &MetricsSample::time);
    return {static_cast<std::size_t>(first - samples.begin()), static_cast<std::size_t>(last - samples.begin())};
}

bool sameStretch(const MetricsSample &a, const MetricsSample &b)
{
    return a.suite == b.suite && a.linkUp == b.linkUp;
}

void appendRuns(std::vector<ChartRun> &runs, const SampleHistory &history, const QuantityLine &line, const ChartRange &range)
{
    const auto &samples = history.samples();
    const double zero = range.zero(history.newest());
    const auto [first, last] = within(samples, zero + range.from(), zero + range.to());
    const MetricsSample *before = nullptr;
    bool open = false;
    for (std::size_t i = first; i < last; ++i) {
        const MetricsSample &sample = samples[i];
        const double value = line.value(sample);
        const bool close = before && sample.time - before->time <= kGapSeconds;
        if (!std::isfinite(value)) {
            open = false;
        } else {
            const QPointF point(sample.time - zero, value);
            if (!(open && close && sameStretch(*before, sample))) {
                if (open && close) // the old run ends at the first point of the new one: no gap
                    runs.back().points.push_back(point);
                runs.push_back({sample.linkUp ? suiteColor(sample.suite) : suiteColor(crypto::SuiteId::None),
                                line.stroke,
                                line.name,
                                sample.linkUp ? suiteName(sample.suite) : ChartBuilderText::tr("no link"),
                                {}});
            }
            runs.back().points.push_back(point);
            open = true;
        }
        before = &sample;
    }
}

} // namespace

ChartContent buildTimeLine(const SampleHistory &history, const Quantity &quantity, const ChartRange &range,
                           std::size_t mostPoints)
{
    ChartContent content;
    content.time = range.frozen() ? ChartTime::Frozen : ChartTime::BeforeNow;
    content.from = range.from();
    content.to = range.to();
    for (const QuantityLine &line : quantity.lines)
        appendRuns(content.runs, history, line, range);
    thin(content.runs, mostPoints);
    return content;
}

ChartContent buildOverlay(const SampleHistory &history, const Quantity &quantity, const ChartRange &range,
                          std::size_t mostPoints)
{
    ChartContent content;
    content.time = ChartTime::InUse;
    content.from = 0;
    content.to = range.span();
    for (const QuantityLine &line : quantity.lines) {
        for (const SuiteUse &use : history.suites().uses()) {
            const double start = std::max(0.0, use.inUse - range.span());
            bool open = false;
            for (const SuiteUse::Point &point : use.points) {
                const double value = line.value(point.sample);
                if (point.inUse < start || !std::isfinite(value)) {
                    open = false;
                    continue;
                }
                if (!open || !point.joined)
                    content.runs.push_back({suiteColor(use.suite), line.stroke, line.name, suiteName(use.suite), {}});
                content.runs.back().points.emplace_back(point.inUse - start, value);
                open = true;
            }
        }
    }
    thin(content.runs, mostPoints);
    return content;
}

std::vector<ChartBar> buildBars(const SampleHistory &history, const Quantity &quantity, std::size_t firstTally)
{
    std::vector<ChartBar> bars;
    if (!quantity.perSuite)
        return bars;
    for (const SuiteUse &use : history.suites().uses()) {
        const Tally &tally = use.tallies[firstTally + quantity.barLine];
        if (tally.count > 0)
            bars.push_back({suiteColor(use.suite), suiteName(use.suite), tally.mean(), tally.low, tally.high, tally.count});
    }
    return bars;
}

double highestOf(const ChartContent &content)
{
    double highest = 0;
    for (const ChartRun &run : content.runs)
        for (const QPointF &point : run.points)
            highest = std::max(highest, point.y());
    for (const ChartBar &bar : content.bars)
        highest = std::max(highest, bar.mean);
    return highest;
}

std::vector<crypto::SuiteId> suitesUsed(const SampleHistory &history)
{
    std::vector<crypto::SuiteId> out;
    for (const SuiteUse &use : history.suites().uses())
        out.push_back(use.suite);
    return out;
}

} // namespace skyseal::ui
