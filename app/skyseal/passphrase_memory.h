// Where the desktop may keep the passphrase of a sealed key, so that the station does not ask for it at each start. Behind it
// the desktop's keyring, or nothing.
#pragma once

#include "core/crypto/passphrase.h"

#include <QtCore/QObject>
#include <QtCore/QSettings>

#include <memory>
#include <optional>
#include <string>

namespace skyseal::app {

/// Lives on the GUI thread. Passphrases are kept by the path of the key file.
class PassphraseMemory : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    /// Why nothing can be kept here, in words; empty when it can. Quick, and asks nobody.
    virtual QString problem() const = 0;
    /// Whether the passphrase of this file was kept and not forgotten since, as far as we know.
    virtual bool remembers(const std::string &file) const = 0;
    /// Waits for the answer; the desktop may ask the operator to unlock its keyring. Nothing when it has none, or says no.
    virtual std::optional<crypto::Passphrase> recall(const std::string &file) = 0;
    /// Returns at once.
    virtual void remember(const std::string &file, const crypto::Passphrase &passphrase) = 0;
    virtual void forget(const std::string &file) = 0;

Q_SIGNALS:
    /// It is kept or forgotten now.
    void done();
    /// The keyring did not do as it was told; in words.
    void failed(const QString &problem);
};

/// `store` notes which files are remembered, and must outlive it. Never null.
std::unique_ptr<PassphraseMemory> desktopMemory(QSettings &store);

} // namespace skyseal::app
