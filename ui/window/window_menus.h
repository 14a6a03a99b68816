// The tables of the window's menus: File, Link, Vehicle, Security, View, Tools, Help. Actions of one panel are not in a
// menu: the palette finds them among WindowActions.
#pragma once

#include "ui/window/menu_table.h"

class QAction;
class QMainWindow;

namespace skyseal::ui {

class MapView;
class Shortcuts;
class StationInterface;
class SuiteActions;
class VehicleCommands;
class ViewSelection;
class WindowActions;
class WindowDialogs;
class WindowDocks;
class Workspaces;

/// The parts of the window that the menus act on. All must outlive the menu bar.
struct MenuTargets
{
    QMainWindow &window;
    StationInterface &station;
    ViewSelection &selection;
    VehicleCommands &commands;
    SuiteActions &suites;
    WindowDialogs &dialogs;
    WindowDocks &docks;
    Workspaces &workspaces;
    MapView &map;
    Shortcuts &shortcuts;
    WindowActions &actions; ///< those in no menu, for the palette
    QAction *goToAlerts;
    QString version;
    std::function<void()> openSweep;
    std::function<void()> startDemo = {}; ///< empty: there is no demo to start
    std::function<void()> endDemo = {};
    std::function<bool()> inDemo = {};
};

std::vector<Menu> windowMenus(const MenuTargets &targets);

} // namespace skyseal::ui
