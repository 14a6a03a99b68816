#include "ui/window/window_actions.h"

#include "ui/control_action.h"
#include "ui/shortcuts/shortcuts.h"

#include <QtWidgets/QWidget>

#include <algorithm>

namespace skyseal::ui {

WindowActions::WindowActions(QWidget &window, Shortcuts &shortcuts) : QObject(&window), m_window(window), m_shortcuts(shortcuts)
{}

void WindowActions::add(const QString &title, const QList<QAction *> &actions)
{
    addPassing(title, actions);
    QList<QAction *> taken;
    for (const auto &action : m_groups.back().actions) {
        m_window.addAction(action); // also while its panel is hidden
        taken << action;
    }
    m_shortcuts.take(title, taken);
}

void WindowActions::addPassing(const QString &title, const QList<QAction *> &actions)
{
    Group group{title, {}};
    for (QAction *action : actions)
        if (!action->objectName().isEmpty())
            group.actions << action;
    m_groups.push_back(group);
    groups();
}

const std::vector<WindowActions::Group> &WindowActions::groups()
{
    for (const Group &group : m_groups)
        for (const auto &action : group.actions)
            if (auto *control = qobject_cast<ControlAction *>(action.data()))
                control->refresh();
    return m_groups;
}

} // namespace skyseal::ui

#include "moc_window_actions.cpp"
