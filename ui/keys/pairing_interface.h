// A pairing as the windows see it: what they may ask and what they hear. The application puts the engine and the list of
// peers behind it, tests a scripted one.
#pragma once

#include "core/channel/policy.h"
#include "core/crypto/passphrase.h"

#include <QtCore/QObject>
#include <QtCore/QString>

#include <optional>

namespace skyseal::ui {

/// Somebody at the other end, to be compared.
struct PairingQuestion
{
    channel::PublicKey key{};
    QString name; ///< as it is known here already, or as it calls itself, made fit for the list
};

/// Lives on the GUI thread.
class PairingInterface : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    /// Waits for an agent whose window is open. With a passphrase only one that has the same is shown.
    virtual void open(channel::PeerRole roleAsked, const std::optional<crypto::Passphrase> &passphrase) = 0;
    /// The person compared the fingerprints of this key.
    virtual void confirm(const channel::PublicKey &key, const QString &name, bool replaceKnownKey) = 0;
    virtual void refuse() = 0;
    virtual void cancel() = 0;

Q_SIGNALS:
    void seen(const skyseal::ui::PairingQuestion &question);
    void confirmedThere();
    /// The question is void.
    void gone(const QString &reason);
    void otherTried(const QString &fingerprint);
    /// One end has a passphrase and the other none, or they are not the same. Comes again each second.
    void passphraseDiffers();
    /// It is in the list, by this name.
    void paired(const QString &name);
    /// It is over without a pair.
    void failed(const QString &reason);
};

} // namespace skyseal::ui
