#include "ui/dialogs/help_dialog.h"

#include "ui/dialogs/help_page.h"
#include "ui/theme/grid.h"

#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QVBoxLayout>

namespace skyseal::ui {

HelpDialog::HelpDialog(const QString &page, const QHash<QString, QString> &inserts, QWidget *parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("helpDialog"));
    setWindowTitle(tr("Help"));
    auto *text = new HelpPage(inserts, this);
    text->open(page);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton *back = buttons->addButton(tr("&Back"), QDialogButtonBox::ActionRole);
    back->setShortcut(QKeySequence::Back);
    back->setObjectName(QStringLiteral("helpBack"));
    back->setEnabled(false);
    connect(text, &HelpPage::canGoBackChanged, back, &QWidget::setEnabled);
    connect(back, &QPushButton::clicked, text, &HelpPage::back);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, kGrid);
    column->addWidget(text, 1);
    auto *row = new QHBoxLayout;
    row->setContentsMargins(kGrid, 0, kGrid, 0);
    row->addWidget(buttons);
    column->addLayout(row);
    resize(110 * kGrid, 78 * kGrid);
}

} // namespace skyseal::ui

#include "moc_help_dialog.cpp"
