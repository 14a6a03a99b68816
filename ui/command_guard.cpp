#include "ui/command_guard.h"

#include "ui/held_keys.h"

#include <QtGui/QKeyEvent>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QApplication>
#include <QtWidgets/QMainWindow>

namespace skyseal::ui {

CommandGuard::CommandGuard(QWidget &control) : QObject(&control), m_control(control)
{
    HeldKeys::ofProgram(); // from now on, so that it knows the keys that are down when the control gets the focus
    control.installEventFilter(this);
    if (const auto *button = qobject_cast<QAbstractButton *>(&control))
        connect(button, &QAbstractButton::clicked, this, &CommandGuard::noteCommand);
}

void CommandGuard::noteCommand()
{
    m_quiet.setRemainingTime(kQuietMs);
}

bool CommandGuard::isDeliberate(Qt::FocusReason reason) const
{
    switch (reason) {
    case Qt::TabFocusReason:
    case Qt::BacktabFocusReason: {
        // Also the reason that Qt gives when it moves the focus away from a widget that cannot have it any more.
        const QWidget *left = HeldKeys::ofProgram().focusLeft();
        return left && left->isVisible() && left->isEnabled();
    }
    case Qt::ActiveWindowFocusReason: return !m_lapsed; // else it was chosen while another window was active
    default: return true; // a click, a shortcut, the end of a menu over the control, a call of this program
    }
}

void CommandGuard::handFocusOn() const
{
    QWidget *window = m_control.window();
    const auto *main = qobject_cast<const QMainWindow *>(window);
    QWidget *rest = main && main->centralWidget() ? main->centralWidget() : window;
    rest->setFocus(Qt::OtherFocusReason);
    if (m_control.hasFocus())
        m_control.clearFocus();
}

bool CommandGuard::eventFilter(QObject *, QEvent *event)
{
    switch (event->type()) {
    case QEvent::FocusIn:
        if (!isDeliberate(static_cast<const QFocusEvent *>(event)->reason()))
            handFocusOn();
        m_lapsed = false;
        return false;
    case QEvent::FocusOut:
        // Between two windows there may be none that is active, for a moment.
        m_lapsed = static_cast<const QFocusEvent *>(event)->reason() == Qt::ActiveWindowFocusReason
            && QApplication::activeWindow();
        return false;
    case QEvent::KeyPress: {
        const auto &press = *static_cast<const QKeyEvent *>(event);
        return HeldKeys::isPressKey(press.key()) && (isQuiet() || !HeldKeys::ofProgram().isFresh(press));
    }
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
        noteChoice(); // the window may become active after the click that activates it
        return isQuiet();
    case QEvent::Shortcut: return isQuiet();
    default: return false;
    }
}

} // namespace skyseal::ui

#include "moc_command_guard.cpp"
