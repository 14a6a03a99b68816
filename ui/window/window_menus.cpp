#include "ui/window/window_menus.h"

#include "core/engine/station/snapshot.h"
#include "ui/flight/confirm_command.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/map/map_view.h"
#include "ui/security/allow_plain.h"
#include "ui/security/suite_actions.h"
#include "ui/text/action_permits.h"
#include "ui/text/command_permits.h"
#include "ui/text/vehicle_text.h"
#include "ui/window/command_palette.h"
#include "ui/window/view_selection.h"
#include "ui/window/window_dialogs.h"
#include "ui/window/window_docks.h"
#include "ui/window/workspaces.h"

#include <QtCore/QCoreApplication>
#include <QtGui/QAction>
#include <QtWidgets/QMainWindow>

namespace skyseal::ui {

namespace {

/// The translation context of this file.
struct WindowMenusText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::WindowMenus)
};

void confirmAndSend(const MenuTargets &on, const QString &question, const vehicle::VehicleCommand &command)
{
    confirmCommand(on.commands, command, question, {}, &on.window);
}

Menu fileMenu(const MenuTargets &on)
{
    return {QStringLiteral("menuFile"),
            WindowMenusText::tr("&File"),
            {{.id = QStringLiteral("actionSettings"),
              .text = WindowMenusText::tr("&Settings…"),
              .trigger = [on] { on.dialogs.openSettings(); },
              .shortcut = Qt::CTRL | Qt::Key_Comma},
             {.id = QStringLiteral("actionShortcuts"),
              .text = WindowMenusText::tr("&Keyboard shortcuts…"),
              .trigger = [on] { on.dialogs.openShortcuts(on.shortcuts); },
              .shortcut = Qt::CTRL | Qt::SHIFT | Qt::Key_F1},
             {.id = QStringLiteral("actionReplay"),
              .text = WindowMenusText::tr("&Replay a log…"),
              .trigger = [on] { on.dialogs.openReplay(); },
              .shortcut = QKeySequence::Open},
             {},
             {.id = QStringLiteral("actionQuit"),
              .text = WindowMenusText::tr("&Quit"),
              .trigger = [on] { on.window.close(); },
              .shortcut = Qt::CTRL | Qt::Key_Q}}};
}

Menu linkMenu(const MenuTargets &on)
{
    return {QStringLiteral("menuLink"),
            WindowMenusText::tr("&Link"),
            {{.id = QStringLiteral("actionConnect"),
              .text = WindowMenusText::tr("&Connect…"),
              .trigger = [on] { on.dialogs.openLink(); },
              .shortcut = Qt::Key_F12}}};
}

MenuItems modeItems(const MenuTargets &on)
{
    MenuItems items;
    if (const auto *vehicle = on.selection.view().vehicle) {
        for (const std::string &mode : vehicle->state.modes)
            items.push_back({.text = fromStd(mode) + QStringLiteral("…"),
                             .trigger =
                                 [on, mode] {
                                     confirmAndSend(on, WindowMenusText::tr("Change the mode to %1?").arg(fromStd(mode)),
                                                    vehicle::SetMode{mode});
                                 },
                             .checked = mode == vehicle->state.mode});
    }
    return items;
}

MenuItems vehicleItems(const MenuTargets &on)
{
    const ViewState &view = on.selection.view();
    MenuItems items;
    if (!view.snapshot)
        return items;
    for (const auto &vehicle : view.snapshot->vehicles) {
        const std::uint8_t id = vehicle.state.systemId;
        items.push_back({.text = WindowMenusText::tr("Vehicle %1").arg(id),
                         .trigger = [on, id] { on.selection.selectVehicle(id); },
                         .checked = view.vehicle && view.vehicle->state.systemId == id});
    }
    return items;
}

/// A mode that the vehicle has: whether it can be changed does not depend on which.
vehicle::SetMode anyMode(const MenuTargets &on)
{
    const auto *vehicle = on.selection.view().vehicle;
    return {vehicle && !vehicle->state.modes.empty() ? vehicle->state.modes.front() : std::string()};
}

