#include "ui/ask_file.h"

#include "ui/confirm_box.h"
#include "ui/modeless.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QFileInfo>
#include <QtWidgets/QFileDialog>

#include <utility>

namespace skyseal::ui {

namespace {

using Take = std::function<void(const QString &path)>;

/// Qt's own text, with Qt's own translation.
constexpr const char *kReplace = "%1 already exists.\nDo you want to replace it?";

/// The question of QFileDialog itself would be modal.
Take unlessKept(QWidget &parent, const QString &title, Take take)
{
    return [&parent, title, take = std::move(take)](const QString &path) {
        if (!QFileInfo::exists(path))
            return take(path);
        askToConfirm({.objectName = QStringLiteral("replaceFile"),
                      .title = title,
                      .text = QCoreApplication::translate("QFileDialog", kReplace).arg(QFileInfo(path).fileName()),
                      .yes = title,
                      .icon = QMessageBox::Warning},
                     &parent, &parent, [take, path] { take(path); });
    };
}

} // namespace

void askFile(QWidget &parent, const FileQuestion &question, std::function<void(const QString &path)> take)
{
    if (question.use == FileQuestion::Use::Write)
        take = unlessKept(parent, question.title, std::move(take));
    for (QFileDialog *open : parent.findChildren<QFileDialog *>(QString(), Qt::FindDirectChildrenOnly)) {
        if (open->isHidden()) // closed, and about to be deleted
            continue;
        if (open->windowTitle() == question.title) { // what it was to be taken for may have changed meanwhile
            QObject::disconnect(open, &QFileDialog::fileSelected, &parent, nullptr);
            QObject::connect(open, &QFileDialog::fileSelected, &parent, std::move(take));
            return showModeless(*open);
        }
        open->reject();
    }
    auto *dialog = new QFileDialog(&parent, question.title, {}, question.kinds);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    switch (question.use) {
    case FileQuestion::Use::Read: break; // of any file: about a missing one Qt's dialog would open a modal box
    case FileQuestion::Use::Write:
        dialog->setAcceptMode(QFileDialog::AcceptSave);
        dialog->setOption(QFileDialog::DontConfirmOverwrite);
        break;
    case FileQuestion::Use::Folder:
        dialog->setFileMode(QFileDialog::Directory);
        dialog->setOption(QFileDialog::ShowDirsOnly);
        break;
    }
    if (const QFileInfo start(question.start); !question.start.isEmpty()) {
        dialog->setDirectory(start.isDir() ? start.filePath() : start.path());
        if (!start.isDir())
            dialog->selectFile(start.fileName());
    }
    QObject::connect(dialog, &QFileDialog::fileSelected, &parent, std::move(take));
    showModeless(*dialog);
}

} // namespace skyseal::ui
