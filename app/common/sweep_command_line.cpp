#include "app/common/sweep_command_line.h"

#include <QtCore/QLocale>
#include <QtCore/QRegularExpression>

namespace skyseal::app {

namespace {

QString quoted(const QString &word)
{
    static const QRegularExpression kSafe(QStringLiteral("^[A-Za-z0-9_@%+=:,./-]+$"));
    if (kSafe.match(word).hasMatch())
        return word;
    QString inside = word;
    return QLatin1Char('\'') + inside.replace(QLatin1Char('\''), QStringLiteral("'\\''")) + QLatin1Char('\'');
}

QString numberText(double value)
{
    return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

QString framingText(const experiment::Plan &plan)
{
    const std::vector<experiment::ArmFraming> framings = experiment::framingsOf(plan);
    if (framings.empty())
        return QStringLiteral("sealed");
    if (framings.size() == 1)
        return QString::fromUtf8(experiment::name(framings.front()).data());
    return framings.size() == 2 ? QStringLiteral("both") : QStringLiteral("all");
}

} // namespace

QString shellText(const QStringList &words)
{
    QStringList out;
    for (const QString &word : words)
        out << quoted(word);
    return out.join(QLatin1Char(' '));
}

QStringList linkArguments(const experiment::Plan &plan)
{
    QStringList out;
    for (const experiment::Condition &condition : plan.conditions)
        out << QStringLiteral("--impair") << QString::fromStdString(condition.name);
    return out;
}

QStringList suiteArguments(const experiment::Plan &plan)
{
    QStringList names;
    for (const experiment::SweepArm &arm : plan.arms) {
        const QString name = QString::fromUtf8(crypto::suiteInfo(arm.suite).name.data());
        if (!names.contains(name))
            names << name;
    }
    return {QStringLiteral("--suites"), names.join(QLatin1Char(','))};
}

QStringList sweepArguments(const experiment::Plan &plan)
{
    QStringList loads, paces;
    bool noise = false;
    for (const experiment::SweepArm &arm : plan.arms)
        noise = noise || arm.again;
    for (const experiment::Load load : plan.loads) {
        if (load.isPaced())
            paces << QString::number(load.perSecond);
        else
            loads << QString::fromStdString(experiment::name(load));
    }
    QStringList out = suiteArguments(plan);
    out << QStringLiteral("--framing") << framingText(plan);
    if (!loads.isEmpty())
        out << QStringLiteral("--load") << loads.join(QLatin1Char(','));
    if (!paces.isEmpty())
        out << QStringLiteral("--pps") << paces.join(QLatin1Char(','));
    out << linkArguments(plan) << QStringLiteral("--seconds") << numberText(seconds(plan.measure))
        << QStringLiteral("--warm-up") << numberText(seconds(plan.warmUp)) << QStringLiteral("--launches")
        << QString::number(plan.launches) << QStringLiteral("--repeats") << QString::number(plan.repeats / plan.phases)
        << QStringLiteral("--margin") << numberText(100 * plan.margin) << QStringLiteral("--seed") << QString::number(plan.seed)
        << (noise ? QStringLiteral("--noise") : QStringLiteral("--no-noise"));
    if (!plan.flight.empty())
        out << QStringLiteral("--fly") << QString::fromStdString(plan.flight);
    return out;
}

} // namespace skyseal::app
