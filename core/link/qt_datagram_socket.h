// UDP by QUdpSocket, for systems without recvmmsg. Same behaviour as BatchSocket, one system call per datagram.
#pragma once

#include "core/link/datagram_socket.h"

#include <QtNetwork/QUdpSocket>

namespace skyseal::link {

class QtDatagramSocket final : public DatagramSocket
{
    Q_OBJECT

public:
    QtDatagramSocket();
    ~QtDatagramSocket() override;

    std::optional<LinkError> bind(const Address &local, int receiveBufferBytes) override;
    Address local() const override;
    void shut() override { m_socket.abort(); }
    Batch receive(LinkId id, LinkCounters &counters, std::size_t most) override;
    void send(const Address &to, ByteView datagram, LinkCounters &counters) override;
    void flush(LinkCounters &) override {}

private:
    struct Buffers;

    QUdpSocket m_socket;
    bool m_ipv6 = false;
    std::unique_ptr<Buffers> m_buffers;
};

} // namespace skyseal::link
