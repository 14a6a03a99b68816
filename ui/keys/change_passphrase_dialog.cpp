#include "ui/keys/change_passphrase_dialog.h"

#include "core/crypto/passphrase.h"
#include "ui/keys/passphrase_field.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtWidgets/QCheckBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

namespace skyseal::ui {

ChangePassphraseDialog::ChangePassphraseDialog(KeyringInterface &keyring, QWidget *parent) : QDialog(parent), m_keyring(keyring)
{
    const OwnKey own = keyring.ownKey();
    setObjectName(QStringLiteral("changePassphraseDialog"));
    setWindowTitle(own.sealed ? tr("Change the passphrase") : tr("Set a passphrase"));
    auto *intro = new QLabel(tr("The passphrase encrypts the private key in its file. Without one, anyone who copies the file "
                                "has the key. Skyseal asks for it at each start. A lost passphrase cannot be recovered."),
                             this);
    intro->setWordWrap(true);
    m_present = new PassphraseField("presentPassphrase", tr("Current passphrase"), this);
    m_next = new PassphraseField("newPassphrase", tr("New passphrase"), this);
    m_again = new PassphraseField("newPassphraseAgain", tr("Repeat the new passphrase"), this);
    m_none = new QCheckBox(tr("&No passphrase: anyone who has the file has the key"), this);
    m_none->setObjectName(QStringLiteral("noPassphrase"));
    m_remember = makeRememberBox(own.keyringProblem, this);
    m_remember->setChecked(own.remembered);
    m_canRemember = own.keyringProblem.isEmpty();
    m_problem = new QLabel(this);
    m_problem->setObjectName(QStringLiteral("passphraseProblem"));
    m_problem->setTextFormat(Qt::PlainText);
    m_problem->setWordWrap(true);
    m_problem->setMinimumHeight(kRow); // fixed, so that the dialog does not resize while typing
    auto *file = new QLabel(own.file, this);
    file->setTextFormat(Qt::PlainText);
    file->setForegroundRole(QPalette::PlaceholderText);
    auto *form = new QFormLayout;
    form->setHorizontalSpacing(2 * kGrid);
    form->setVerticalSpacing(kGrid);
    if (own.sealed)
        form->addRow(tr("&Current passphrase"), m_present);
    form->addRow(tr("Ne&w passphrase"), m_next);
    form->addRow(tr("Repeat the &new passphrase"), m_again);
    m_present->setVisible(own.sealed);
    m_none->setVisible(own.sealed);
    m_buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_buttons->button(QDialogButtonBox::Ok)->setText(own.sealed ? tr("Change") : tr("Seal"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(2 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    column->setSpacing(kGrid);
    column->addWidget(intro);
    column->addLayout(form);
    column->addWidget(m_remember);
    column->addWidget(m_none);
    column->addWidget(file);
    column->addWidget(m_problem);
    column->addStretch(1);
    column->addWidget(m_buttons);

    for (const PassphraseField *field : {m_present, m_next, m_again})
        connect(field, &QLineEdit::textChanged, this, &ChangePassphraseDialog::check);
    connect(m_none, &QCheckBox::toggled, this, &ChangePassphraseDialog::check);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &ChangePassphraseDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &ChangePassphraseDialog::reject);
    connect(&keyring, &KeyringInterface::passphraseDone, this, &ChangePassphraseDialog::finish);
    setMinimumWidth(60 * kGrid);
    (own.sealed ? m_present : m_next)->setFocus();
    check();
}

void ChangePassphraseDialog::notify(const QString &text, bool isProblem)
{
    QPalette colors = palette();
    if (isProblem)
        colors.setColor(QPalette::WindowText, stateColors(palette()).alarm);
    m_problem->setPalette(colors);
    m_problem->setText(text);
}

void ChangePassphraseDialog::check()
{
    const bool none = m_none->isChecked();
    for (QWidget *field : {static_cast<QWidget *>(m_next), static_cast<QWidget *>(m_again)})
        field->setEnabled(!none && !m_working);
    m_present->setEnabled(!m_working);
    m_none->setEnabled(!m_working);
    m_remember->setEnabled(m_canRemember && !none && !m_working);
    m_buttons->setEnabled(!m_working);
    if (m_working)
        return;
    const bool opened = m_present->isHidden() || !m_present->text().isEmpty();
    const bool same = m_next->text() == m_again->text();
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(opened && (none || (same && !m_next->text().isEmpty())));
    const bool differs = !none && !same && !m_again->text().isEmpty() && !m_next->text().startsWith(m_again->text());
    notify(differs ? tr("The two new passphrases differ.") : QString(), true);
}

void ChangePassphraseDialog::accept()
{
    if (m_working || !m_buttons->button(QDialogButtonBox::Ok)->isEnabled())
        return;
    auto next = m_none->isChecked() ? std::nullopt : m_next->passphrase();
    const bool remember = m_remember->isEnabled() && m_remember->isChecked();
    m_working = true;
    check();
    notify(tr("Working…"), false);
    m_keyring.changePassphrase(m_present->isHidden() ? std::nullopt : m_present->passphrase(), std::move(next), remember);
}

void ChangePassphraseDialog::reject()
{
    if (!m_working)
        QDialog::reject();
}

void ChangePassphraseDialog::finish(const QString &problem)
{
    if (!m_working)
        return;
    m_working = false;
    if (problem.isEmpty()) {
        QDialog::accept();
        return;
    }
    m_present->clear();
    check();
    notify(problem, true);
    m_present->setFocus();
}

} // namespace skyseal::ui

#include "moc_change_passphrase_dialog.cpp"
