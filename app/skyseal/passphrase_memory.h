// Storage for the passphrase of a sealed key, so that the station does not ask for it at each start: the desktop's keyring, or
// none.
#pragma once

#include "core/crypto/passphrase.h"

#include <QtCore/QObject>
#include <QtCore/QSettings>

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace skyseal::app {

/// Lives on the GUI thread. Passphrases are stored under the path of the key file.
class PassphraseMemory : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    /// Why storing is not possible; empty if it is. Fast, without a prompt.
    virtual QString problem() const = 0;
    /// True if the passphrase of this file was stored, and not deleted since by this program.
    virtual bool remembers(const std::string &file) const = 0;
    /// The passphrase; nullopt if there is none or access is denied.
    using Recalled = std::function<void(std::optional<crypto::Passphrase> found)>;
    /// Returns at once, and calls `recalled` later unless `context` is deleted first. The desktop may prompt the operator to
    /// unlock the keyring, which takes as long as the operator does.
    virtual void recall(const std::string &file, QObject *context, Recalled recalled) = 0;
    /// Returns at once.
    virtual void remember(const std::string &file, const crypto::Passphrase &passphrase) = 0;
    virtual void forget(const std::string &file) = 0;

Q_SIGNALS:
    /// The passphrase is stored or deleted.
    void done();
    /// The keyring failed; with the reason.
    void failed(const QString &problem);
};

/// `store` stores which files are remembered, and must outlive it. Never null.
std::unique_ptr<PassphraseMemory> desktopMemory(QSettings &store);

} // namespace skyseal::app
