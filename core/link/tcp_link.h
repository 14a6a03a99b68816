// TCP client. Connects again with a growing delay (Backoff) after the peer refused or closed the connection.
#pragma once

#include "core/link/backoff.h"
#include "core/link/stream_peer.h"

#include <QtCore/QTimer>
#include <QtNetwork/QTcpSocket>

#include <memory>

namespace skyseal::link {

class TcpLink final : public Link
{
    Q_OBJECT

public:
    TcpLink(LinkUrl url, LinkId id, LinkListener &listener, LinkOptions options);
    ~TcpLink() override;

    std::optional<Address> localEndpoint() const override;
    std::string localAddress() const override;
    Address remote() const override { return m_peer ? m_peer->path().remote : Address{}; }

    void open() override;
    void close() override;
    void send(const Address &to, ByteView block) override;
    void flush() override;

private:
    void connectNow();
    void connected();
    void lost();
    void dropPeer();

    QTcpSocket m_socket;
    QTimer m_retryTimer;
    Backoff m_backoff;
    std::unique_ptr<StreamPeer> m_peer; ///< while connected
};

} // namespace skyseal::link
