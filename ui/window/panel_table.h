// The table of the dock panels: one row makes a panel part of the window, with its dock, its entry and key in the View menu
// and its updates.
#pragma once

#include "ui/charts/session_memory.h"

#include <QtCore/QString>

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
    Qt::DockWidgetArea area;
    DockPanel *(*make)(const PanelContext &context, QWidget *parent);
};

/// In the order of the keys Ctrl+1, Ctrl+2 … Panels of one area become tabs; the first one is in front.
std::span<const PanelRow> panelTable();

} // namespace skyseal::ui
