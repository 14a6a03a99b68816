// The table of the dock panels: one row makes a panel part of the window, with its dock, its entry and key in the View menu
// and its updates.
#pragma once

#include "ui/charts/session_memory.h"
#include "ui/window/workspace_table.h"

#include <QtCore/QString>

#include <array>
#include <span>

class QWidget;

namespace skyseal::ui {

class DockPanel;
class StationInterface;
class SuiteActions;
class VehicleCommands;
class ViewSelection;
class WindowDialogs;

/// The objects that panels work with and send their requests to. All must outlive the window.
struct PanelContext
{
    StationInterface &station;
    VehicleCommands &commands;
    SuiteActions &suites;
    ViewSelection &selection;
    WindowDialogs &dialogs;
    QString recordFolder;                ///< folder of the recordings
    SessionMemory::Measure sessionBytes; ///< heap of a session under a suite, for the diagnostics
};

struct PanelRow
{
    const char *id;    ///< object name of the dock; saved arrangements refer to it
    const char *title; ///< in the translation context skyseal::ui::WindowDocks
    /// Where each workspace shows it at first. Panels of one area become tabs, the first one in front. Where it is hidden
    /// (NoDockWidgetArea), it appears at the place that it has in the first workspace that shows it.
    std::array<Qt::DockWidgetArea, kWorkspaces> places;
    DockPanel *(*make)(const PanelContext &context, QWidget *parent);
};

/// The area of a panel in a workspace, also where the workspace hides it.
Qt::DockWidgetArea areaIn(const PanelRow &row, Workspace workspace);

/// In the order of the keys Alt+1 … Alt+9, Alt+0, Alt+-.
std::span<const PanelRow> panelTable();

} // namespace skyseal::ui
