#include "ui/keys/passphrase_dialog.h"

#include "core/crypto/passphrase.h"
#include "ui/keys/passphrase_field.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtWidgets/QCheckBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QVBoxLayout>

namespace skyseal::ui {

PassphraseDialog::PassphraseDialog(const QString &file, RefusedPassphrase refused, const QString &keyringProblem,
                                   QWidget *parent)
    : QDialog(parent)
{
    setObjectName(QStringLiteral("passphraseDialog"));
    setWindowTitle(tr("Passphrase"));
    auto *question = new QLabel(tr("Passphrase of this station's key:"), this);
    m_edit = new PassphraseField("passphrase", tr("Passphrase"), this);
    auto *wrong = new QLabel(this);
    if (refused != RefusedPassphrase::None)
        wrong->setText(refused == RefusedPassphrase::Typed ? tr("Wrong passphrase.")
                                                           : tr("The remembered passphrase does not open this key."));
    wrong->setObjectName(QStringLiteral("passphraseWrong"));
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, stateColors(palette()).alarm);
    wrong->setPalette(colors);
    auto *where = new QLabel(file, this);
    where->setTextFormat(Qt::PlainText);
    where->setForegroundRole(QPalette::PlaceholderText);
    m_remember = makeRememberBox(keyringProblem, this);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Open"));
    buttons->button(QDialogButtonBox::Cancel)->setText(tr("Continue without sealed links"));
    buttons->button(QDialogButtonBox::Ok)->setEnabled(false);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(2 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    column->setSpacing(kGrid);
    for (QWidget *row : std::initializer_list<QWidget *>{question, m_edit, wrong, m_remember, where, buttons})
        column->addWidget(row);
    connect(m_edit, &QLineEdit::textChanged, this,
            [buttons](const QString &text) { buttons->button(QDialogButtonBox::Ok)->setEnabled(!text.isEmpty()); });
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    setMinimumWidth(52 * kGrid);
    m_edit->setFocus();
}

std::optional<crypto::Passphrase> PassphraseDialog::takePassphrase()
{
    auto out = m_edit->passphrase();
    m_edit->clear();
    return out;
}

void PassphraseDialog::setToBeRemembered(bool remember)
{
    m_remember->setChecked(remember);
}

bool PassphraseDialog::isToBeRemembered() const
{
    return m_remember->isEnabled() && m_remember->isChecked();
}

} // namespace skyseal::ui

#include "moc_passphrase_dialog.cpp"
