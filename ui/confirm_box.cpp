#include "ui/confirm_box.h"

#include "ui/command_guard.h"
#include "ui/modeless.h"

#include <QtWidgets/QPushButton>

namespace skyseal::ui {

QMessageBox *askToConfirm(const Question &question, QWidget *parent, QObject *context, std::function<void()> confirmed)
{
    auto *box = new QMessageBox(question.icon, question.title, question.text, QMessageBox::Yes | QMessageBox::Cancel, parent);
    box->setObjectName(question.objectName);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText); // texts contain names of peers and vehicles
    box->setInformativeText(question.details);
    box->setDefaultButton(QMessageBox::Cancel);
    box->setEscapeButton(QMessageBox::Cancel);
    box->button(QMessageBox::Yes)->setText(question.yes);
    new CommandGuard(*box->button(QMessageBox::Yes));
    QObject::connect(box, &QMessageBox::finished, context, [confirmed = std::move(confirmed)](int result) {
        if (result == QMessageBox::Yes)
            confirmed();
    });
    showModeless(*box);
    return box;
}

} // namespace skyseal::ui
