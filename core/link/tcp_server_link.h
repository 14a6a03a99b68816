// TCP server: every client that connects is a path of its own, named by its address. There are 32 places. When all are
// taken, a new client gets the place of one that was of no use for some seconds; failing that, of one from a host that has
// more than its share, unless it comes from there itself. So neither idle connections nor one busy host keep others out.
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
    static constexpr std::ptrdiff_t kShareOfHost = 8; ///< when there is no room; before, a host may have as many as it likes

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
        std::optional<TimePoint> useful = std::nullopt; ///< last

        const Address &address() const { return peer->path().remote; }
        /// The least gives way first: who never was of use, then who no longer is.
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
