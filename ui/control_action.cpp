#include "ui/control_action.h"

#include "ui/command_guard.h"

#include <QtCore/QEvent>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QScrollArea>

#include <utility>

namespace skyseal::ui {

namespace {

template<typename W> W *around(const QWidget &widget)
{
    for (QWidget *at = widget.parentWidget(); at; at = at->parentWidget())
        if (auto *found = qobject_cast<W *>(at))
            return found;
    return nullptr;
}

void reveal(QWidget &control)
{
    if (auto *dock = around<QDockWidget>(control)) {
        dock->show();
        dock->raise();
    }
    if (auto *scroll = around<QScrollArea>(control))
        scroll->ensureWidgetVisible(&control);
}

} // namespace

ControlAction::ControlAction(QWidget &control, const QString &id, const QString &text, const QKeySequence &keys,
                             std::function<void()> act)
    : QAction(text, &control), m_control(control), m_act(std::move(act))
{
    setObjectName(id);
    setShortcut(keys);
    setAutoRepeat(false); // a key that is held commands once
    control.installEventFilter(this);
    connect(this, &QAction::triggered, this, &ControlAction::perform);
    refresh();
}

bool ControlAction::isShown() const
{
    const auto *dock = around<QDockWidget>(m_control);
    return dock ? m_control.isVisibleTo(dock) : m_control.isVisible();
}

void ControlAction::refresh()
{
    if (m_button && text() != m_button->accessibleName())
        setText(m_button->accessibleName());
    const bool possible = m_control.isEnabled();
    const QString reason = possible ? QString() : m_control.toolTip();
    setVisible(isShown());
    setEnabled(possible);
    setToolTip(reason); // empty: QAction shows its text
    setStatusTip(reason);
}

void ControlAction::perform()
{
    if (m_control.isEnabled() && isShown()) {
        reveal(m_control);
        m_act();
    }
    if (m_button && isCheckable())
        setChecked(m_button->isChecked()); // QAction has toggled itself
}

bool ControlAction::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::EnabledChange:
    case QEvent::ToolTipChange:
    case QEvent::Show:
    case QEvent::Hide:
    case QEvent::ShowToParent:
    case QEvent::HideToParent: refresh(); break;
    default: break;
    }
    return QAction::eventFilter(watched, event);
}

QAction *pressAction(QAbstractButton &button, const QKeySequence &keys)
{
    auto *action = new ControlAction(button, QStringLiteral("press_") + button.objectName(), button.accessibleName(), keys,
                                     [&button] { button.click(); });
    action->m_button = &button;
    if (button.isCheckable()) {
        action->setCheckable(true);
        action->setChecked(button.isChecked());
        QObject::connect(&button, &QAbstractButton::toggled, action, &QAction::setChecked);
    }
    return action;
}

QAction *focusAction(QWidget &control, const QString &text, const QKeySequence &keys)
{
    return new ControlAction(control, QStringLiteral("focus_") + control.objectName(), text, keys, [&control] {
        if (auto *guard = control.findChild<CommandGuard *>(QString(), Qt::FindDirectChildrenOnly))
            guard->noteChoice();
        control.activateWindow(); // a dock may float
        control.setFocus(Qt::ShortcutFocusReason);
    });
}

} // namespace skyseal::ui

#include "moc_control_action.cpp"
