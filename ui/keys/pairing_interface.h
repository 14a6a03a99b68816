// The interface of the dialog to a pairing. The application implements it with the engine and the list of peers, tests with a
// fake.
#pragma once

#include "core/channel/policy.h"

#include <QtCore/QObject>
#include <QtCore/QString>

#include <optional>

namespace skyseal::crypto {
class Passphrase;
}

namespace skyseal::ui {

/// The device at the other end.
struct PairingQuestion
{
    channel::PublicKey key{};
    QString name;              ///< its name in the list of peers, or the name it gives, made valid for the list
    QString code;              ///< six digits, to be compared with those at the other end unless there is a passphrase
    std::uint8_t systemId = 0; ///< MAVLink system id of its vehicle, which the pairing binds; 0 = unknown
};

/// Lives on the GUI thread.
class PairingInterface : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    /// Opens the pairing window and waits for an agent that does the same. Finds only agents with the same
    /// passphrase, if there is one.
    virtual void open(const std::optional<crypto::Passphrase> &passphrase) = 0;
    /// The operator accepts the device with this key.
    virtual void confirm(const channel::PublicKey &key, const QString &name, bool replaceKnownKey) = 0;
    /// Ends the pairing.
    virtual void refuse() = 0;
    virtual void cancel() = 0;

Q_SIGNALS:
    void seen(const skyseal::ui::PairingQuestion &question);
    void confirmedThere();
    void otherTried();
    /// The passphrases differ, or only one end has one. Repeated every second.
    void passphraseDiffers();
    /// The peer was added to the list under this name.
    void paired(const QString &name);
    /// The pairing ended without a new peer.
    void failed(const QString &reason);
};

} // namespace skyseal::ui
