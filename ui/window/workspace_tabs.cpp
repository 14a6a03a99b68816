#include "ui/window/workspace_tabs.h"

#include "ui/theme/grid.h"
#include "ui/window/workspaces.h"

#include <QtGui/QAction>
#include <QtWidgets/QFrame>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QToolButton>

namespace skyseal::ui {

WorkspaceTabs::WorkspaceTabs(const Workspaces &workspaces, QWidget *parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("workspaceTabs"));
    setAccessibleName(tr("Workspaces"));
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(kHalfGrid, 0, 0, 0);
    row->setSpacing(0);
    for (QAction *action : workspaces.actions()) {
        auto *button = new QToolButton(this);
        button->setDefaultAction(action);
        button->setAutoRaise(true);
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        button->setFocusPolicy(Qt::TabFocus); // a click leaves the focus where the operator works
        button->setAccessibleName(tr("Workspace %1").arg(action->text()));
        // The button takes over the tip of its action whenever that changes.
        const auto showKeys = [action] {
            const QString keys = action->shortcut().toString(QKeySequence::NativeText);
            action->setToolTip(keys.isEmpty() ? tr("Workspace %1").arg(action->text())
                                              : tr("Workspace %1 (%2)").arg(action->text(), keys));
        };
        showKeys();
        connect(action, &QAction::changed, button, showKeys);
        row->addWidget(button);
    }
    auto *line = new QFrame(this);
    line->setFrameShape(QFrame::VLine);
    line->setFrameShadow(QFrame::Plain);
    line->setForegroundRole(QPalette::Mid);
    row->addSpacing(kHalfGrid);
    row->addWidget(line);
}

} // namespace skyseal::ui

#include "moc_workspace_tabs.cpp"
