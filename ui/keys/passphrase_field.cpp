#include "ui/keys/passphrase_field.h"

#include "core/crypto/passphrase.h"
#include "core/base/secret_bytes.h"

#include <QtWidgets/QCheckBox>

namespace skyseal::ui {

PassphraseField::PassphraseField(const char *objectName, const QString &accessibleName, QWidget *parent) : QLineEdit(parent)
{
    setObjectName(QLatin1String(objectName));
    setAccessibleName(accessibleName);
    setEchoMode(QLineEdit::Password);
    setMaxLength(crypto::Passphrase::kMaxLength / 4); // UTF-8 needs at most four bytes per character
    setInputMethodHints(Qt::ImhSensitiveData | Qt::ImhNoPredictiveText);
}

QCheckBox *makeRememberBox(const QString &keyringProblem, QWidget *parent)
{
    auto *out = new QCheckBox(parent);
    out->setObjectName(QStringLiteral("rememberPassphrase"));
    out->setText(keyringProblem.isEmpty() ? QObject::tr("&Remember it in the desktop keyring")
                                          : QObject::tr("Remember it in the desktop keyring (%1)").arg(keyringProblem));
    out->setToolTip(QObject::tr("Anyone logged in as you, and any program you run, can then use the key without the "
                                "passphrase."));
    out->setEnabled(keyringProblem.isEmpty());
    return out;
}

std::optional<crypto::Passphrase> PassphraseField::passphrase() const
{
    QByteArray typed = text().toUtf8();
    auto out = crypto::Passphrase::fromBytes(
        {reinterpret_cast<const std::uint8_t *>(typed.constData()), static_cast<std::size_t>(typed.size())});
    wipeSecret(typed.data(), static_cast<std::size_t>(typed.size()));
    return out;
}

} // namespace skyseal::ui

#include "moc_passphrase_field.cpp"
