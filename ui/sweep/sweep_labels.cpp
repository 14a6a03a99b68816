#include "ui/sweep/sweep_labels.h"

#include "ui/text/vehicle_text.h"
#include "ui/theme/suite_style.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

using experiment::SweepArm;

namespace {

struct SweepLabelsText
{
    Q_DECLARE_TR_FUNCTIONS(Sweep)
};

} // namespace

QString localNumber(const std::string &figures)
{
    QString out;
    for (const QChar c : fromStd(figures))
        out += c == QLatin1Char('.') ? QLocale().decimalPoint()
            : c == QLatin1Char(',')  ? QLocale().groupSeparator()
                                     : QString(c);
    return out;
}

QString framingText(const SweepArm &arm)
{
    if (arm.suite == crypto::SuiteId::None)
        return SweepLabelsText::tr("none");
    switch (arm.framing) {
    case experiment::ArmFraming::Inline: return SweepLabelsText::tr("inline");
    case experiment::ArmFraming::Bare: return SweepLabelsText::tr("bare, insecure");
    case experiment::ArmFraming::Sealed: break;
    }
    return SweepLabelsText::tr("sealed");
}

QString armText(const SweepArm &arm)
{
    const QString name = arm.suite == crypto::SuiteId::None
        ? suiteName(arm.suite)
        : SweepLabelsText::tr("%1, %2").arg(suiteName(arm.suite), framingText(arm));
    return arm.again ? SweepLabelsText::tr("%1 (A/A)").arg(name) : name;
}

QString loadText(experiment::Load load)
{
    if (load.isPaced())
        return SweepLabelsText::tr("load of %1 frames/s").arg(load.perSecond);
    return load == experiment::Load::Natural ? SweepLabelsText::tr("natural load") : SweepLabelsText::tr("saturated load");
}

QString linkText(const experiment::Condition &link)
{
    if (link.clean())
        return SweepLabelsText::tr("clean link");
    const auto text = [](double value) { return localNumber(experiment::readable(value)); };
    const auto ms = [&](Duration time) { return text(1000 * seconds(time)); };
    const impair::ImpairmentSettings &is = link.settings;
    QStringList parts;
    if (is.baud > 0)
        parts << SweepLabelsText::tr("%1 baud").arg(text(static_cast<double>(is.baud)));
    if (is.loss > 0)
        parts << SweepLabelsText::tr("%1 % loss").arg(text(100 * is.loss));
    if (is.duplicate > 0)
        parts << SweepLabelsText::tr("%1 % duplicates").arg(text(100 * is.duplicate));
    if (is.reorder > 0)
        parts << SweepLabelsText::tr("%1 % reordered").arg(text(100 * is.reorder));
    if (is.corrupt > 0)
        parts << SweepLabelsText::tr("%1 % corrupted").arg(text(100 * is.corrupt));
    if (is.delay > Duration::zero())
        parts << SweepLabelsText::tr("%1 ms delay").arg(ms(is.delay));
    if (is.jitter > Duration::zero())
        parts << SweepLabelsText::tr("up to %1 ms jitter").arg(ms(is.jitter));
    return parts.isEmpty() ? SweepLabelsText::tr("no impairment") : parts.join(QStringLiteral(", "));
}

QString placeText(const experiment::Plan &plan, std::size_t condition, std::size_t load)
{
    QString text = loadText(plan.loads[load]);
    if (std::ranges::all_of(plan.conditions, &experiment::Condition::clean))
        return text;
    return linkText(plan.conditions[condition]) + QStringLiteral(" · ") + text;
}

QString aboutTime(double seconds)
{
    const long whole = std::max(1L, std::lround(seconds));
    return whole < 60 ? SweepLabelsText::tr("about %1 s").arg(whole)
                      : SweepLabelsText::tr("about %1 min %2 s").arg(whole / 60).arg(whole % 60);
}

QString ratioText(const experiment::Contrast &ratio)
{
    const auto text = [](double value) { return localNumber(experiment::readable(value)); };
    return std::isfinite(ratio.low()) && std::isfinite(ratio.high())
        ? SweepLabelsText::tr("%1 (%2 to %3)").arg(text(ratio.value()), text(ratio.low()), text(ratio.high()))
        : text(ratio.value());
}

QString ratiosText(const experiment::Plan &plan)
{
    const auto reference = experiment::referenceArm(plan);
    if (!reference || plan.arms[*reference].suite == crypto::SuiteId::None)
        return SweepLabelsText::tr("Ratios to plain MAVLink");
    return SweepLabelsText::tr("Ratios to %1").arg(armText(plan.arms[*reference]));
}

QString metricTitle(experiment::Metric metric)
{
    return reasonText(experiment::info(metric).title);
}

QString metricDescription(experiment::Metric metric)
{
    return reasonText(experiment::info(metric).description);
}

QString metricText(experiment::Metric metric)
{
    return metricText(metric, experiment::info(metric).unit);
}

QString metricText(experiment::Metric metric, std::string_view unit)
{
    if (unit.empty())
        return metricTitle(metric);
    const QString shown = unit == "frames/s" ? SweepLabelsText::tr("frames/s") : fromStd(unit);
    return metricTitle(metric) + QStringLiteral(", ") + shown;
}

QString notInFramingText()
{
    return SweepLabelsText::tr("not in this framing");
}

} // namespace skyseal::ui
