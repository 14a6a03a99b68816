#include "ui/text/state_text.h"

#include "core/mavlink/enums.h"
#include "ui/text/units.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

/// The translations' context of the free functions below.
struct Words
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::Words)
};

template<typename... Ts> struct Overloaded : Ts...
{
    using Ts::operator()...;
};
template<typename... Ts> Overloaded(Ts...) -> Overloaded<Ts...>;

} // namespace

QString fromStd(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString fixText(int gpsFixType)
{
    switch (gpsFixType) {
    case mavlink::GPS_FIX_TYPE_NO_GPS: return Words::tr("no GPS");
    case mavlink::GPS_FIX_TYPE_NO_FIX: return Words::tr("no fix");
    case mavlink::GPS_FIX_TYPE_2D_FIX: return Words::tr("2D fix");
    case mavlink::GPS_FIX_TYPE_3D_FIX: return Words::tr("3D fix");
    case mavlink::GPS_FIX_TYPE_DGPS: return Words::tr("DGPS");
    case mavlink::GPS_FIX_TYPE_RTK_FLOAT: return Words::tr("RTK float");
    case mavlink::GPS_FIX_TYPE_RTK_FIXED: return Words::tr("RTK fixed");
    case mavlink::GPS_FIX_TYPE_STATIC: return Words::tr("static");
    case mavlink::GPS_FIX_TYPE_PPP: return Words::tr("PPP");
    default: return dash();
    }
}

QString severityText(std::uint8_t severity)
{
    switch (severity) {
    case mavlink::MAV_SEVERITY_EMERGENCY: return Words::tr("emergency");
    case mavlink::MAV_SEVERITY_ALERT: return Words::tr("alert");
    case mavlink::MAV_SEVERITY_CRITICAL: return Words::tr("critical");
    case mavlink::MAV_SEVERITY_ERROR: return Words::tr("error");
    case mavlink::MAV_SEVERITY_WARNING: return Words::tr("warning");
    case mavlink::MAV_SEVERITY_NOTICE: return Words::tr("notice");
    case mavlink::MAV_SEVERITY_INFO: return Words::tr("info");
    default: return Words::tr("debug");
    }
}

QString commandOutcomeText(const vehicle::CommandResult &result)
{
    const QString reason = fromStd(result.reason);
    switch (result.outcome) {
    case vehicle::CommandOutcome::Accepted: return Words::tr("accepted");
    case vehicle::CommandOutcome::Refused:
        return reason.isEmpty() ? Words::tr("refused") : Words::tr("refused: %1").arg(reason);
    case vehicle::CommandOutcome::TimedOut: return reason.isEmpty() ? Words::tr("no answer") : reason;
    }
    return {};
}

QString commandText(const vehicle::VehicleCommand &command)
{
    return std::visit(
        Overloaded{[](const vehicle::Arm &) { return Words::tr("Arm"); },
                   [](const vehicle::Disarm &) { return Words::tr("Disarm"); },
                   [](const vehicle::TakeOff &c) { return Words::tr("Take off to %1 m").arg(number(c.altitude, 0)); },
                   [](const vehicle::Land &) { return Words::tr("Land"); },
                   [](const vehicle::ReturnToLaunch &) { return Words::tr("Return to launch"); },
                   [](const vehicle::SetMode &c) { return Words::tr("Mode %1").arg(fromStd(c.mode)); },
                   [](const vehicle::GoTo &) { return Words::tr("Fly to the point"); },
                   [](const vehicle::ChangeSpeed &c) { return Words::tr("Speed %1 m/s").arg(number(c.metresPerSecond, 1)); },
                   [](const vehicle::SetCurrentMissionItem &c) { return Words::tr("Mission item %1").arg(c.index); },
                   [](const vehicle::StartMission &) { return Words::tr("Start the mission"); },
                   [](const vehicle::Reboot &) { return Words::tr("Restart the autopilot"); },
                   [](const vehicle::RawCommand &c) { return Words::tr("Command %1").arg(c.command); }},
        command);
}

} // namespace skyseal::ui
