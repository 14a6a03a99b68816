#include "ui/charts/chart_text.h"

#include "ui/text/units.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <cmath>
#include <vector>

namespace skyseal::ui {

namespace {

/// The translation context of the functions below.
struct ChartText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::ChartText)
};

/// Points further away than this, in seconds, are not shown for a time.
constexpr double kNear = 1.0;

const QPointF *nearest(const ChartRun &run, double x)
{
    const auto at = std::ranges::lower_bound(run.points, x, {}, [](const QPointF &p) { return p.x(); });
    const QPointF *best = nullptr;
    if (at != run.points.end())
        best = &*at;
    if (at != run.points.begin() && (!best || x - std::prev(at)->x() < best->x() - x))
        best = &*std::prev(at);
    return best;
}

/// The value of one line at the time.
struct Reading
{
    const ChartRun *run;
    QPointF point;
};

/// One value for each line, and for each suite in the overlay. A line that is interrupted near the time has several runs; the
/// nearest point counts.
std::vector<Reading> readingsAt(const ChartContent &content, double x, double near)
{
    std::vector<Reading> out;
    for (const ChartRun &run : content.runs) {
        const QPointF *point = nearest(run, x);
        if (!point || std::abs(point->x() - x) > near)
            continue;
        const auto same = std::ranges::find_if(out, [&](const Reading &reading) {
            return reading.run->line == run.line && (content.time != ChartTime::InUse || reading.run->suite == run.suite);
        });
        if (same == out.end())
            out.push_back({&run, *point});
        else if (std::abs(point->x() - x) <= std::abs(same->point.x() - x))
            *same = {&run, *point};
    }
    return out;
}

} // namespace

QString chartTimeText(double x, ChartTime time, int decimals)
{
    if (time == ChartTime::BeforeNow && std::abs(x) < 1e-9)
        return ChartText::tr("now");
    return ChartText::tr("%1 s").arg(number(x, decimals));
}

QStringList chartTextAt(const ChartContent &content, double x, double reach, int decimals)
{
    QStringList out;
    const double near = std::max(kNear, reach);
    QString suite;
    for (const auto &[run, point] : readingsAt(content, x, near)) {
        const QString value = number(point.y(), decimals);
        const QString line = run->line.isEmpty() ? value : ChartText::tr("%1 %2").arg(run->line, value);
        if (content.time != ChartTime::InUse)
            suite = run->suite;
        out << (content.time == ChartTime::InUse ? ChartText::tr("%1: %2").arg(run->suite, line) : line);
    }
    if (out.isEmpty())
        return out;
    const QString when = chartTimeText(x, content.time, 1);
    out.prepend(suite.isEmpty() ? when : ChartText::tr("%1 · %2").arg(when, suite));
    for (const ChartMark &mark : content.marks)
        if (std::abs(mark.x - x) <= reach)
            out << (mark.incident ? ChartText::tr("! %1").arg(mark.text) : ChartText::tr("→ %1").arg(mark.text));
    return out;
}

} // namespace skyseal::ui
