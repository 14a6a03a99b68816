#include "ui/window/menu_key.h"

#include <QtGui/QContextMenuEvent>
#include <QtGui/QKeyEvent>
#include <QtWidgets/QApplication>
#include <QtWidgets/QWidget>

namespace skyseal::ui {

namespace {

bool opensContextMenus(const QKeyEvent &key)
{
    return key.keyCombination() == (Qt::SHIFT | Qt::Key_F10) && !key.isAutoRepeat();
}

/// Dialogs are windows of their own, and objects of the window.
bool belongsTo(const QWidget &window, const QObject &control)
{
    const QObject *at = &control;
    while (at && at != &window)
        at = at->parent();
    return at != nullptr;
}

} // namespace

MenuKey::MenuKey(QWidget &window) : QObject(&window), m_window(window)
{
    qApp->installEventFilter(this);
}

bool MenuKey::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::KeyPress || !opensContextMenus(*static_cast<QKeyEvent *>(event)))
        return false;
    auto *control = qobject_cast<QWidget *>(watched);
    if (!control || control != QApplication::focusWidget() || !belongsTo(m_window, *control))
        return false;
    const QPoint at = control->inputMethodQuery(Qt::ImCursorRectangle).toRect().center(); // as for the Menu key
    QContextMenuEvent menu(QContextMenuEvent::Keyboard, at, control->mapToGlobal(at));
    menu.ignore();
    QCoreApplication::sendEvent(control, &menu);
    return menu.isAccepted();
}

} // namespace skyseal::ui

#include "moc_menu_key.cpp"
