// The keys of this station as the windows see them: its own public key and the known peers. The application puts the files
// behind it, tests a scripted one; no window touches a file or a private key.
#pragma once

#include "core/base/result.h"
#include "core/channel/policy.h"
#include "core/crypto/passphrase.h"

#include <QtCore/QDateTime>
#include <QtCore/QObject>
#include <QtCore/QString>

#include <optional>
#include <vector>

namespace skyseal::ui {

struct OwnKey
{
    std::optional<channel::PublicKey> publicKey; ///< none: only plain links
    bool sealed = false;                         ///< with a passphrase
    QString file;
    QString problem;             ///< why there is no key, in words
    bool remembered = false;     ///< the desktop's keyring has the passphrase
    QString keyringProblem = {}; ///< why it cannot, in words; empty when it can
};

struct KnownPeer
{
    QString name;
    channel::PeerRole role = channel::PeerRole::Pilot;
    std::vector<std::uint8_t> systems; ///< empty = any
    channel::PublicKey key{};
    bool hasPresharedKey = false;
    bool connected = false; ///< has a session now
    QDateTime lastSeen;     ///< null = never, as far as is known
};

struct PeerList
{
    std::vector<KnownPeer> peers;
    QString file;
    QString problem; ///< why the list cannot be read, in words
};

/// Lives on the GUI thread. What is changed is in force at once: who is removed loses the session.
class KeyringInterface : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    virtual OwnKey ownKey() const = 0;
    virtual PeerList peerList() const = 0;

    virtual Result<void, InputError> addPeer(const KnownPeer &peer) = 0;
    /// Name, role, systems or key of the peer that is called `name` now.
    virtual Result<void, InputError> changePeer(const QString &name, const KnownPeer &changed) = 0;
    virtual Result<void, InputError> removePeer(const QString &name) = 0;

    /// The text of a file that holds a public key.
    virtual Result<QString, InputError> readKeyText(const QString &file) const = 0;
    virtual Result<void, InputError> exportPublicKey(const QString &file) const = 0;
    /// Seals the private key with `next`, or takes its passphrase away; `present` opens it, if it is sealed. It takes a second
    /// or two of slow hashing elsewhere; passphraseDone() follows. `remember`: in the desktop's keyring.
    virtual void changePassphrase(std::optional<crypto::Passphrase> present, std::optional<crypto::Passphrase> next,
                                  bool remember) = 0;

Q_SIGNALS:
    /// Own key, list or sessions are others than before.
    void changed();
    /// Why the passphrase is the old one, in words; empty when it was changed.
    void passphraseDone(const QString &problem);
};

} // namespace skyseal::ui
