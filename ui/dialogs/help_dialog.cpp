#include "ui/dialogs/help_dialog.h"

#include "ui/theme/grid.h"

#include <QtCore/QFile>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QTextBrowser>
#include <QtWidgets/QVBoxLayout>

namespace skyseal::ui {

HelpDialog::HelpDialog(const QString &page, QWidget *parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("helpDialog"));
    setWindowTitle(tr("Help"));
    auto *text = new QTextBrowser(this);
    text->setAccessibleName(tr("Help page"));
    text->setFrameShape(QFrame::NoFrame);
    text->document()->setDocumentMargin(2 * kGrid);
    QFile file(QStringLiteral(":/skyseal/help/%1.md").arg(page));
    text->setMarkdown(file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll())
                                                     : tr("There is no help page \"%1\".").arg(page));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, kGrid);
    column->addWidget(text, 1);
    auto *row = new QHBoxLayout;
    row->setContentsMargins(kGrid, 0, kGrid, 0);
    row->addWidget(buttons);
    column->addLayout(row);
    resize(90 * kGrid, 72 * kGrid);
}

} // namespace skyseal::ui
