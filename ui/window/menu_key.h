// Shift+F10 opens the context menu of the control that has the focus, for keyboards without a Menu key. Qt turns that key into
// the event of a context menu, and Shift+F10 on Windows alone. Lives on the GUI thread.
#pragma once

#include <QtCore/QObject>

class QWidget;

namespace skyseal::ui {

class MenuKey : public QObject
{
    Q_OBJECT

public:
    /// For the controls in `window` and in its dialogs. Becomes its child.
    explicit MenuKey(QWidget &window);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget &m_window;
};

} // namespace skyseal::ui
