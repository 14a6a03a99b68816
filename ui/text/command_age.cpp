#include "ui/text/command_age.h"

#include "core/engine/station/session_snapshot.h"
#include "ui/text/units.h"

#include <QtCore/QCoreApplication>

#include <cmath>

namespace skyseal::ui {

namespace {

struct CommandAgeText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::CommandAge)
};

constexpr double kLateFrom = 1; ///< seconds; less than that is not noticed

} // namespace

std::optional<CommandAge> commandAgeOf(const ViewState &view)
{
    if (!view.session || !view.session->stats.peerFreshness)
        return std::nullopt;
    const channel::FreshnessReport &report = *view.session->stats.peerFreshness;
    // Rounded up: the agent knows an upper bound.
    const double age = std::ceil(static_cast<double>(report.ageMicroseconds) / 1e5) / 10;
    const double limit = static_cast<double>(report.limitMilliseconds) / 1e3;
    const QString ageText = CommandAgeText::tr("%1 s").arg(number(age, 1)),
                  limitText = CommandAgeText::tr("%1 s").arg(number(limit, 1));
    CommandAge out;
    out.late = age >= kLateFrom;
    out.ignored = limit > 0 && age > limit;
    if (!report.isAgeKnown())
        out.sentence = out.ignored
            ? CommandAgeText::tr("Commands are ignored: their delay is unknown, and the limit is %1").arg(limitText)
            : CommandAgeText::tr("The delay of commands is unknown");
    else if (out.ignored)
        out.sentence =
            CommandAgeText::tr("Commands are ignored: they arrive up to %1 late, and the limit is %2").arg(ageText, limitText);
    else if (out.late)
        out.sentence = CommandAgeText::tr("Commands arrive up to %1 late").arg(ageText);
    else
        out.sentence = CommandAgeText::tr("Commands arrive within %1").arg(ageText);
    if (!report.isAgeKnown())
        out.brief = out.ignored ? CommandAgeText::tr("Commands ignored, delay unknown")
                                : CommandAgeText::tr("Delay of commands unknown");
    else
        out.brief = out.ignored ? CommandAgeText::tr("Commands ignored, %1 late").arg(ageText)
                                : CommandAgeText::tr("Commands %1 late").arg(ageText);
    const QString overtaken = CommandAgeText::tr("%1 s").arg(
        number(static_cast<double>(report.overtakenMilliseconds) / 1e3, 1));
    out.limits = limit > 0
        ? CommandAgeText::tr(
              "The agent ignores commands that are older than %1, or that were overtaken by newer messages by %2")
              .arg(limitText, overtaken)
        : CommandAgeText::tr("The agent ignores commands that were overtaken by newer messages by %1").arg(overtaken);
    return out;
}

} // namespace skyseal::ui
