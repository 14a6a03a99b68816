#include "ui/confirm_box.h"

#include "ui/command_guard.h"
#include "ui/modeless.h"
#include "ui/theme/grid.h"

#include <QtWidgets/QGridLayout>
#include <QtWidgets/QPushButton>

namespace skyseal::ui {

QMessageBox *openQuestion(const QWidget &parent, const QString &objectName)
{
    for (QMessageBox *box : parent.findChildren<QMessageBox *>(objectName, Qt::FindDirectChildrenOnly))
        if (!box->isHidden()) // else closed, and about to be deleted
            return box;
    return nullptr;
}

QMessageBox *askToConfirm(const Question &question, QWidget *parent, QObject *context, std::function<void()> confirmed)
{
    if (QMessageBox *open = openQuestion(*parent, question.objectName))
        open->reject();
    auto *box = new QMessageBox(question.icon, question.title, question.text, QMessageBox::Yes | QMessageBox::Cancel, parent);
    box->setObjectName(question.objectName);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText); // texts contain names of peers and vehicles
    box->setInformativeText(question.details);
    box->setDefaultButton(QMessageBox::Cancel);
    box->setEscapeButton(QMessageBox::Cancel);
    box->button(QMessageBox::Yes)->setText(question.yes);
    if (auto *grid = qobject_cast<QGridLayout *>(box->layout())) {
        // Window systems draw the title between icon and buttons, and cut it where the box is narrow. A box takes its size from
        // its layout.
        constexpr int kFrameRoom = 20 * kGrid;
        QFont bold = box->font();
        bold.setBold(true);
        const int width = QFontMetrics(bold).horizontalAdvance(question.title) + kFrameRoom;
        grid->addItem(new QSpacerItem(width, 0), grid->rowCount(), 0, 1, grid->columnCount());
    }
    new CommandGuard(*box->button(QMessageBox::Yes));
    QObject::connect(box, &QMessageBox::finished, context, [confirmed = std::move(confirmed)](int result) {
        if (result == QMessageBox::Yes)
            confirmed();
    });
    showModeless(*box);
    return box;
}

} // namespace skyseal::ui
