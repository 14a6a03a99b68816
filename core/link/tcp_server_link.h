// TCP server: every client that connects is a path of its own, named by its address.
#pragma once

#include "core/link/host_lookup.h"
#include "core/link/stream_peer.h"

#include <QtNetwork/QTcpServer>
#include <QtNetwork/QTcpSocket>

#include <memory>
#include <vector>

namespace skyseal::link {

class TcpServerLink final : public Link
{
    Q_OBJECT

public:
    static constexpr std::size_t kMostClients = 32;

    TcpServerLink(LinkUrl url, LinkId id, LinkListener &listener, LinkOptions options);
    ~TcpServerLink() override;

    bool isStream() const override { return true; }
    std::optional<Address> localEndpoint() const override;
    std::string localAddress() const override;
    std::size_t clients() const { return m_clients.size(); }

    void open() override;
    void close() override;
    /// The all-zero address sends to every client.
    void send(const Address &to, ByteView block) override;
    void flush() override;

private:
    struct Client
    {
        QTcpSocket *socket; ///< child of the server
        std::shared_ptr<StreamPeer> peer;
    };

    void listen(std::optional<Address> address);
    void accept();
    void receive(QTcpSocket *socket);
    void drop(QTcpSocket *socket);
    std::vector<Client>::iterator find(QTcpSocket *socket);

    QTcpServer m_server;
    HostLookup m_lookup;
    std::vector<Client> m_clients;
};

} // namespace skyseal::link
