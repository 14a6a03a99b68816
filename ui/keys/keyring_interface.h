// The interface of the dialogs to the keys of this station: its own public key and the known peers. The application implements
// it with files, tests with a fake, so that no dialog handles a file or a private key.
#pragma once

#include "core/base/result.h"
#include "core/channel/policy.h"

#include <QtCore/QDateTime>
#include <QtCore/QObject>
#include <QtCore/QString>

#include <optional>
#include <vector>

namespace skyseal::crypto {
class Passphrase;
}

namespace skyseal::ui {

struct OwnKey
{
    std::optional<channel::PublicKey> publicKey; ///< none: only plain links
    bool sealed = false;                         ///< with a passphrase
    QString file;
    QString problem;             ///< reason why there is no key
    bool remembered = false;     ///< the desktop's keyring holds the passphrase
    QString keyringProblem = {}; ///< reason why it cannot be stored there; empty if it can
};

struct KnownPeer
{
    QString name;
    channel::PeerRole role = channel::PeerRole::Pilot; ///< kept as it is in the file; only an agent obeys it
    std::vector<std::uint8_t> systems;                 ///< empty = any
    channel::PublicKey key{};
    bool hasPresharedKey = false;
    bool connected = false; ///< has a session
    QDateTime lastSeen;     ///< null: never seen
};

struct PeerList
{
    std::vector<KnownPeer> peers;
    QString file;
    QString problem; ///< reason why the list cannot be read
};

/// Lives on the GUI thread. Changes take effect at once: a removed peer loses its session.
class KeyringInterface : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    virtual OwnKey ownKey() const = 0;
    virtual PeerList peerList() const = 0;

    virtual Result<void, InputError> addPeer(const KnownPeer &peer) = 0;
    /// Changes name, role, systems or key of the peer with this name.
    virtual Result<void, InputError> changePeer(const QString &name, const KnownPeer &changed) = 0;
    virtual Result<void, InputError> removePeer(const QString &name) = 0;

    /// Returns the text of a public key file.
    virtual Result<QString, InputError> readKeyText(const QString &file) const = 0;
    virtual Result<void, InputError> exportPublicKey(const QString &file) const = 0;
    /// Seals the private key with the passphrase `next`, or removes the passphrase; `present` opens it if it is sealed. Takes a
    /// second or two on another thread, then passphraseDone() follows. `remember` stores `next` in the desktop's keyring.
    virtual void changePassphrase(std::optional<crypto::Passphrase> present, std::optional<crypto::Passphrase> next,
                                  bool remember) = 0;

Q_SIGNALS:
    /// Own key, list of peers or sessions have changed.
    void changed();
    /// `problem` is the reason of a failure; empty if the passphrase was changed.
    void passphraseDone(const QString &problem);
};

} // namespace skyseal::ui
