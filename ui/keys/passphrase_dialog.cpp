#include "ui/keys/passphrase_dialog.h"

#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QVBoxLayout>

namespace skyseal::ui {

PassphraseDialog::PassphraseDialog(const QString &file, bool again, QWidget *parent) : QDialog(parent)
{
    constexpr int kLongest = 1024;
    setObjectName(QStringLiteral("passphraseDialog"));
    setWindowTitle(tr("Passphrase"));
    auto *question = new QLabel(tr("The key of this station is sealed. Its passphrase?"), this);
    m_edit = new QLineEdit(this);
    m_edit->setObjectName(QStringLiteral("passphrase"));
    m_edit->setAccessibleName(tr("Passphrase"));
    m_edit->setEchoMode(QLineEdit::Password);
    m_edit->setMaxLength(kLongest);
    m_edit->setInputMethodHints(Qt::ImhSensitiveData | Qt::ImhNoPredictiveText);
    auto *wrong = new QLabel(again ? tr("That one does not open it.") : QString(), this);
    wrong->setObjectName(QStringLiteral("passphraseWrong"));
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, stateColors(palette()).alarm);
    wrong->setPalette(colors);
    auto *where = new QLabel(file, this);
    where->setTextFormat(Qt::PlainText);
    where->setForegroundRole(QPalette::PlaceholderText);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Open"));
    buttons->button(QDialogButtonBox::Cancel)->setText(tr("Without sealed links"));
    buttons->button(QDialogButtonBox::Ok)->setEnabled(false);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(2 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    column->setSpacing(kGrid);
    for (QWidget *row : std::initializer_list<QWidget *>{question, m_edit, wrong, where, buttons})
        column->addWidget(row);
    connect(m_edit, &QLineEdit::textChanged, this,
            [buttons](const QString &text) { buttons->button(QDialogButtonBox::Ok)->setEnabled(!text.isEmpty()); });
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    setMinimumWidth(52 * kGrid);
    m_edit->setFocus();
}

QByteArray PassphraseDialog::takePassphrase()
{
    const QByteArray out = m_edit->text().toUtf8();
    m_edit->clear();
    return out;
}

} // namespace skyseal::ui
