// The control socket through which the pairing window of a running agent is opened: a local socket next to its private key,
// accessible by the same user only. Its client is `skyseal-air --pair`; one JSON object per line in each direction:
//
//   to the agent     {"do":"open","as":…,"passphrase":N}, followed by the N bytes of the passphrase, 0 = none
//                    {"do":"confirm","public":…,"name":…,"role":…,"replace":…}  {"do":"refuse"}
//   from the agent   {"event":"pairing",…}, see pairing_status.h
//
// The window closes when the client that opened it disconnects.
#pragma once

#include "app/common/pairing_status.h"
#include "core/engine/agent/agent_core.h"
#include "core/engine/common/file_thread.h"

#include <QtCore/QJsonObject>
#include <QtNetwork/QLocalServer>
#include <QtNetwork/QLocalSocket>

#include <functional>
#include <memory>
#include <optional>

namespace skyseal::app {

/// The absolute path of the socket of the agent with this identity file, beside the file itself: not beside a link to it.
QString controlSocket(const std::string &identityFile);

class PairingServer : public QObject
{
    Q_OBJECT

public:
    using Say = std::function<void(const PairingStatus &)>;

    /// Starts listening. `agent` must outlive it; `say` is called with each status sent to the client, for the agent's log.
    PairingServer(engine::AgentCore &agent, engine::KeyPaths paths, Say say);
    ~PairingServer() override;

    /// Why the server does not listen; empty if it does.
    QString problem() const { return m_problem; }
    void take(const channel::PairingEvent &event);

private:
    void admit();
    void readRequests();
    void handleRequest(const QJsonObject &request);
    void takePassphrase();
    void open(std::shared_ptr<const crypto::Passphrase> passphrase);
    void confirm(const QJsonObject &request);
    void keep(channel::Peer peer);
    void clientLeft();
    void notify(const PairingStatus &status);

    engine::AgentCore &m_agent;
    engine::KeyPaths m_paths;
    Say m_say;
    QLocalServer m_server;
    QLocalSocket *m_client = nullptr; ///< a child of the server
    QString m_problem;
    qint64 m_passphraseLength = 0; ///< of the passphrase that the client sends next; 0 = none
    std::string m_peerName;        ///< name chosen by the client for the peer; empty = the name the peer claims
    std::string m_name;            ///< the confirmed name of the peer
    channel::PeerRole m_role = channel::PeerRole::Observer;
    bool m_replace = false;
    engine::FileThread m_files; ///< the list of peers; the agent must not wait for the disk
};

} // namespace skyseal::app
