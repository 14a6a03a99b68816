#include "ui/text/vehicle_text.h"

#include "core/base/overloaded.h"
#include "core/mavlink/enums.h"
#include "ui/text/units.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

/// The translations' context of the free functions below.
struct Text
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::StateText)
};

} // namespace

QString fixText(int gpsFixType)
{
    switch (gpsFixType) {
    case mavlink::GPS_FIX_TYPE_NO_GPS: return Text::tr("no GPS");
    case mavlink::GPS_FIX_TYPE_NO_FIX: return Text::tr("no fix");
    case mavlink::GPS_FIX_TYPE_2D_FIX: return Text::tr("2D fix");
    case mavlink::GPS_FIX_TYPE_3D_FIX: return Text::tr("3D fix");
    case mavlink::GPS_FIX_TYPE_DGPS: return Text::tr("DGPS");
    case mavlink::GPS_FIX_TYPE_RTK_FLOAT: return Text::tr("RTK float");
    case mavlink::GPS_FIX_TYPE_RTK_FIXED: return Text::tr("RTK fixed");
    case mavlink::GPS_FIX_TYPE_STATIC: return Text::tr("static");
    case mavlink::GPS_FIX_TYPE_PPP: return Text::tr("PPP");
    default: return dash();
    }
}

QString severityText(std::uint8_t severity)
{
    switch (severity) {
    case mavlink::MAV_SEVERITY_EMERGENCY: return Text::tr("emergency");
    case mavlink::MAV_SEVERITY_ALERT: return Text::tr("alert");
    case mavlink::MAV_SEVERITY_CRITICAL: return Text::tr("critical");
    case mavlink::MAV_SEVERITY_ERROR: return Text::tr("error");
    case mavlink::MAV_SEVERITY_WARNING: return Text::tr("warning");
    case mavlink::MAV_SEVERITY_NOTICE: return Text::tr("notice");
    case mavlink::MAV_SEVERITY_INFO: return Text::tr("info");
    default: return Text::tr("debug");
    }
}

QString commandText(const vehicle::VehicleCommand &command, UnitSystem units)
{
    const auto altitude = [units](double metres) {
        UnitScale scale = altitudeScale(units);
        scale.decimals = 0;
        return figureIn(scale, metres).text();
    };
    return std::visit(
        Overloaded{[](const vehicle::Arm &) { return Text::tr("Arm"); },
                   [](const vehicle::Disarm &c) { return c.force ? Text::tr("Emergency stop") : Text::tr("Disarm"); },
                   [&](const vehicle::TakeOff &c) { return Text::tr("Take off to %1").arg(altitude(c.altitude)); },
                   [](const vehicle::Land &) { return Text::tr("Land"); },
                   [](const vehicle::ReturnToLaunch &) { return Text::tr("RTL"); },
                   [](const vehicle::SetMode &c) { return Text::tr("Mode %1").arg(fromStd(c.mode)); },
                   [](const vehicle::GoTo &) { return Text::tr("Go here"); },
                   [&](const vehicle::ChangeAltitude &c) {
                       return Text::tr("Change altitude to %1").arg(altitude(c.altitudeRelative));
                   },
                   [](const vehicle::Loiter &) { return Text::tr("Pause"); },
                   [](const vehicle::PointAt &) { return Text::tr("Point camera here"); },
                   [](const vehicle::StopPointing &) { return Text::tr("Stop pointing camera"); },
                   [](const vehicle::SetHome &) { return Text::tr("Set home here"); },
                   [&](const vehicle::ChangeSpeed &c) {
                       return Text::tr("Speed %1").arg(speedFigure(c.metresPerSecond, units).text());
                   },
                   [](const vehicle::SetCurrentMissionItem &c) { return Text::tr("Mission item %1").arg(c.index); },
                   [](const vehicle::StartMission &) { return Text::tr("Start mission"); },
                   [](const vehicle::Reboot &) { return Text::tr("Restart the autopilot"); },
                   [](const vehicle::RawCommand &c) {
                       return c.command == mavlink::MAV_CMD_RUN_PREARM_CHECKS ? Text::tr("Pre-arm checks")
                                                                              : Text::tr("Command %1").arg(c.command);
                   }},
        command);
}

} // namespace skyseal::ui
