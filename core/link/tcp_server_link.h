// TCP server. Each client is a separate path, with the client's address. At most 32 clients are served. When all places are
// taken, a new client replaces one that has sent nothing useful (Link::noteUse()) for some seconds, otherwise one of a host
// that holds more than its share, unless the new client comes from that host. Thus neither idle connections nor one busy host
// can exclude others.
#pragma once

#include "core/link/host_lookup.h"
#include "core/link/stream_peer.h"

#include <QtNetwork/QTcpServer>
#include <QtNetwork/QTcpSocket>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace skyseal::link {

class TcpServerLink final : public Link
{
    Q_OBJECT

public:
    static constexpr std::size_t kMostClients = 32;
    static constexpr std::ptrdiff_t kShareOfHost = 8; ///< applies only when all places are taken

    TcpServerLink(LinkUrl url, LinkId id, LinkListener &listener, LinkOptions options);
    ~TcpServerLink() override;

    std::optional<Address> localEndpoint() const override;
    std::string localAddress() const override;
    std::size_t clients() const { return m_clients.size(); }

    void open() override;
    void close() override;
    /// The all-zero address sends to every client.
    void send(const Address &to, ByteView block) override;
    void flush() override;
    void noteUse(const Address &from) override;

private:
    struct Client
    {
        QTcpSocket *socket; ///< child of the server
        std::shared_ptr<StreamPeer> peer;
        TimePoint joined{};
        std::optional<TimePoint> useful = std::nullopt; ///< last call of noteUse()

        const Address &address() const { return peer->path().remote; }
        /// The client with the lowest rank is replaced first: one that was never useful, then the one that was useful the
        /// longest time ago.
        auto rank() const { return std::pair(useful, joined); }
    };

    void listen(std::optional<Address> address);
    void accept();
    bool makeRoomFor(const QTcpSocket &newcomer);
    std::vector<Client>::iterator mostUseless();
    std::vector<Client>::iterator mostUselessOfGreedyHost(const Address &newcomer);
    void receive(QTcpSocket *socket);
    void drop(QTcpSocket *socket);
    std::vector<Client>::iterator find(QTcpSocket *socket);

    QTcpServer m_server;
    HostLookup m_lookup;
    std::vector<Client> m_clients;
};

} // namespace skyseal::link