Menu vehicleMenu(const MenuTargets &on)
{
    const auto permit = [on](const vehicle::VehicleCommand &order) {
        return [on, order] { return actionDisabledReason(order, on.selection.view()); };
    };
    const auto command = [&](const QString &text, const QString &id, Qt::Key key, const QString &question,
                             const vehicle::VehicleCommand &order) {
        return MenuItem{.id = id,
                        .text = text,
                        .trigger = [on, question, order] { confirmAndSend(on, question, order); },
                        .shortcut = Qt::CTRL | Qt::SHIFT | key,
                        .disabledReason = permit(order)};
    };
    const vehicle::TakeOff takeOff{.altitude = on.commands.takeOffAltitude(), .prepare = true};
    const vehicle::StartMission start{.prepare = true};
    MenuItem arm = command(WindowMenusText::tr("&Arm…"), QStringLiteral("actionArm"), Qt::Key_R,
                           WindowMenusText::tr("Arm the motors? The propellers will turn."), vehicle::Arm{});
    arm.trigger = [on] {
        const QString question = on.commands.armingTakesOff()
            ? WindowMenusText::tr("Arm the motors? In its present mode the vehicle takes off at once.")
            : WindowMenusText::tr("Arm the motors? The propellers will turn.");
        confirmCommand(on.commands, vehicle::Arm{}, question, openItemsText(on.commands), &on.window);
    };
    MenuItem mission = command(WindowMenusText::tr("&Start mission…"), QStringLiteral("actionStartMission"), Qt::Key_S, {},
                               start);
    mission.trigger = [on, start] {
        const bool arms = on.commands.armsFirst(start);
        confirmCommand(on.commands, start,
                       arms ? WindowMenusText::tr("Arm the motors and fly the mission? The propellers will turn.")
                            : WindowMenusText::tr("Fly the mission?"),
                       arms ? openItemsText(on.commands) : QString(), &on.window);
    };
    return {QStringLiteral("menuVehicle"),
            WindowMenusText::tr("&Vehicle"),
            {arm,
             command(WindowMenusText::tr("&Disarm…"), QStringLiteral("actionDisarm"), Qt::Key_D,
                     WindowMenusText::tr("Disarm the motors?"), vehicle::Disarm{}),
             {},
             {.id = QStringLiteral("actionTakeOff"),
              .text = WindowMenusText::tr("&Take off…"),
              .trigger = [on] { on.dialogs.openTakeOff(); },
              .shortcut = Qt::CTRL | Qt::SHIFT | Qt::Key_T,
              .disabledReason = permit(takeOff)},
             command(WindowMenusText::tr("&Land…"), QStringLiteral("actionLand"), Qt::Key_L, WindowMenusText::tr("Land here?"),
                     vehicle::Land{}),
             command(WindowMenusText::tr("&Return to launch (RTL)…"), QStringLiteral("actionReturn"), Qt::Key_H,
                     WindowMenusText::tr("Return to launch and land there?"), vehicle::ReturnToLaunch{}),
             command(WindowMenusText::tr("&Pause…"), QStringLiteral("actionPause"), Qt::Key_P,
                     WindowMenusText::tr("Stop and hold the present position?"), vehicle::Loiter{}),
             {.id = QStringLiteral("actionChangeAltitude"),
              .text = WindowMenusText::tr("&Change altitude…"),
              .trigger = [on] { on.dialogs.openChangeAltitude(on.selection.view()); },
              .shortcut = Qt::CTRL | Qt::SHIFT | Qt::Key_G,
              .disabledReason = permit(vehicle::ChangeAltitude{.altitudeRelative = 0, .changeMode = true})},
             mission,
             {},
             {.id = QStringLiteral("menuMode"),
              .text = WindowMenusText::tr("&Mode"),
              .disabledReason = [on] { return actionDisabledReason(anyMode(on), on.selection.view()); },
              .submenu = [on] { return modeItems(on); }},
             {},
             {.id = QStringLiteral("menuChooseVehicle"),
              .text = WindowMenusText::tr("S&how"),
              .disabledReason = [on] { return on.selection.view().vehicle ? QString() : WindowMenusText::tr("No vehicle"); },
              .submenu = [on] { return vehicleItems(on); }}}};
}

MenuItems plainItems(const MenuTargets &on)
{
    MenuItems items;
    if (const auto &snapshot = on.selection.view().snapshot) {
        for (const engine::PendingVehicle &pending : snapshot->pendingApproval)
            items.push_back(
                {.text = WindowMenusText::tr("Vehicle %1 at %2…").arg(pending.systemId).arg(fromStd(pending.remoteAddress)),
                 .trigger = [on, pending] { askAllowPlain(on.station, pending, &on.window); }});
    }
    return items;
}

