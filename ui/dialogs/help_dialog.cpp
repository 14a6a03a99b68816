#include "ui/dialogs/help_dialog.h"

#include "ui/theme/grid.h"

#include <QtCore/QFile>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QTextBrowser>
#include <QtWidgets/QVBoxLayout>

namespace skyseal::ui {

namespace {

QString pageText(const QString &page, const QHash<QString, QString> &inserts)
{
    QFile file(QStringLiteral(":/skyseal/help/%1.md").arg(page));
    if (!file.open(QIODevice::ReadOnly))
        return HelpDialog::tr("There is no help page \"%1\".").arg(page);
    QString text = QString::fromUtf8(file.readAll());
    for (auto insert = inserts.begin(); insert != inserts.end(); ++insert)
        text.replace(QStringLiteral("<!-- %1 -->").arg(insert.key()), insert.value());
    return text;
}

} // namespace

HelpDialog::HelpDialog(const QString &page, const QHash<QString, QString> &inserts, QWidget *parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("helpDialog"));
    setWindowTitle(tr("Help"));
    auto *text = new QTextBrowser(this);
    text->setAccessibleName(tr("Help page"));
    text->setFrameShape(QFrame::NoFrame);
    text->document()->setDocumentMargin(2 * kGrid);
    text->setMarkdown(pageText(page, inserts));
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
