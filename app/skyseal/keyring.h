// The key files of this station for the windows, and the times when each peer was seen.
#pragma once

#include "app/skyseal/passphrase_memory.h"
#include "core/engine/station/event.h"
#include "core/engine/station/station_config.h"
#include "ui/keys/keyring_interface.h"

#include <QtCore/QSettings>
#include <QtCore/QThreadPool>

#include <map>

namespace skyseal::app {

class Keyring : public ui::KeyringInterface
{
    Q_OBJECT

public:
    /// `store` stores when peers were seen; it and `memory` must outlive this.
    Keyring(QSettings &store, PassphraseMemory &memory, QObject *parent = nullptr);

    /// Sets the files: at the start, and when the demo creates its own.
    void use(const engine::KeyPaths &paths);
    /// Why the key is not in use; empty if it is.
    void setProblem(const QString &problem);
    /// Tracks sessions that begin and end.
    void handleEvent(const engine::Event &event);
    /// The files were changed by another program.
    void touched() { Q_EMIT changed(); }

    ui::OwnKey ownKey() const override;
    ui::PeerList peerList() const override;
    Result<void, InputError> addPeer(const ui::KnownPeer &peer) override;
    Result<void, InputError> changePeer(const QString &name, const ui::KnownPeer &changed) override;
    Result<void, InputError> removePeer(const QString &name) override;
    Result<QString, InputError> readKeyText(const QString &file) const override;
    Result<void, InputError> exportPublicKey(const QString &file) const override;
    void changePassphrase(std::optional<crypto::Passphrase> present, std::optional<crypto::Passphrase> next,
                          bool remember) override;

Q_SIGNALS:
    /// The operator changed the list of peers.
    void edited();

private:
    Result<void, InputError> note(Result<void, InputError> result);

    QSettings &m_store;
    PassphraseMemory &m_memory;
    engine::KeyPaths m_paths;
    QString m_problem;
    std::map<channel::SessionId, channel::PublicKey> m_sessions;
    QThreadPool m_worker; ///< hashes passphrases; its destructor waits for running tasks, so it is the last member
};

} // namespace skyseal::app
