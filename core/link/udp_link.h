// UDP link. udpin binds a port and reports the address of each sender; udpout sends to one remote, whose name is resolved
// without blocking, and again after sending failed. A remote that is not reachable yet is not an error: datagrams to it are
// lost.
#pragma once

#include "core/link/backoff.h"
#include "core/link/datagram_socket.h"
#include "core/link/host_lookup.h"

#include <QtCore/QTimer>

namespace skyseal::link {

class UdpLink final : public Link, private DatagramSocket::Listener
{
    Q_OBJECT

public:
    UdpLink(LinkUrl url, LinkId id, LinkListener &listener, LinkOptions options);

    std::optional<Address> localEndpoint() const override;
    std::string localAddress() const override;
    Address remote() const override { return m_remote; }
    LinkCounters counters() const override;

    void open() override;
    void close() override;
    void send(const Address &to, ByteView block) override;
    void flush() override;

private:
    void start();
    void use(const Address &address);
    void socketReadable() override;
    void socketWritable() override { flush(); }
    void checkRoute(std::uint64_t errorsBefore);
    void dropSocket();

    std::unique_ptr<DatagramSocket> m_socket;
    /// Smaller batches would be dominated by the cost of the wake-up. More than usually arrives at once.
    static constexpr std::size_t kLeastBatch = 12;

    std::size_t m_batch = kLeastBatch; ///< size of the next batch, by the measured cost of a datagram
    Address m_remote;
    std::uint64_t m_earlierDrops = 0; ///< kernel drops of previous sockets
    HostLookup m_lookup;
    QTimer m_retryTimer;
    Backoff m_backoff;
};

} // namespace skyseal::link
