// A field for a passphrase, and what was typed there as the core wants it.
#pragma once

#include "core/crypto/passphrase.h"

#include <QtWidgets/QLineEdit>

#include <optional>

class QCheckBox;

namespace skyseal::ui {

class PassphraseField : public QLineEdit
{
    Q_OBJECT

public:
    PassphraseField(const char *objectName, const QString &accessibleName, QWidget *parent = nullptr);

    /// What stands there; nothing when it is empty.
    std::optional<crypto::Passphrase> passphrase() const;
};

/// "Remember it in the desktop's keyring"; disabled, and saying why, where there is none.
QCheckBox *makeRememberBox(const QString &keyringProblem, QWidget *parent);

} // namespace skyseal::ui
