#include "ui/sweep/sweep_words.h"

#include "ui/text/words.h"
#include "ui/theme/suite_style.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

using experiment::Arm;

namespace {

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(Sweep)
};

} // namespace

QString framingWords(const Arm &arm)
{
    if (arm.suite == crypto::SuiteId::None)
        return Words::tr("none");
    return arm.framing == channel::Framing::Inline ? Words::tr("inline") : Words::tr("sealed");
}

QString armWords(const Arm &arm)
{
    const QString name
        = arm.suite == crypto::SuiteId::None ? suiteName(arm.suite)
                                             : Words::tr("%1, %2").arg(suiteName(arm.suite), framingWords(arm));
    return arm.again ? Words::tr("%1 (A/A)").arg(name) : name;
}

QString loadWords(experiment::Load load)
{
    return load == experiment::Load::Natural ? Words::tr("natural load") : Words::tr("saturated load");
}

QString placeWords(const experiment::Plan &plan, std::size_t condition, std::size_t load)
{
    const QString words = loadWords(plan.loads[load]);
    if (std::ranges::all_of(plan.conditions, &experiment::Condition::clean))
        return words;
    const experiment::Condition &link = plan.conditions[condition];
    return (link.clean() ? Words::tr("clean link") : fromStd(experiment::words(link))) + QStringLiteral(" · ") + words;
}

QString aboutTime(double seconds)
{
    const long whole = std::max(1L, std::lround(seconds));
    return whole < 60 ? Words::tr("about %1 s").arg(whole) : Words::tr("about %1 min %2 s").arg(whole / 60).arg(whole % 60);
}

QString metricWords(experiment::Metric metric)
{
    const experiment::MetricInfo &info = experiment::info(metric);
    return info.unit.empty() ? fromStd(info.title) : fromStd(info.title) + QStringLiteral(", ") + fromStd(info.unit);
}

} // namespace skyseal::ui
