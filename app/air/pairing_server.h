// Where the window for pairing of a running agent is opened: a local socket beside its private key, which only the same user
// can reach. `skyseal-air --pair` speaks with it, one JSON object a line each way:
//
//   to the agent     {"do":"open","as":…,"passphrase":true|false}, with true followed by the 32 bytes of its key
//                    {"do":"confirm","public":…,"name":…,"role":…,"replace":…}  {"do":"refuse"}
//   from the agent   {"event":"pairing",…}, see pairing_status.h
//
// The window closes when whoever opened it goes away.
#pragma once

#include "app/common/pairing_status.h"
#include "core/engine/agent/agent_core.h"

#include <QtCore/QJsonObject>
#include <QtNetwork/QLocalServer>
#include <QtNetwork/QLocalSocket>

#include <functional>
#include <memory>
#include <optional>

namespace skyseal::app {

/// The socket of the agent with this identity file.
QString controlSocket(const std::string &identityFile);

class PairingServer : public QObject
{
    Q_OBJECT

public:
    using Say = std::function<void(const PairingStatus &)>;

    /// Listens. `agent` must outlive it; `say` hears what is told at the desk, for the agent's own log.
    PairingServer(engine::AgentCore &agent, engine::KeyPaths paths, Say say);
    ~PairingServer() override;

    /// Why nobody can open a window here; empty when it is listening.
    QString problem() const { return m_problem; }
    void take(const channel::PairingEvent &event);

private:
    void admit();
    void hear();
    void obey(const QJsonObject &order);
    void takeKey();
    void open(std::shared_ptr<const Key32> passphraseKey);
    void confirm(const QJsonObject &order);
    void keep(channel::Peer peer);
    void leave();
    void notify(const PairingStatus &status);
    keys::PeersFile known() const;

    engine::AgentCore &m_agent;
    engine::KeyPaths m_paths;
    Say m_say;
    QLocalServer m_server;
    QLocalSocket *m_visitor = nullptr; ///< a child of the server
    QString m_problem;
    bool m_keyFollows = false; ///< the next 32 bytes of the visitor are the key of a passphrase
    std::string m_callIt;      ///< the name that the visitor chose for whoever comes; empty = what it calls itself
    std::string m_name;        ///< what was decided about the other end
    channel::PeerRole m_role = channel::PeerRole::Observer;
    bool m_replace = false;
};

} // namespace skyseal::app
