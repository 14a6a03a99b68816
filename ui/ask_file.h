// Asks for a file or a folder beside the window, which stays usable: the functions of QFileDialog block it, and with it Land
// and RTL.
#pragma once

#include <QtCore/QString>
#include <QtWidgets/QWidget>

#include <functional>

namespace skyseal::ui {

struct FileQuestion
{
    enum class Use { Read, Write, Folder };

    QString title;      ///< with Write: what is done, as on the button that replaces a file
    QString kinds = {}; ///< as for QFileDialog; empty: all files
    QString start = {}; ///< folder in which it begins, or proposed file; empty: the last one used
    Use use = Use::Read;
};

/// Opens the dialog, or brings it to the front if it is open. Calls `take` with the path once one is chosen, unless `parent` is
/// deleted or asks again before. A file to be read may be missing; to replace one, the operator must confirm. A question of
/// `parent` about something else is closed.
void askFile(QWidget &parent, const FileQuestion &question, std::function<void(const QString &path)> take);

} // namespace skyseal::ui
