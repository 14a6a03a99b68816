// The way into the menus and back by keys: F10 opens the first one, and Esc leads back to the control that had the focus, in
// one step. Qt stops in the menu bar between, where keys meant for that control do nothing. Lives on the GUI thread.
#pragma once

#include <QtCore/QObject>
#include <QtCore/QPointer>

class QAction;
class QMenuBar;
class QWidget;

namespace skyseal::ui {

class MenuBarFocus : public QObject
{
    Q_OBJECT

public:
    /// Of the menus that `bar` has now. Becomes its child.
    explicit MenuBarFocus(QMenuBar &bar);

    /// Opens the first menu. For the palette and a shortcut.
    QAction *action() const { return m_action; }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void leave();

    QMenuBar &m_bar;
    QAction *m_action;
    QPointer<QWidget> m_before; ///< had the focus before the bar
};

} // namespace skyseal::ui