Menu securityMenu(const MenuTargets &on)
{
    MenuItems items{{.text = WindowMenusText::tr("Cipher suite")}};
    for (QAction *action : on.suites.actions())
        items.push_back({.action = action});
    items.push_back({});
    items.push_back({.action = on.suites.changeKeysAction()});
    items.push_back({.id = QStringLiteral("menuAllowPlain"),
                     .text = WindowMenusText::tr("Allow &plain MAVLink"),
                     .disabledReason =
                         [on] {
                             const auto &snapshot = on.selection.view().snapshot;
                             const bool any = snapshot && !snapshot->pendingApproval.empty();
                             return any ? QString() : WindowMenusText::tr("No vehicle is waiting for approval");
                         },
                     .submenu = [on] { return plainItems(on); }});
    items.push_back({.id = QStringLiteral("actionKeys"),
                     .text = WindowMenusText::tr("&Keys and peers…"),
                     .trigger = [on] { on.dialogs.openKeys(); },
                     .shortcut = Qt::CTRL | Qt::Key_P});
    return {QStringLiteral("menuSecurity"), WindowMenusText::tr("&Security"), std::move(items)};
}

MenuItems trackColorItems(WindowDialogs &dialogs)
{
    const std::pair<TrackColors, QString> all[] = {{TrackColors::Suite, WindowMenusText::tr("&Cipher suite")},
                                                   {TrackColors::LinkQuality, WindowMenusText::tr("Link &quality")},
                                                   {TrackColors::Altitude, WindowMenusText::tr("&Altitude")},
                                                   {TrackColors::Speed, WindowMenusText::tr("&Speed")}};
    MenuItems items;
    for (const auto &[colors, text] : all)
        items.push_back({.id = QStringLiteral("trackColors%1").arg(static_cast<int>(colors)),
                         .text = text,
                         .trigger = [&dialogs, chosen = colors] { dialogs.setTrackColors(chosen); },
                         .checked = dialogs.trackColors() == colors});
    return items;
}

Menu viewMenu(const MenuTargets &on)
{
    MenuItems items;
    for (QAction *action : on.workspaces.actions())
        items.push_back({.action = action});
    items.push_back({});
    for (QAction *action : on.docks.viewActions())
        items.push_back({.action = action});
    const auto reset = [on] { on.workspaces.reset(); };
    const QKeySequence resets = Qt::ALT | Qt::SHIFT | Qt::Key_R;
    const MenuItems others{{},
                           {.id = QStringLiteral("actionFollow"),
                            .text = WindowMenusText::tr("&Follow the vehicle"),
                            .trigger = [on] { on.map.followVehicle(); },
                            .shortcut = Qt::CTRL | Qt::Key_Home},
                           {.action = on.map.rotation().action()},
                           {.action = on.goToAlerts},
                           {.id = QStringLiteral("actionZoomIn"),
                            .text = WindowMenusText::tr("Zoom &in"),
                            .trigger = [on] { on.map.zoomBy(1.5); },
                            .shortcut = QKeySequence::ZoomIn,
                            .repeats = true},
                           {.id = QStringLiteral("actionZoomOut"),
                            .text = WindowMenusText::tr("Zoom &out"),
                            .trigger = [on] { on.map.zoomBy(1 / 1.5); },
                            .shortcut = QKeySequence::ZoomOut,
                            .repeats = true},
                           {.action = on.map.measure().action()},
                           {.id = QStringLiteral("actionEditValues"),
                            .text = WindowMenusText::tr("&Edit values…"),
                            .trigger = [on] { on.dialogs.openValues(); },
                            .shortcut = Qt::CTRL | Qt::Key_E},
                           {.id = QStringLiteral("menuTrackColors"),
                            .text = WindowMenusText::tr("&Track colours"),
                            .submenu = [on] { return trackColorItems(on.dialogs); }},
                           {.id = QStringLiteral("actionClearTrack"),
                            .text = WindowMenusText::tr("&Clear the track"),
                            .trigger = [on] { on.map.clearTrack(); },
                            .shortcut = Qt::CTRL | Qt::SHIFT | Qt::Key_X},
                           {.id = QStringLiteral("actionMapSource"),
                            .text = WindowMenusText::tr("&Map source…"),
                            .trigger = [on] { on.dialogs.openMapSource(); },
                            .shortcut = Qt::CTRL | Qt::Key_M},
                           {.id = QStringLiteral("actionOverlays"),
                            .text = WindowMenusText::tr("O&verlays…"),
                            .trigger = [on] { on.dialogs.openOverlays(on.map); },
                            .shortcut = Qt::CTRL | Qt::SHIFT | Qt::Key_O},
                           {.id = QStringLiteral("actionFetchArea"),
                            .text = WindowMenusText::tr("Fetch the &area in view…"),
                            .trigger = [on] { on.dialogs.openRegion(on.map); },
                            .shortcut = Qt::CTRL | Qt::SHIFT | Qt::Key_F},
                           {},
                           {.id = QStringLiteral("actionResetView"),
                            .text = WindowMenusText::tr("&Reset the layout"),
                            .trigger = reset,
                            .shortcut = resets},
                           {.id = QStringLiteral("actionFullScreen"),
                            .text = WindowMenusText::tr("F&ull screen"),
                            .trigger = [on] { on.window.setWindowState(on.window.windowState() ^ Qt::WindowFullScreen); },
                            .shortcut = Qt::Key_F11,
                            .checked = false}};
    items.insert(items.end(), others.begin(), others.end());
    return {QStringLiteral("menuView"), WindowMenusText::tr("V&iew"), std::move(items)};
}

