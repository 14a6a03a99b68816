#include "core/link/tcp_server_link.h"

#include "core/link/address_text.h"
#include "core/link/port_owner.h"
#include "core/link/socket_error.h"
#include "core/link/steady_now.h"

#include <QtCore/QVariant>
#include <QtNetwork/QNetworkProxy>

#include <algorithm>

namespace skyseal::link {

TcpServerLink::TcpServerLink(LinkUrl linkUrl, LinkId linkId, LinkListener &linkListener, LinkOptions linkOptions)
    : Link(std::move(linkUrl), linkId, linkListener, linkOptions)
{
    m_clients.reserve(kMostClients);
    m_server.setProxy(QNetworkProxy::NoProxy); // see TcpLink
    connect(&m_server, &QTcpServer::newConnection, this, &TcpServerLink::accept);
}

TcpServerLink::~TcpServerLink()
{
    for (const Client &client : m_clients)
        client.socket->disconnect(this);
}

std::optional<Address> TcpServerLink::localEndpoint() const
{
    return m_server.isListening() ? std::optional(fromQt(m_server.serverAddress(), m_server.serverPort())) : std::nullopt;
}

std::string TcpServerLink::localAddress() const
{
    const auto local = localEndpoint();
    return local ? toText(*local) : Link::localAddress();
}

void TcpServerLink::open()
{
    if (state() != LinkState::Closed && state() != LinkState::Failed)
        return;
    setState(LinkState::Opening);
    m_lookup.start(url().host(), url().port(), [this](std::optional<Address> address) { listen(address); });
}

void TcpServerLink::listen(std::optional<Address> address)
{
    if (!address) {
        setState(LinkState::Failed, {LinkErrorCode::HostUnknown, url().host(), {}});
        return;
    }
    const bool dualStack = !isIpv4(*address) && isAnyAddress(*address);
    if (!m_server.listen(dualStack ? QHostAddress(QHostAddress::Any) : toQt(*address), address->port)) {
        LinkError error = socketError(m_server.serverError(), m_server.errorString(), toText(*address));
        if (error.code == LinkErrorCode::PortInUse)
            error.detail = portOwnerText(PortKind::Tcp, address->port);
        setState(LinkState::Failed, std::move(error));
        return;
    }
    setState(LinkState::Listening);
}

void TcpServerLink::accept()
{
    while (QTcpSocket *socket = m_server.nextPendingConnection()) {
        if (m_clients.size() == kMostClients && !makeRoomFor(*socket)) {
            socket->abort();
            socket->deleteLater();
            if (state() == LinkState::Closed)
                return;
            continue;
        }
        socket->setReadBufferSize(kTcpReadBuffer);
        socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
        socket->setSocketOption(QAbstractSocket::KeepAliveOption, 1);
        const Path path{id(), fromQt(socket->peerAddress(), socket->peerPort())};
        m_clients.push_back({socket, std::make_shared<StreamPeer>(*socket, path, options().streamQueueBytes), steadyNow()});
        connect(socket, &QTcpSocket::readyRead, this, [this, socket] { receive(socket); });
        connect(socket, &QTcpSocket::disconnected, this, [this, socket] { drop(socket); });
        listener().linkPeerJoined(*this, path);
        if (state() == LinkState::Closed)
            return;
        receive(socket);
    }
}

/// Closes one connection to make room. Returns false when none may be replaced, or when the listener closed the link meanwhile.
bool TcpServerLink::makeRoomFor(const QTcpSocket &newcomer)
{
    auto victim = mostUseless();
    if (victim == m_clients.end())
        victim = mostUselessOfGreedyHost(fromQt(newcomer.peerAddress(), 0));
    if (victim == m_clients.end())
        return false;
    QTcpSocket *const socket = victim->socket;
    receive(socket); // deliver its last bytes
    socket->abort();
    drop(socket);
    return state() != LinkState::Closed && m_clients.size() < kMostClients;
}

std::vector<TcpServerLink::Client>::iterator TcpServerLink::mostUseless()
{
    const TimePoint since = steadyNow() - options().uselessAfter;
    auto found = m_clients.end();
    for (auto client = m_clients.begin(); client != m_clients.end(); ++client) {
        const bool useless = std::max(client->joined, client->useful.value_or(client->joined)) <= since;
        if (useless && (found == m_clients.end() || client->rank() < found->rank()))
            found = client;
    }
    return found;
}

std::vector<TcpServerLink::Client>::iterator TcpServerLink::mostUselessOfGreedyHost(const Address &newcomer)
{
    const auto clientsOf = [this](const Address &host) {
        return std::count_if(m_clients.begin(), m_clients.end(),
                             [&](const Client &client) { return isSameHost(client.address(), host); });
    };
    const auto greediest = std::max_element(m_clients.begin(), m_clients.end(), [&](const Client &a, const Client &b) {
        return clientsOf(a.address()) < clientsOf(b.address());
    });
    const auto had = clientsOf(greediest->address());
    if (had <= kShareOfHost || clientsOf(newcomer) >= had - 1)
        return m_clients.end();
    auto found = greediest;
    for (auto client = m_clients.begin(); client != m_clients.end(); ++client) {
        if (isSameHost(client->address(), greediest->address()) && client->rank() < found->rank())
            found = client;
    }
    return found;
}

void TcpServerLink::noteUse(const Address &from)
{
    for (Client &client : m_clients) {
        if (client.address() == from)
            client.useful = steadyNow();
    }
}

std::vector<TcpServerLink::Client>::iterator TcpServerLink::find(QTcpSocket *socket)
{
    return std::find_if(m_clients.begin(), m_clients.end(), [&](const Client &client) { return client.socket == socket; });
}

void TcpServerLink::receive(QTcpSocket *socket)
{
    const auto client = find(socket);
    if (client == m_clients.end())
        return;
    // The copy keeps the peer alive when the listener closes the link.
    const std::shared_ptr<StreamPeer> peer = client->peer;
    peer->receive(*this, listener(), m_counters);
}

void TcpServerLink::drop(QTcpSocket *socket)
{
    receive(socket);
    const auto client = find(socket);
    if (client == m_clients.end())
        return;
    const Path path = client->peer->path();
    m_clients.erase(client);
    socket->disconnect(this);
    socket->deleteLater();
    listener().linkPeerLeft(*this, path);
}

void TcpServerLink::send(const Address &to, ByteView block)
{
    bool found = false;
    for (const Client &client : m_clients) {
        if (to != Address{} && client.peer->path().remote != to)
            continue;
        client.peer->send(block, m_counters);
        found = true;
    }
    if (!found)
        ++m_counters.txDropped;
}

void TcpServerLink::flush()
{
    for (const Client &client : m_clients)
        client.peer->flush(m_counters);
}

void TcpServerLink::close()
{
    if (state() == LinkState::Closed)
        return;
    m_lookup.abort();
    m_server.close();
    flush();
    setState(LinkState::Closed);
    const std::vector<Client> clients = std::exchange(m_clients, {});
    for (const Client &client : clients) {
        client.socket->disconnect(this);
        // Flushed bytes are still sent; the socket deletes itself afterwards.
        client.socket->setParent(nullptr);
        connect(client.socket, &QTcpSocket::disconnected, client.socket, &QObject::deleteLater);
        client.socket->disconnectFromHost();
        listener().linkPeerLeft(*this, client.peer->path());
    }
}

} // namespace skyseal::link

#include "moc_tcp_server_link.cpp"
