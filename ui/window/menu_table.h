// Menus as tables of values. The tables are made in window_menus; addMenus() makes the menu bar from them, so that names,
// shortcuts and reasons for disabled entries are handled in one place.
#pragma once

#include <QtCore/QString>
#include <QtGui/QKeySequence>

#include <functional>
#include <optional>
#include <vector>

class QAction;
class QMenu;
class QMenuBar;

namespace skyseal::ui {

struct MenuItem;
using MenuItems = std::vector<MenuItem>;

/// One line of a menu. An item with neither id, text nor action is a separator; one with a text alone is a section title.
struct MenuItem
{
    QString id = {};                              ///< object name of the action, or of the submenu
    QString text = {};                            ///< with its mnemonic
    std::function<void()> trigger = {};           ///< called when the item is chosen
    QKeySequence shortcut = {};                   ///< active in the whole window
    std::function<QString()> disabledReason = {}; ///< the reason shown in tips, empty if enabled; nothing is triggered with one
    std::optional<bool> checked = {};             ///< set: the item is checkable
    bool repeats = false;                         ///< again and again while its shortcut is held
    std::function<MenuItems()> submenu =
        {};                    ///< set: a submenu, filled each time it opens; its checkable items exclude each other
    QAction *action = nullptr; ///< set: this existing action is shown; the other fields are unused, but for `repeats`
};

struct Menu
{
    QString id; ///< object name
    QString title;
    MenuItems items;
};

/// Adds `items` to `menu`, which owns everything that is made. Objects that the functions of the items use must outlive it.
/// Returns a function that enables or disables the items anew, as the opening of the menu does; valid while `menu` exists.
std::function<void()> fillMenu(QMenu &menu, const MenuItems &items);

/// Adds `menus` to `bar`, which owns everything that is made. Objects that the functions of the items use must outlive it.
/// Returns a function that enables or disables the items anew, as the opening of their menu does, for their shortcuts; valid
/// while `bar` exists.
std::function<void()> addMenus(QMenuBar &bar, const std::vector<Menu> &menus);

} // namespace skyseal::ui
