#include "ui/window/menu_table.h"

#include "ui/window/type_ahead.h"

#include <QtGui/QAction>
#include <QtGui/QActionGroup>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>

#include <algorithm>
#include <utility>

namespace skyseal::ui {

namespace {

using Refresh = std::function<void()>;

std::vector<Refresh> addItems(QMenu &menu, const MenuItems &items);

QAction *addSubmenu(QMenu &menu, const MenuItem &item)
{
    QMenu *submenu = menu.addMenu(item.text);
    submenu->setObjectName(item.id);
    new TypeAhead(*submenu);
    auto *choices = new QActionGroup(submenu); // one of the checkable items: shown with radio buttons
    QObject::connect(submenu, &QMenu::aboutToShow, submenu, [submenu, choices, items = item.submenu] {
        submenu->clear();
        addItems(*submenu, items());
        for (QAction *action : submenu->actions())
            if (action->isCheckable())
                choices->addAction(action);
    });
    return submenu->menuAction();
}

QAction *addAction(QMenu &menu, const MenuItem &item)
{
    auto *action = menu.addAction(item.text);
    action->setObjectName(item.id);
    action->setShortcut(item.shortcut);
    action->setCheckable(item.checked.has_value());
    action->setChecked(item.checked.value_or(false));
    QObject::connect(action, &QAction::triggered, &menu, [trigger = item.trigger, reason = item.disabledReason] {
        if (!reason || reason().isEmpty()) // one may have come since the menu was opened
            trigger();
    });
    return action;
}

/// Enables `action` unless there is a reason against it, which becomes its tip.
Refresh refreshOf(QAction *action, const std::function<QString()> &disabledReason)
{
    return [action, disabledReason] {
        const QString reason = disabledReason();
        action->setEnabled(reason.isEmpty());
        action->setToolTip(reason); // empty: QAction shows its text
        action->setStatusTip(reason);
    };
}

/// Returns what is done when the menu opens.
std::vector<Refresh> addItems(QMenu &menu, const MenuItems &items)
{
    std::vector<Refresh> refreshes;
    for (const MenuItem &item : items) {
        if (!item.action && item.id.isEmpty() && item.text.isEmpty()) {
            menu.addSeparator();
            continue;
        }
        if (!item.action && item.id.isEmpty() && !item.trigger) {
            menu.addSection(item.text);
            continue;
        }
        QAction *action = item.action ? item.action : item.submenu ? addSubmenu(menu, item) : addAction(menu, item);
        if (item.action)
            menu.addAction(action);
        action->setAutoRepeat(item.repeats); // a key that is held commands once
        if (item.disabledReason && !item.action) {
            refreshes.push_back(refreshOf(action, item.disabledReason));
            QObject::connect(&menu, &QMenu::aboutToShow, action, refreshes.back());
        }
    }
    return refreshes;
}

Refresh asOne(std::vector<Refresh> refreshes)
{
    return [all = std::move(refreshes)] {
        for (const Refresh &refresh : all)
            refresh();
    };
}

std::vector<Refresh> fill(QMenu &menu, const MenuItems &items)
{
    menu.setToolTipsVisible(std::ranges::any_of(items, [](const MenuItem &item) { return !!item.disabledReason; }));
    return addItems(menu, items);
}

} // namespace

std::function<void()> fillMenu(QMenu &menu, const MenuItems &items)
{
    return asOne(fill(menu, items));
}

std::function<void()> addMenus(QMenuBar &bar, const std::vector<Menu> &menus)
{
    std::vector<Refresh> all;
    for (const Menu &table : menus) {
        QMenu *menu = bar.addMenu(table.title);
        menu->setObjectName(table.id);
        for (Refresh &refresh : fill(*menu, table.items))
            all.push_back(std::move(refresh));
    }
    return asOne(std::move(all));
}

} // namespace skyseal::ui
