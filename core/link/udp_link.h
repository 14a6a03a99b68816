// UDP, both ways: udpin binds a port and reports who sends; udpout sends to one remote, whose name is looked up without
// blocking and looked up again when sending fails. A remote that is not there yet is no error: datagrams to it vanish.
#pragma once

#include "core/link/backoff.h"
#include "core/link/datagram_socket.h"
#include "core/link/host_lookup.h"

#include <QtCore/QTimer>

namespace skyseal::link {

class UdpLink final : public Link
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
    void receive();
    void checkRoute(std::uint64_t errorsBefore);
    void dropSocket();

    std::unique_ptr<DatagramSocket> m_socket;
    /// A turn of fewer would go into waking up.
    static constexpr std::size_t kLeastBatch = 8;

    std::size_t m_batch = DatagramSocket::kBatch; ///< datagrams for the next batch
    Address m_remote;
    std::uint64_t m_earlierDrops = 0; ///< of sockets that are gone
    HostLookup m_lookup;
    QTimer m_retryTimer;
    Backoff m_backoff;
};

} // namespace skyseal::link
