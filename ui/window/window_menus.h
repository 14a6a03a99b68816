// The tables of the window's menus: File, Link, Vehicle, Security, View, Tools, Help. Everything that a panel's button does
// can also be done from here.
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
    QAction *goToAlerts;
    QString version;
    std::function<void()> openSweep;
    std::function<void()> startDemo; ///< empty: there is no demo to start
    std::function<void()> endDemo;
    std::function<bool()> inDemo;
};

std::vector<Menu> windowMenus(const MenuTargets &targets);

} // namespace skyseal::ui
