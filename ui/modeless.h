// No dialog may keep the operator from the vehicle: every one is shown beside the window, which stays usable.
#pragma once

#include <QtWidgets/QDialog>

namespace skyseal::ui {

inline void showModeless(QDialog &dialog)
{
    dialog.setModal(false);
    dialog.show();
    dialog.raise();
    dialog.activateWindow();
}

/// True if `parent` has an open dialog of this class, which comes to the front.
template<typename Dialog> bool raiseOpen(const QWidget &parent)
{
    for (Dialog *dialog : parent.findChildren<Dialog *>(QString(), Qt::FindDirectChildrenOnly)) {
        if (dialog->isHidden()) // closed, and about to be deleted
            continue;
        showModeless(*dialog);
        return true;
    }
    return false;
}

} // namespace skyseal::ui
