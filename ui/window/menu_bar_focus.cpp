#include "ui/window/menu_bar_focus.h"

#include <QtGui/QAction>
#include <QtGui/QKeyEvent>
#include <QtWidgets/QApplication>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>

namespace skyseal::ui {

MenuBarFocus::MenuBarFocus(QMenuBar &bar) : QObject(&bar), m_bar(bar), m_action(new QAction(tr("Open the first menu"), this))
{
    m_action->setObjectName(QStringLiteral("actionMenuBar"));
    m_action->setShortcut(Qt::Key_F10);
    m_action->setAutoRepeat(false);
    connect(m_action, &QAction::triggered, this, [this] { m_bar.setActiveAction(m_bar.actions().constFirst()); });
    m_bar.installEventFilter(this);
    for (const QAction *top : bar.actions())
        if (QMenu *menu = top->menu())
            menu->installEventFilter(this);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget *old, QWidget *now) {
        if (now == &m_bar && old)
            m_before = old;
    });
}

bool MenuBarFocus::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent *>(event)->key() == Qt::Key_Escape)
        QMetaObject::invokeMethod(this, &MenuBarFocus::leave, Qt::QueuedConnection); // after the menu or the bar has taken it
    return QObject::eventFilter(watched, event);
}

void MenuBarFocus::leave()
{
    if (!m_bar.hasFocus())
        return;
    QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
    m_bar.removeEventFilter(this);
    QCoreApplication::sendEvent(&m_bar, &escape); // ends the mode in which the bar takes keys
    m_bar.installEventFilter(this);
    if (m_bar.hasFocus() && m_before && m_before->isVisible())
        m_before->setFocus(Qt::MenuBarFocusReason);
}

} // namespace skyseal::ui

#include "moc_menu_bar_focus.cpp"
