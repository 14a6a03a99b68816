#include "ui/command_guard.h"

#include "ui/held_keys.h"

#include <QtGui/QKeyEvent>
#include <QtWidgets/QAbstractButton>

namespace skyseal::ui {

CommandGuard::CommandGuard(QWidget &control) : QObject(&control)
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

bool CommandGuard::eventFilter(QObject *, QEvent *event)
{
    switch (event->type()) {
    case QEvent::KeyPress: {
        const auto &press = *static_cast<const QKeyEvent *>(event);
        return HeldKeys::isPressKey(press.key()) && (isQuiet() || !HeldKeys::ofProgram().isFresh(press));
    }
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::Shortcut: return isQuiet();
    default: return false;
    }
}

} // namespace skyseal::ui

#include "moc_command_guard.cpp"
