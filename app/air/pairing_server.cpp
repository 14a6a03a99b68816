#include "app/air/pairing_server.h"

#include "app/common/local_listener.h"
#include "core/base/locked_memory.h"
#include "core/base/secret_bytes.h"
#include "core/crypto/passphrase.h"
#include "core/keys/paired_peer.h"
#include "core/keys/public_key_text.h"

#include <QtCore/QFileInfo>
#include <QtCore/QJsonDocument>
#include <QtCore/QSysInfo>

#include <algorithm>
#include <utility>

namespace skyseal::app {

namespace {

constexpr qint64 kMaxRequest = 4096;

PairingStatus refusal(std::string reason)
{
    PairingStatus status;
    status.state = PairingStatus::State::Refused;
    status.reason = std::move(reason);
    return status;
}

void write(QLocalSocket &socket, const PairingStatus &status)
{
    socket.write(QByteArray::fromStdString(status.toJson()) + '\n');
}

/// Stores the peer and returns the status to be sent. `reason`: a part of the request that was refused.
PairingStatus stored(const std::string &peersFile, channel::Peer peer, std::string reason, keys::KeyChange change)
{
    // Stations may share an id. To bind it to this one would take it from those that are bound to none.
    const auto known = keys::PeersFile::loadOrEmpty(peersFile).value_or(keys::PeersFile()).entries();
    if (std::ranges::any_of(
            known, [&](const keys::PeerEntry &other) { return other.peer.key != peer.key && other.peer.systemIds.empty(); }))
        peer.systemIds.clear();
    const auto kept = keys::keepPairedPeer(peersFile, peer, change, keys::SharedIds::Allowed);
    if (!kept)
        return refusal(kept.error().text());
    PairingStatus status;
    status.state = PairingStatus::State::Paired;
    status.reason = std::move(reason);
    status.name = peer.name;
    status.role = peer.role;
    status.key = peer.key;
    return status;
}

} // namespace

QString controlSocket(const std::string &identityFile)
{
    const QFileInfo file(QString::fromStdString(identityFile));
    const QString real = file.canonicalFilePath();
    return (real.isEmpty() ? file.absoluteFilePath() : real) + QStringLiteral(".control");
}

PairingServer::PairingServer(engine::AgentCore &agent, engine::KeyPaths paths, Say say)
    : m_agent(agent), m_paths(std::move(paths)), m_say(std::move(say))
{
    connect(&m_server, &QLocalServer::newConnection, this, &PairingServer::admit);
    if (const auto listening = listenLocally(m_server, controlSocket(m_paths.identity)); !listening)
        m_problem = QString::fromStdString(listening.error().text());
}

PairingServer::~PairingServer()
{
    disconnect(&m_server, nullptr, this, nullptr);
    if (m_client)
        disconnect(m_client, nullptr, this, nullptr);
}

void PairingServer::admit()
{
    while (QLocalSocket *next = m_server.nextPendingConnection()) {
        if (m_client) {
            // Respond only after its request: a client that is still writing when we disconnect does not read the reason.
            connect(next, &QLocalSocket::readyRead, next, [next] {
                write(*next, refusal("another user is pairing this agent"));
                next->disconnectFromServer();
            });
            connect(next, &QLocalSocket::disconnected, next, &QObject::deleteLater);
            continue;
        }
        m_client = next;
        connect(next, &QLocalSocket::readyRead, this, &PairingServer::readRequests);
        connect(next, &QLocalSocket::disconnected, this, &PairingServer::clientLeft);
    }
}

void PairingServer::clientLeft()
{
    m_client->deleteLater();
    m_client = nullptr;
    m_passphraseLength = 0;
    m_agent.cancelPairing();
}

void PairingServer::readRequests()
{
    const auto arrived = [this] {
        return m_passphraseLength > 0 ? m_client->bytesAvailable() >= m_passphraseLength : m_client->canReadLine();
    };
    while (m_client && arrived()) {
        if (m_passphraseLength > 0)
            takePassphrase();
        else
            handleRequest(QJsonDocument::fromJson(m_client->readLine(kMaxRequest)).object());
    }
    if (m_client && m_client->bytesAvailable() > kMaxRequest)
        m_client->abort();
}

void PairingServer::handleRequest(const QJsonObject &request)
{
    const QString action = request[QLatin1String("do")].toString();
    if (action == QLatin1String("open")) {
        m_peerName = request[QLatin1String("as")].toString().toStdString();
        const int length = request[QLatin1String("passphrase")].toInt();
        m_passphraseLength = std::clamp(length, 0, static_cast<int>(crypto::Passphrase::kMaxLength));
        if (m_passphraseLength == 0)
            open(nullptr);
    } else if (action == QLatin1String("confirm")) {
        confirm(request);
    } else if (action == QLatin1String("refuse")) {
        m_agent.refusePairing();
    }
}

void PairingServer::takePassphrase()
{
    const qint64 length = std::exchange(m_passphraseLength, 0);
    SecretBytes<crypto::Passphrase::kMaxLength> bytes;
    const MutableByteView room = bytes.mutableView();
    if (m_client->read(reinterpret_cast<char *>(room.data()), length) != length)
        return;
    if (auto passphrase = crypto::Passphrase::fromBytes(ByteView(room).first(static_cast<std::size_t>(length))))
        open(shareInLockedMemory(std::move(*passphrase)));
}

static const char *textOf(engine::PairingRefusal refusal)
{
    switch (refusal) {
    case engine::PairingRefusal::Armed: return "the vehicle is armed";
    case engine::PairingRefusal::OpenAlready: return "the pairing window is already open";
    }
    return "";
}

void PairingServer::open(std::shared_ptr<const crypto::Passphrase> passphrase)
{
    const auto opened = m_agent.openPairing(QSysInfo::machineHostName().toStdString(), std::move(passphrase));
    if (!opened) {
        notify(refusal(textOf(opened.error())));
        return;
    }
    PairingStatus status;
    status.state = PairingStatus::State::Open;
    status.key = m_agent.publicKey();
    status.seconds = static_cast<int>(std::chrono::duration_cast<std::chrono::seconds>(channel::kPairingWindow).count());
    notify(status);
}

void PairingServer::confirm(const QJsonObject &request)
{
    const auto key = keys::publicKeyFromText(request[QLatin1String("public")].toString().toStdString());
    const auto role = keys::peerRoleFromText(request[QLatin1String("role")].toString().toStdString());
    if (!key || !role)
        return;
    m_name = request[QLatin1String("name")].toString().toStdString();
    m_role = *role;
    m_replace = request[QLatin1String("replace")].toBool();
    m_agent.confirmPairing(*key);
}

void PairingServer::take(const channel::PairingEvent &event)
{
    if (const auto *paired = std::get_if<channel::Paired>(&event))
        return keep(paired->peer);
    m_files.run(
        this, [file = m_paths.peers] { return keys::PeersFile::loadOrEmpty(file).value_or(keys::PeersFile()); },
        [this, event, peerName = m_peerName](const keys::PeersFile &known) {
            if (const auto status = statusOf(event, known, peerName))
                notify(*status);
        });
}

void PairingServer::keep(channel::Peer peer)
{
    peer.name = keys::fitPeerName(m_name.empty() ? peer.name : m_name, peer.key);
    peer.role = m_role;
    std::string reason;
    // A station with the id of the vehicle would cut the vehicle off.
    if (std::ranges::any_of(peer.systemIds, [this](std::uint8_t id) { return m_agent.isVehicle(id); })) {
        reason = "its system ID " + keys::systemIdsText(peer.systemIds) + " is that of a vehicle here, and was not bound";
        peer.systemIds.clear();
    }
    const auto change = m_replace ? keys::KeyChange::Accepted : keys::KeyChange::Refused;
    m_files.run(
        this,
        [file = m_paths.peers, peer = std::move(peer), reason = std::move(reason), change] {
            return stored(file, peer, reason, change);
        },
        [this](const PairingStatus &status) { notify(status); });
}

void PairingServer::notify(const PairingStatus &status)
{
    m_say(status);
    if (m_client)
        write(*m_client, status);
}

} // namespace skyseal::app

#include "moc_pairing_server.cpp"
