#include "ui/text/vehicle_text.h"

#include "core/base/overloaded.h"
#include "core/mavlink/enums.h"
#include "ui/text/units.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

/// The translations' context of the free functions below.
struct VehicleText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::StateText)
};

} // namespace

QString fixText(int gpsFixType)
{
    switch (gpsFixType) {
    case mavlink::GPS_FIX_TYPE_NO_GPS: return VehicleText::tr("no GPS");
    case mavlink::GPS_FIX_TYPE_NO_FIX: return VehicleText::tr("no fix");
    case mavlink::GPS_FIX_TYPE_2D_FIX: return VehicleText::tr("2D fix");
    case mavlink::GPS_FIX_TYPE_3D_FIX: return VehicleText::tr("3D fix");
    case mavlink::GPS_FIX_TYPE_DGPS: return VehicleText::tr("DGPS");
    case mavlink::GPS_FIX_TYPE_RTK_FLOAT: return VehicleText::tr("RTK float");
    case mavlink::GPS_FIX_TYPE_RTK_FIXED: return VehicleText::tr("RTK fixed");
    case mavlink::GPS_FIX_TYPE_STATIC: return VehicleText::tr("static");
    case mavlink::GPS_FIX_TYPE_PPP: return VehicleText::tr("PPP");
    default: return dash();
    }
}

QString batteriesText(const vehicle::VehicleState &state)
{
    QStringList lines;
    for (const vehicle::Battery &battery : state.batteries) {
        const QString name = battery.function == mavlink::MAV_BATTERY_FUNCTION_AVIONICS
            ? VehicleText::tr("Battery %1 (avionics)")
            : battery.function == mavlink::MAV_BATTERY_FUNCTION_PAYLOAD ? VehicleText::tr("Battery %1 (payload)")
                                                                        : VehicleText::tr("Battery %1");
        const QStringList values{withUnit(number(battery.voltage, 1), QStringLiteral("V")),
                                 withUnit(number(battery.current, 1), QStringLiteral("A")),
                                 withUnit(number(battery.percent, 0), QStringLiteral("%"))};
        lines << name.arg(battery.id + 1) + QStringLiteral(": ") + values.join(QStringLiteral(" · "));
    }
    return lines.join(QLatin1Char('\n'));
}

QString severityText(std::uint8_t severity)
{
    switch (severity) {
    case mavlink::MAV_SEVERITY_EMERGENCY: return VehicleText::tr("emergency");
    case mavlink::MAV_SEVERITY_ALERT: return VehicleText::tr("alert");
    case mavlink::MAV_SEVERITY_CRITICAL: return VehicleText::tr("critical");
    case mavlink::MAV_SEVERITY_ERROR: return VehicleText::tr("error");
    case mavlink::MAV_SEVERITY_WARNING: return VehicleText::tr("warning");
    case mavlink::MAV_SEVERITY_NOTICE: return VehicleText::tr("notice");
    case mavlink::MAV_SEVERITY_INFO: return VehicleText::tr("info");
    default: return VehicleText::tr("debug");
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
        Overloaded{
            [](const vehicle::Arm &) { return VehicleText::tr("Arm"); },
            [](const vehicle::Disarm &c) { return c.force ? VehicleText::tr("Emergency stop") : VehicleText::tr("Disarm"); },
            [&](const vehicle::TakeOff &c) { return VehicleText::tr("Take off to %1").arg(altitude(c.altitude)); },
            [](const vehicle::Land &) { return VehicleText::tr("Land"); },
            [](const vehicle::ReturnToLaunch &) { return VehicleText::tr("RTL"); },
            [](const vehicle::SetMode &c) { return VehicleText::tr("Mode %1").arg(fromStd(c.mode)); },
            [](const vehicle::GoTo &) { return VehicleText::tr("Go here"); },
            [&](const vehicle::ChangeAltitude &c) {
                return VehicleText::tr("Change altitude to %1").arg(altitude(c.altitudeRelative));
            },
            [](const vehicle::Loiter &) { return VehicleText::tr("Pause"); },
            [](const vehicle::PointAt &) { return VehicleText::tr("Point camera here"); },
            [](const vehicle::StopPointing &) { return VehicleText::tr("Stop pointing camera"); },
            [](const vehicle::SetHome &) { return VehicleText::tr("Set home here"); },
            [&](const vehicle::ChangeSpeed &c) {
                return VehicleText::tr("Speed %1").arg(speedFigure(c.metresPerSecond, units).text());
            },
            [](const vehicle::SetCurrentMissionItem &c) { return VehicleText::tr("Mission item %1").arg(c.index); },
            [](const vehicle::StartMission &) { return VehicleText::tr("Start mission"); },
            [](const vehicle::Reboot &) { return VehicleText::tr("Restart the autopilot"); },
            [](const vehicle::RawCommand &c) {
                return c.command == mavlink::MAV_CMD_RUN_PREARM_CHECKS ? VehicleText::tr("Pre-arm checks")
                                                                       : VehicleText::tr("Command %1").arg(c.command);
            }},
        command);
}

} // namespace skyseal::ui