Menu toolsMenu(const MenuTargets &on)
{
    MenuItems items{{.id = QStringLiteral("actionPalette"),
                     .text = WindowMenusText::tr("&Find a command…"),
                     .trigger = [on] { CommandPalette::open(on.window, on.actions); },
                     .shortcut = Qt::CTRL | Qt::Key_K},
                    {},
                    {.id = QStringLiteral("actionSweep"),
                     .text = WindowMenusText::tr("Run a s&weep…"),
                     .trigger = on.openSweep,
                     .shortcut = Qt::CTRL | Qt::Key_R}};
    if (on.startDemo) {
        items.push_back({.id = QStringLiteral("actionDemo"),
                         .text = WindowMenusText::tr("Start the &demo"),
                         .trigger = on.startDemo,
                         .shortcut = Qt::CTRL | Qt::Key_D,
                         .disabledReason = [on] {
                             return on.inDemo() ? WindowMenusText::tr("The demo is running")
                                                : demoDisabledReason(on.selection.view());
                         }});
        items.push_back(
            {.id = QStringLiteral("actionEndDemo"),
             .text = WindowMenusText::tr("&End the demo"),
             .trigger = on.endDemo,
             .shortcut = Qt::ALT | Qt::SHIFT | Qt::Key_E,
             .disabledReason = [on] { return on.inDemo() ? QString() : WindowMenusText::tr("No demo is running"); }});
    }
    return {QStringLiteral("menuTools"), WindowMenusText::tr("&Tools"), std::move(items)};
}

Menu helpMenu(const MenuTargets &on)
{
    const auto page = [&on](const char *id, const QString &text, const char *name, const QKeySequence &keys) {
        return MenuItem{.id = QLatin1String(id),
                        .text = text,
                        .trigger = [on, name] { on.dialogs.openHelp(QLatin1String(name)); },
                        .shortcut = keys};
    };
    return {QStringLiteral("menuHelp"),
            WindowMenusText::tr("&Help"),
            {page("actionHelp", WindowMenusText::tr("&First steps"), "start", QKeySequence::HelpContents),
             {},
             page("actionHelpFly", WindowMenusText::tr("&Fly workspace"), "fly", Qt::ALT | Qt::SHIFT | Qt::Key_F),
             page("actionHelpPlan", WindowMenusText::tr("&Plan workspace"), "plan", Qt::ALT | Qt::SHIFT | Qt::Key_P),
             page("actionHelpVehicle", WindowMenusText::tr("Ve&hicle workspace"), "vehicle", Qt::ALT | Qt::SHIFT | Qt::Key_V),
             page("actionHelpLab", WindowMenusText::tr("&Lab workspace"), "lab", Qt::ALT | Qt::SHIFT | Qt::Key_L),
             {},
             page("actionHelpSealing", WindowMenusText::tr("&Sealing a link"), "sealing", Qt::ALT | Qt::SHIFT | Qt::Key_S),
             page("actionHelpMap", WindowMenusText::tr("The &map"), "map", Qt::ALT | Qt::SHIFT | Qt::Key_M),
             page("actionHelpValues", WindowMenusText::tr("&Values"), "values", Qt::ALT | Qt::SHIFT | Qt::Key_U),
             page("actionHelpDiagnostics", WindowMenusText::tr("&Diagnostics"), "diagnostics", Qt::ALT | Qt::SHIFT | Qt::Key_D),
             {},
             {.id = QStringLiteral("actionAbout"),
              .text = WindowMenusText::tr("&About Skyseal"),
              .trigger = [on] { on.dialogs.openAbout(on.version); },
              .shortcut = Qt::ALT | Qt::SHIFT | Qt::Key_B}}};
}

} // namespace

std::vector<Menu> windowMenus(const MenuTargets &targets)
{
    return {fileMenu(targets), linkMenu(targets),  vehicleMenu(targets), securityMenu(targets),
            viewMenu(targets), toolsMenu(targets), helpMenu(targets)};
}

} // namespace skyseal::ui
