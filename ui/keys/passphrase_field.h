// An input field for a passphrase, which it returns as the type of core/crypto.
#pragma once

#include <QtWidgets/QLineEdit>

#include <optional>

class QCheckBox;

namespace skyseal::crypto {
class Passphrase;
}

namespace skyseal::ui {

class PassphraseField : public QLineEdit
{
    Q_OBJECT

public:
    PassphraseField(const char *objectName, const QString &accessibleName, QWidget *parent = nullptr);

    /// Returns the passphrase; nothing if the field is empty.
    std::optional<crypto::Passphrase> passphrase() const;
};

/// The box "Remember it in the desktop's keyring"; disabled with the reason if there is no keyring.
QCheckBox *makeRememberBox(const QString &keyringProblem, QWidget *parent);

} // namespace skyseal::ui
