// The control socket of a station that runs on the command line: other programs of the same user ask for its state, switch
// suites and revoke peers. A request is one JSON object in a line, and so is its answer:
//
//   {"request":"status"}                       {"ok":true,"status":{…},"text":["…"]}
//   {"request":"switch","suite":"aes-256-gcm"} {"ok":true,"sessions":2}, when all sessions have changed over
//   {"request":"revoke","peer":"air-1"}        {"ok":true}
//                                              {"ok":false,"error":"…"}
#pragma once

#include "core/base/result.h"
#include "core/engine/common/file_thread.h"
#include "core/engine/station/station.h"

#include <QtCore/QJsonObject>
#include <QtCore/QObject>
#include <QtCore/QPointer>
#include <QtNetwork/QLocalServer>
#include <QtNetwork/QLocalSocket>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace skyseal::app {

class ControlSocket : public QObject
{
    Q_OBJECT

public:
    static constexpr qint64 kLongestRequest = 4096;
    static constexpr int kMostConnections = 8;

    /// `station` must outlive this object; `peersFile` is its list of peers, empty without keys.
    ControlSocket(engine::Station &station, std::string peersFile);
    ~ControlSocket() override;

    /// Listens on a socket that only this user can open. Replaces one that a killed program left behind, and fails if another
    /// program listens there.
    Result<void, InputError> listen(const QString &path);

private:
    /// A switch that some sessions have not ended yet.
    struct Switch
    {
        QPointer<QLocalSocket> asker;
        crypto::SuiteId suite{};
        std::set<channel::SessionId> waitsFor = {};
        std::size_t sessions = 0;
        QString problem = {};
    };

    void accept();
    void readRequests(QLocalSocket *asker);
    void handle(QLocalSocket *asker, const QJsonObject &request);
    void sendStatus(QLocalSocket *asker);
    void switchSuite(QLocalSocket *asker, const QString &name);
    void revoke(QLocalSocket *asker, const QString &peer);
    void noteEvent(const engine::Event &event);
    template<typename Concerned> void switchEnded(channel::SessionId session, Concerned concerned, const QString &problem);

    engine::Station &m_station;
    const std::string m_peersFile;
    std::shared_ptr<const engine::Snapshot> m_snapshot;
    std::set<channel::SessionId> m_sessions; ///< that are up
    std::vector<Switch> m_switches;
    QLocalServer m_server;
    engine::FileThread m_files;
};

} // namespace skyseal::app
