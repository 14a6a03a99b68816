// Sets, changes or removes the passphrase of this station's private key.
#pragma once

#include "ui/keys/keyring_interface.h"

#include <QtWidgets/QDialog>

class QCheckBox;
class QDialogButtonBox;
class QLabel;

namespace skyseal::ui {

class PassphraseField;

class ChangePassphraseDialog : public QDialog
{
    Q_OBJECT

public:
    explicit ChangePassphraseDialog(KeyringInterface &keyring, QWidget *parent = nullptr);

    void accept() override;
    /// Does nothing while the key is being sealed.
    void reject() override;

private:
    void check();
    void finish(const QString &problem);
    void notify(const QString &text, bool isProblem);

    KeyringInterface &m_keyring;
    PassphraseField *m_present, *m_next, *m_again;
    QCheckBox *m_none, *m_remember;
    QLabel *m_problem;
    QDialogButtonBox *m_buttons;
    bool m_canRemember = false;
    bool m_working = false;
};

} // namespace skyseal::ui
