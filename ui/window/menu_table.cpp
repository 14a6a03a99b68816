#include "ui/window/menu_table.h"

#include <QtGui/QAction>
#include <QtGui/QActionGroup>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>

#include <algorithm>

namespace skyseal::ui {

namespace {

void addItems(QMenu &menu, const MenuItems &items);

QAction *addSubmenu(QMenu &menu, const MenuItem &item)
{
    QMenu *submenu = menu.addMenu(item.text);
    submenu->setObjectName(item.id);
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
    QObject::connect(action, &QAction::triggered, &menu, [trigger = item.trigger] { trigger(); });
    return action;
}

void addItems(QMenu &menu, const MenuItems &items)
{
    for (const MenuItem &item : items) {
        if (item.action)
            menu.addAction(item.action);
        else if (item.id.isEmpty() && item.text.isEmpty())
            menu.addSeparator();
        else if (item.id.isEmpty() && !item.trigger)
            menu.addSection(item.text);
        else {
            QAction *action = item.submenu ? addSubmenu(menu, item) : addAction(menu, item);
            if (item.disabledReason)
                QObject::connect(&menu, &QMenu::aboutToShow, action, [action, disabledReason = item.disabledReason] {
                    const QString reason = disabledReason();
                    action->setEnabled(reason.isEmpty());
                    action->setToolTip(reason); // empty: QAction shows its text
                    action->setStatusTip(reason);
                });
        }
    }
}

} // namespace

void fillMenu(QMenu &menu, const MenuItems &items)
{
    menu.setToolTipsVisible(std::ranges::any_of(items, [](const MenuItem &item) { return !!item.disabledReason; }));
    addItems(menu, items);
}

void addMenus(QMenuBar &bar, const std::vector<Menu> &menus)
{
    for (const Menu &table : menus) {
        QMenu *menu = bar.addMenu(table.title);
        menu->setObjectName(table.id);
        fillMenu(*menu, table.items);
    }
}

} // namespace skyseal::ui
