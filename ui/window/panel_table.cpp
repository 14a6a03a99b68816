#include "ui/window/panel_table.h"

#include "ui/charts/diagnostics_panel.h"
#include "ui/flight/flight_panel.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/inspector/inspector_panel.h"
#include "ui/links/links_panel.h"
#include "ui/logs/logs_panel.h"
#include "ui/messages/messages_panel.h"
#include "ui/mission/mission_panel.h"
#include "ui/parameters/parameters_panel.h"
#include "ui/security/secure_link_panel.h"
#include "ui/window/view_selection.h"
#include "ui/window/window_dialogs.h"

namespace skyseal::ui {

namespace {

DockPanel *makeFlight(const PanelContext &context, QWidget *parent)
{
    return new FlightPanel(context.commands, parent);
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

template<typename Panel> DockPanel *make(const PanelContext &context, QWidget *parent)
{
    return new Panel(context.station, parent);
}

constexpr PanelRow kPanels[] = {
    {"dockFlight", QT_TRANSLATE_NOOP("skyseal::ui::WindowDocks", "Flight"), Qt::LeftDockWidgetArea, makeFlight},
    {"dockSecure", QT_TRANSLATE_NOOP("skyseal::ui::WindowDocks", "Secure link"), Qt::RightDockWidgetArea, makeSecureLink},
    {"dockDiagnostics", QT_TRANSLATE_NOOP("skyseal::ui::WindowDocks", "Diagnostics"), Qt::BottomDockWidgetArea,
     makeDiagnostics},
    {"dockMessages", QT_TRANSLATE_NOOP("skyseal::ui::WindowDocks", "Messages"), Qt::BottomDockWidgetArea, makeMessages},
    {"dockInspector", QT_TRANSLATE_NOOP("skyseal::ui::WindowDocks", "Inspector"), Qt::BottomDockWidgetArea,
     make<InspectorPanel>},
    {"dockParameters", QT_TRANSLATE_NOOP("skyseal::ui::WindowDocks", "Parameters"), Qt::BottomDockWidgetArea,
     make<ParametersPanel>},
    {"dockMission", QT_TRANSLATE_NOOP("skyseal::ui::WindowDocks", "Mission"), Qt::BottomDockWidgetArea, make<MissionPanel>},
    {"dockLogs", QT_TRANSLATE_NOOP("skyseal::ui::WindowDocks", "Logs"), Qt::BottomDockWidgetArea, makeLogs},
    {"dockLinks", QT_TRANSLATE_NOOP("skyseal::ui::WindowDocks", "Links"), Qt::BottomDockWidgetArea, makeLinks},
};

} // namespace

std::span<const PanelRow> panelTable()
{
    return kPanels;
}

} // namespace skyseal::ui
