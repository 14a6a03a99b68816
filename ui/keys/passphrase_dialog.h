// Asks for the passphrase of this station's key.
#pragma once

#include <QtWidgets/QDialog>

#include <optional>

class QCheckBox;

namespace skyseal::crypto {
class Passphrase;
}

namespace skyseal::ui {

class PassphraseField;

class PassphraseDialog : public QDialog
{
    Q_OBJECT

public:
    /// `again`: the previous passphrase was wrong. `keyringProblem`: reason why the desktop's keyring cannot store it; empty if
    /// it can.
    PassphraseDialog(const QString &file, bool again, const QString &keyringProblem, QWidget *parent = nullptr);

    /// Moves the passphrase out of the dialog.
    std::optional<crypto::Passphrase> takePassphrase();
    void setToBeRemembered(bool remember);
    bool isToBeRemembered() const;

private:
    PassphraseField *m_edit;
    QCheckBox *m_remember;
};

} // namespace skyseal::ui
