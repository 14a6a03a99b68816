// Keys of a line that finds what a list beside it shows: the line keeps the focus while one moves in the list and chooses.
#pragma once

#include <QtCore/QCoreApplication>
#include <QtGui/QKeyEvent>
#include <QtWidgets/QWidget>

namespace skyseal::ui {

/// Up, Down and the page keys move in `list`; Enter calls `choose`, once for each time that it is pressed. Returns true if the
/// key was one of these.
template<typename Choose> bool takeListKey(QKeyEvent &key, QWidget &list, Choose &&choose)
{
    switch (key.key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown: QCoreApplication::sendEvent(&list, &key); return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (!key.isAutoRepeat())
            choose();
        return true;
    default: return false;
    }
}

} // namespace skyseal::ui
