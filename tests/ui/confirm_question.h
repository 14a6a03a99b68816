// The question of the window that confirms a command.
#pragma once

#include <QtWidgets/QMessageBox>

namespace skyseal::test {

/// The one that is shown; null without one.
inline QMessageBox *shownQuestion(const QWidget &window)
{
    for (QMessageBox *box : window.findChildren<QMessageBox *>(QStringLiteral("confirmCommand")))
        if (box->isVisible())
            return box;
    return nullptr;
}

} // namespace skyseal::test
