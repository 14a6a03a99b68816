#include "app/cli/control/control_socket.h"

#include "app/cli/people_report.h"
#include "app/common/local_listener.h"
#include "core/crypto/suite.h"
#include "core/engine/headless/event_json.h"
#include "core/engine/station/snapshot.h"
#include "core/engine/text/state_text.h"
#include "core/keys/peers_file.h"

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>

namespace skyseal::app {

namespace {

QString qt(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

void answer(QLocalSocket *asker, const QJsonObject &content)
{
    asker->write(QJsonDocument(content).toJson(QJsonDocument::Compact) + '\n');
}

void answerOk(QLocalSocket *asker, QJsonObject content = {})
{
    content.insert(QStringLiteral("ok"), true);
    answer(asker, content);
}

void answerError(QLocalSocket *asker, const QString &problem)
{
    answer(asker, {{QStringLiteral("ok"), false}, {QStringLiteral("error"), problem}});
}

std::string clientLine(const engine::ClientSnapshot &client)
{
    return "client " + client.name + " at " + client.address + ", write=" + client.write + ": "
        + std::to_string(client.counters.forwarded) + " frames forwarded, " + std::to_string(client.counters.denied)
        + " denied";
}

std::string brokerLine(const mqtt::PublisherStatus &broker)
{
    const auto count = [](const char *kind, const mqtt::PublishCount &of) {
        return std::to_string(of.sent) + ' ' + kind + " (" + std::to_string(of.dropped) + " dropped)";
    };
    return std::string("broker ") + (broker.connected ? "connected" : "not connected")
        + (broker.problem.empty() ? "" : ", " + broker.problem) + ": " + count("states", broker.state) + ", "
        + count("events", broker.event) + ", " + count("messages of frames", broker.raw) + " published";
}

} // namespace

ControlSocket::ControlSocket(engine::Station &station, std::string peersFile)
    : m_station(station), m_peersFile(std::move(peersFile))
{
    connect(&m_station, &engine::Station::snapshotReady, this,
            [this](const std::shared_ptr<const engine::Snapshot> &snapshot) { m_snapshot = snapshot; });
    connect(&m_station, &engine::Station::eventOccurred, this, [this](const engine::Event &event) { noteEvent(event); });
    connect(&m_server, &QLocalServer::newConnection, this, [this] { accept(); });
}

ControlSocket::~ControlSocket() = default;

Result<void, InputError> ControlSocket::listen(const QString &path)
{
    m_server.setMaxPendingConnections(kMostConnections);
    return listenLocally(m_server, path);
}

void ControlSocket::accept()
{
    while (QLocalSocket *asker = m_server.nextPendingConnection()) {
        connect(asker, &QLocalSocket::disconnected, asker, &QObject::deleteLater);
        if (m_server.findChildren<QLocalSocket *>(QString(), Qt::FindDirectChildrenOnly).size() > kMostConnections) {
            asker->abort();
            continue;
        }
        asker->setReadBufferSize(kLongestRequest);
        connect(asker, &QLocalSocket::readyRead, this, [this, asker] { readRequests(asker); });
    }
}

void ControlSocket::readRequests(QLocalSocket *asker)
{
    while (asker->canReadLine()) {
        const QJsonDocument request = QJsonDocument::fromJson(asker->readLine());
        if (request.isObject())
            handle(asker, request.object());
        else
            answerError(asker, QStringLiteral("a JSON object in one line is expected"));
    }
    if (asker->bytesAvailable() >= kLongestRequest) {
        answerError(asker, QStringLiteral("the request is too long"));
        asker->disconnectFromServer();
    }
}

void ControlSocket::handle(QLocalSocket *asker, const QJsonObject &request)
{
    const QString name = request.value(QStringLiteral("request")).toString();
    if (name == QLatin1String("status"))
        sendStatus(asker);
    else if (name == QLatin1String("switch"))
        switchSuite(asker, request.value(QStringLiteral("suite")).toString());
    else if (name == QLatin1String("revoke"))
        revoke(asker, request.value(QStringLiteral("peer")).toString());
    else
        answerError(asker, QStringLiteral("status, switch or revoke is expected"));
}

void ControlSocket::sendStatus(QLocalSocket *asker)
{
    if (!m_snapshot)
        return answerError(asker, QStringLiteral("not started yet"));
    QJsonArray text{qt(statusLine(*m_snapshot))};
    for (const engine::ClientSnapshot &client : m_snapshot->clients)
        text.append(qt(clientLine(client)));
    if (m_snapshot->broker)
        text.append(qt(brokerLine(*m_snapshot->broker)));
    const std::string status = engine::statusEvent(*m_snapshot);
    answerOk(asker,
             {{QStringLiteral("status"), QJsonDocument::fromJson(QByteArray::fromStdString(status)).object()},
              {QStringLiteral("text"), text}});
}

void ControlSocket::switchSuite(QLocalSocket *asker, const QString &name)
{
    const auto suite = crypto::suiteFromName(name.toStdString());
    if (!suite)
        return answerError(asker, QStringLiteral("no suite is named '%1'").arg(name));
    Switch pending{.asker = asker, .suite = *suite};
    pending.waitsFor = m_sessions;
    for (const channel::SessionId session : m_sessions)
        m_station.switchSuite(session, *suite);
    pending.sessions = pending.waitsFor.size();
    if (pending.sessions == 0)
        return answerError(asker, QStringLiteral("there is no session"));
    m_switches.push_back(std::move(pending));
}

void ControlSocket::revoke(QLocalSocket *asker, const QString &peer)
{
    if (m_peersFile.empty())
        return answerError(asker, QStringLiteral("this station has no list of peers"));
    // The station follows the file, so that the session ends at once.
    m_files.run(
        this,
        [file = m_peersFile, name = peer.toStdString()] {
            return keys::editPeers(file, [&name](keys::PeersFile &peers) -> Result<void, InputError> {
                if (!peers.remove(name))
                    return tl::unexpected(InputError{"there is no peer named \"" + name + "\"", {}});
                return {};
            });
        },
        [asker = QPointer<QLocalSocket>(asker)](const Result<void, InputError> &edited) {
            if (!asker)
                return;
            if (edited)
                answerOk(asker);
            else
                answerError(asker, qt(edited.error().text()));
        });
}

void ControlSocket::noteEvent(const engine::Event &event)
{
    if (const auto *done = std::get_if<channel::SwitchDone>(&event)) {
        const auto isWanted = [done](const Switch &pending) { return pending.suite == done->to; };
        const bool failed = done->failure != channel::SwitchFailure::None;
        switchEnded(done->session, isWanted, failed ? engine::switchFailureText(done->failure) : QString());
    } else if (const auto *up = std::get_if<channel::SessionUp>(&event)) {
        m_sessions.insert(up->session);
    } else if (const auto *down = std::get_if<channel::SessionDown>(&event)) {
        m_sessions.erase(down->session);
        const auto any = [](const Switch &) { return true; };
        switchEnded(down->session, any, engine::switchFailureText(channel::SwitchFailure::SessionEnded));
    }
}

/// The session has done with the switches that are concerned; `problem` is empty if it succeeded.
template<typename Concerned>
void ControlSocket::switchEnded(channel::SessionId session, Concerned concerned, const QString &problem)
{
    std::erase_if(m_switches, [&](Switch &pending) {
        if (!concerned(pending) || pending.waitsFor.erase(session) == 0)
            return false;
        if (!problem.isEmpty())
            pending.problem = problem;
        if (!pending.waitsFor.empty())
            return false;
        if (pending.asker && pending.problem.isEmpty())
            answerOk(pending.asker, {{QStringLiteral("sessions"), static_cast<int>(pending.sessions)}});
        else if (pending.asker)
            answerError(pending.asker, pending.problem);
        return true;
    });
}

} // namespace skyseal::app

#include "moc_control_socket.cpp"
