#include "core/link/tcp_link.h"

#include "core/link/address_text.h"
#include "core/link/socket_error.h"

#include <QtCore/QVariant>
#include <QtNetwork/QNetworkProxy>

namespace skyseal::link {

TcpLink::TcpLink(LinkUrl linkUrl, LinkId linkId, LinkListener &linkListener, LinkOptions linkOptions)
    : Link(std::move(linkUrl), linkId, linkListener, linkOptions), m_backoff(options().retryFirst, options().retryMax)
{
    // The desktop's proxy settings are meant for browsers; MAVLink must not pass through such a proxy.
    m_socket.setProxy(QNetworkProxy::NoProxy);
    m_socket.setReadBufferSize(kTcpReadBuffer);
    m_retryTimer.setSingleShot(true);
    connect(&m_retryTimer, &QTimer::timeout, this, &TcpLink::connectNow);
    connect(&m_socket, &QTcpSocket::connected, this, &TcpLink::connected);
    connect(&m_socket, &QTcpSocket::errorOccurred, this, &TcpLink::lost);
    connect(&m_socket, &QTcpSocket::readyRead, this, [this] {
        if (m_peer)
            m_peer->receive(*this, listener(), m_counters);
    });
}

TcpLink::~TcpLink()
{
    m_socket.disconnect(this);
}

std::optional<Address> TcpLink::localEndpoint() const
{
    return m_peer ? std::optional(fromQt(m_socket.localAddress(), m_socket.localPort())) : std::nullopt;
}

std::string TcpLink::localAddress() const
{
    const auto local = localEndpoint();
    return local ? toText(*local) : std::string();
}

void TcpLink::open()
{
    if (state() != LinkState::Closed && state() != LinkState::Failed)
        return;
    m_backoff.reset();
    setState(LinkState::Opening);
    connectNow();
}

void TcpLink::connectNow()
{
    m_socket.abort();
    m_socket.connectToHost(QString::fromStdString(url().host()), url().port());
}

void TcpLink::connected()
{
    m_socket.setSocketOption(QAbstractSocket::LowDelayOption, 1);
    m_socket.setSocketOption(QAbstractSocket::KeepAliveOption, 1);
    m_backoff.reset();
    const Path path{id(), fromQt(m_socket.peerAddress(), m_socket.peerPort())};
    m_peer = std::make_unique<StreamPeer>(m_socket, path, options().streamQueueBytes);
    setState(LinkState::Connected);
    listener().linkPeerJoined(*this, path);
}

void TcpLink::lost()
{
    if (state() == LinkState::Closed)
        return;
    const std::string subject = url().host() + ":" + std::to_string(url().port());
    LinkError error = socketError(m_socket, m_socket.error() == QAbstractSocket::HostNotFoundError ? url().host() : subject);
    // Deliver the bytes that arrived before the connection ended.
    if (m_peer && !m_peer->receive(*this, listener(), m_counters))
        return;
    dropPeer();
    if (state() == LinkState::Closed)
        return;
    setState(LinkState::Waiting, std::move(error));
    m_retryTimer.start(std::chrono::duration_cast<std::chrono::milliseconds>(m_backoff.next()));
}

void TcpLink::dropPeer()
{
    if (!m_peer)
        return;
    const Path path = m_peer->path();
    m_peer.reset();
    listener().linkPeerLeft(*this, path);
}

void TcpLink::send(const Address &, ByteView block)
{
    if (m_peer)
        m_peer->send(block, m_counters);
    else
        ++m_counters.txDropped;
}

void TcpLink::flush()
{
    if (m_peer)
        m_peer->flush(m_counters);
}

void TcpLink::close()
{
    if (state() == LinkState::Closed)
        return;
    m_retryTimer.stop();
    flush();
    setState(LinkState::Closed);
    dropPeer();
    m_socket.disconnectFromHost();
}

} // namespace skyseal::link

#include "moc_tcp_link.cpp"
