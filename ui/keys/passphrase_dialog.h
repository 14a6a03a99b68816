// Asks for the passphrase of this station's key.
#pragma once

#include <QtWidgets/QDialog>

#include <cstdint>
#include <optional>

class QCheckBox;

namespace skyseal::crypto {
class Passphrase;
}

namespace skyseal::ui {

class PassphraseField;

/// A passphrase that did not open the key before.
enum class RefusedPassphrase : std::uint8_t {
    None,
    Typed,     ///< by the operator
    Remembered ///< by the desktop's keyring
};

class PassphraseDialog : public QDialog
{
    Q_OBJECT

public:
    /// `keyringProblem`: reason why the desktop's keyring cannot store it; empty if it can.
    PassphraseDialog(const QString &file, RefusedPassphrase refused, const QString &keyringProblem, QWidget *parent = nullptr);

    /// Moves the passphrase out of the dialog.
    std::optional<crypto::Passphrase> takePassphrase();
    void setToBeRemembered(bool remember);
    bool isToBeRemembered() const;

private:
    PassphraseField *m_edit;
    QCheckBox *m_remember;
};

} // namespace skyseal::ui
