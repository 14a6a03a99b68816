#include "ui/window/panel_table.h"

#include "ui/charts/diagnostics_panel.h"
#include "ui/flight/flight_panel.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/inspector/inspector_panel.h"
#include "ui/links/links_panel.h"
#include "ui/logs/logs_panel.h"
#include "ui/map/profile_panel.h"
#include "ui/messages/messages_panel.h"
#include "ui/mission/mission_panel.h"
#include "ui/parameters/parameters_panel.h"
#include "ui/security/secure_link_panel.h"
#include "ui/vehicles/vehicles_panel.h"
#include "ui/window/view_selection.h"
#include "ui/window/window_dialogs.h"

#include <algorithm>

namespace skyseal::ui {

namespace {

DockPanel *makeFlight(const PanelContext &context, QWidget *parent)
{
    auto *panel = new FlightPanel(context.station, parent);
    QObject::connect(panel, &FlightPanel::editValuesRequested, &context.dialogs, &WindowDialogs::openValues);
    return panel;
}

DockPanel *makeSecureLink(const PanelContext &context, QWidget *parent)
{
    auto *panel = new SecureLinkPanel(context.suites, parent);
    QObject::connect(panel, &SecureLinkPanel::helpRequested, &context.dialogs, &WindowDialogs::openHelp);
    QObject::connect(panel, &SecureLinkPanel::keysRequested, &context.dialogs, &WindowDialogs::openKeys);
    QObject::connect(panel, &SecureLinkPanel::sessionChosen, &context.selection, &ViewSelection::selectSession);
    return panel;
}

DockPanel *makeDiagnostics(const PanelContext &context, QWidget *parent)
{
    auto *panel = new DiagnosticsPanel(parent);
    panel->setSessionMeasure(context.sessionBytes);
    return panel;
}

DockPanel *makeMessages(const PanelContext &context, QWidget *parent)
{
    auto *panel = new MessagesPanel(parent);
    QObject::connect(&context.station, &StationInterface::eventOccurred, panel, &MessagesPanel::handleEvent);
    QObject::connect(&context.station, &StationInterface::replayEventOccurred, panel, &MessagesPanel::handleReplayEvent);
    QObject::connect(&context.commands, &VehicleCommands::resultReported, panel, &MessagesPanel::showCommandResult);
    return panel;
}

DockPanel *makeLogs(const PanelContext &context, QWidget *parent)
{
    auto *panel = new LogsPanel(context.station, context.recordFolder, parent);
    QObject::connect(panel, &LogsPanel::replayRequested, &context.dialogs, &WindowDialogs::openReplay);
    return panel;
}

DockPanel *makeLinks(const PanelContext &context, QWidget *parent)
{
    auto *panel = new LinksPanel(context.station, parent);
    QObject::connect(panel, &LinksPanel::addRequested, &context.dialogs, &WindowDialogs::openLink);
    return panel;
}

DockPanel *makeProfile(const PanelContext &, QWidget *parent)
{
    return new ProfilePanel(parent);
}

DockPanel *makeVehicles(const PanelContext &context, QWidget *parent)
{
    auto *panel = new VehiclesPanel(context.station, parent);
    QObject::connect(panel, &VehiclesPanel::vehicleChosen, &context.selection, &ViewSelection::selectVehicle);
    QObject::connect(panel, &VehiclesPanel::connectRequested, &context.dialogs, &WindowDialogs::openLink);
    return panel;
}

template<typename Panel> DockPanel *make(const PanelContext &context, QWidget *parent)
{
    return new Panel(context.station, parent);
}

constexpr auto kLeft = Qt::LeftDockWidgetArea, kRight = Qt::RightDockWidgetArea, kBottom = Qt::BottomDockWidgetArea,
               kHidden = Qt::NoDockWidgetArea;

// clang-format off
constexpr PanelRow kPanels[] = {
    //Fly     Plan     Vehicle  Lab
    {"dockFlight", QT_TRANSLATE_NOOP("skyseal::ui::WindowDocks", "Flight"),
     {kLeft,   kHidden, kHidden, kHidden}, makeFlight},
    {"dockSecure", QT_TRANSLATE_NOOP("skyseal::ui::WindowDocks", "Secure link"),
     {kHidden, kHidden, kHidden, kRight}, makeSecureLink},
    {"dockDiagnostics", QT_TRANSLATE_NOOP("skyseal::ui::WindowDocks", "Diagnostics"),
     {kHidden, kHidden, kHidden, kBottom}, makeDiagnostics},
    {"dockMessages", QT_TRANSLATE_NOOP("skyseal::ui::WindowDocks", "Messages"),
     {kHidden, kHidden, kBottom, kBottom}, makeMessages},
    {"dockParameters", QT_TRANSLATE_NOOP("skyseal::ui::WindowDocks", "Parameters"),
     {kHidden, kHidden, kRight,  kHidden}, make<ParametersPanel>},
    {"dockInspector", QT_TRANSLATE_NOOP("skyseal::ui::WindowDocks", "Inspector"),
     {kHidden, kHidden, kRight,  kBottom}, make<InspectorPanel>},
    {"dockMission", QT_TRANSLATE_NOOP("skyseal::ui::WindowDocks", "Mission"),
     {kHidden, kRight,  kHidden, kHidden}, make<MissionPanel>},
    {"dockProfile", QT_TRANSLATE_NOOP("skyseal::ui::WindowDocks", "Altitude profile"),
     {kHidden, kBottom, kHidden, kHidden}, makeProfile},
    {"dockLogs", QT_TRANSLATE_NOOP("skyseal::ui::WindowDocks", "Logs"),
     {kHidden, kHidden, kBottom, kBottom}, makeLogs},
    {"dockLinks", QT_TRANSLATE_NOOP("skyseal::ui::WindowDocks", "Links"),
     {kHidden, kHidden, kBottom, kBottom}, makeLinks},
    {"dockVehicles", QT_TRANSLATE_NOOP("skyseal::ui::WindowDocks", "Vehicles"),
     {kHidden, kHidden, kBottom, kHidden}, makeVehicles},
};
// clang-format on

} // namespace

std::span<const PanelRow> panelTable()
{
    return kPanels;
}

Qt::DockWidgetArea areaIn(const PanelRow &row, Workspace workspace)
{
    const Qt::DockWidgetArea place = row.places[static_cast<std::size_t>(workspace)];
    return place != kHidden ? place : *std::ranges::find_if(row.places, [](auto area) { return area != kHidden; });
}

} // namespace skyseal::ui
