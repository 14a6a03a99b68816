// The interface of the dialog to a pairing. The application implements it with the engine and the list of peers, tests with a
// fake.
#pragma once

#include "core/channel/policy.h"
#include "core/crypto/passphrase.h"

#include <QtCore/QObject>
#include <QtCore/QString>

#include <optional>

namespace skyseal::ui {

/// The device at the other end, whose fingerprint is to be compared.
struct PairingQuestion
{
    channel::PublicKey key{};
    QString name; ///< its name in the list of peers, or the name it gives, made valid for the list
};

/// Lives on the GUI thread.
class PairingInterface : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    /// Opens the pairing window and waits for an agent that does the same. With a passphrase, only an agent with the same one is found.
    virtual void open(channel::PeerRole roleAsked, const std::optional<crypto::Passphrase> &passphrase) = 0;
    /// The operator has compared the fingerprints of this key.
    virtual void confirm(const channel::PublicKey &key, const QString &name, bool replaceKnownKey) = 0;
    virtual void refuse() = 0;
    virtual void cancel() = 0;

Q_SIGNALS:
    void seen(const skyseal::ui::PairingQuestion &question);
    void confirmedThere();
    /// The agent is gone; the comparison is void.
    void gone(const QString &reason);
    void otherTried(const QString &fingerprint);
    /// The passphrases differ, or only one end has one. Repeated every second.
    void passphraseDiffers();
    /// The peer was added to the list under this name.
    void paired(const QString &name);
    /// The pairing ended without a new peer.
    void failed(const QString &reason);
};

} // namespace skyseal::ui
