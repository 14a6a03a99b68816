// TCP links over the loopback interface: reconnection, several clients at once, limits of the server.
#include "core/link/address_text.h"
#include "core/link/tcp_link.h"
#include "core/link/tcp_server_link.h"
#include "tests/link/block_recorder.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtNetwork/QNetworkProxy>
#include <QtNetwork/QTcpServer>
#include <QtNetwork/QTcpSocket>
#include <QtTest/QTest>

#include <numeric>

using namespace skyseal;
using namespace skyseal::link;
using namespace skyseal::test;

class TcpLinkTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void carriesBothWays();
    void bulkArrivesCompleteAndInOrder();
    void retriesUntilTheServerListens();
    void closedPeerIsReportedAndReconnects();
    void bytesBeforeTheEndAreDelivered();
    void serverKeepsClientsApart();
    void serverRefusesTooManyClients();
    void uselessClientsAreReplaced();
    void oneHostCannotTakeAllPlaces();
    void portInUseFails();
    void unknownHostIsReported();
    void fullQueueDropsWholeBlocks();
    void listenerMayCloseEitherEnd();
    void closeSendsWhatWasQueued();
    void desktopProxyIsIgnored();
};

static LinkOptions quick()
{
    LinkOptions out;
    out.retryFirst = std::chrono::milliseconds(20);
    out.retryMax = std::chrono::milliseconds(50);
    return out;
}

void TcpLinkTest::carriesBothWays()
{
    BlockRecorder server;
    BlockRecorder client;
    const auto in = openLink("tcpin:127.0.0.1:0", server, quick(), LinkId{3});
    QCOMPARE(in->state(), LinkState::Listening);
    QVERIFY(in->isStream());
    const auto out = openLink("tcp:" + in->localAddress(), client, quick(), LinkId{4});
    QCOMPARE(out->state(), LinkState::Opening);
    EVENTUALLY_EQUAL(out->state(), LinkState::Connected);
    EVENTUALLY_EQUAL(server.joined.size(), std::size_t(1));
    QCOMPARE(client.joined, (std::vector<Path>{{LinkId{4}, *in->localEndpoint()}}));
    QCOMPARE(server.joined[0], (Path{LinkId{3}, *out->localEndpoint()}));
    QCOMPARE(toText(out->remote()), in->localAddress());

    out->send({}, asBytes("up"));
    out->send({}, asBytes("link"));
    out->flush();
    EVENTUALLY_EQUAL(server.stream(), std::string("uplink"));
    in->send(server.joined[0].remote, asBytes("down"));
    in->flush();
    EVENTUALLY_EQUAL(client.stream(), std::string("down"));
    QCOMPARE(out->counters().txBlocks, std::uint64_t(2));
    QCOMPARE(out->counters().txBytes, std::uint64_t(6));
    QCOMPARE(in->counters().rxBytes, std::uint64_t(6));
}

void TcpLinkTest::bulkArrivesCompleteAndInOrder()
{
    BlockRecorder server;
    BlockRecorder client;
    const auto in = openLink("tcpin:127.0.0.1:0", server, quick());
    const auto out = openLink("tcp:" + in->localAddress(), client, quick());
    EVENTUALLY_EQUAL(out->state(), LinkState::Connected);
    std::string expected;
    for (int i = 0; i < 20'000; ++i) {
        const std::string line = "frame " + std::to_string(i) + "\n";
        expected += line;
        out->send({}, asBytes(line));
        if (i % 1000 == 999) {
            out->flush();
            EVENTUALLY_EQUAL(in->counters().rxBytes, std::uint64_t(expected.size()));
        }
    }
    QVERIFY(server.stream() == expected);
    QCOMPARE(out->counters().txDropped, std::uint64_t(0));
}

void TcpLinkTest::retriesUntilTheServerListens()
{
    BlockRecorder server;
    BlockRecorder client;
    auto in = openLink("tcpin:127.0.0.1:0", server, quick());
    const std::string address = in->localAddress();
    in->close();
    const auto out = openLink("tcp:" + address, client, quick());
    EVENTUALLY_EQUAL(out->state(), LinkState::Waiting);
    QCOMPARE(out->error().code, LinkErrorCode::Refused);
    QCOMPARE(out->error().sentence(), address + " refuses the connection (nothing listens there)");
    in = openLink("tcpin:" + address, server, quick());
    QCOMPARE(in->state(), LinkState::Listening);
    EVENTUALLY_EQUAL(out->state(), LinkState::Connected);
    QCOMPARE(out->error().code, LinkErrorCode::None);
}

void TcpLinkTest::closedPeerIsReportedAndReconnects()
{
    BlockRecorder server;
    BlockRecorder client;
    auto in = openLink("tcpin:127.0.0.1:0", server, quick());
    const std::string address = in->localAddress();
    const auto out = openLink("tcp:" + address, client, quick());
    EVENTUALLY_EQUAL(out->state(), LinkState::Connected);
    EVENTUALLY_EQUAL(server.joined.size(), std::size_t(1));
    std::vector<LinkState> states;
    std::vector<LinkErrorCode> reasons;
    connect(out.get(), &Link::stateChanged, this, [&](LinkState state) {
        states.push_back(state);
        reasons.push_back(out->error().code);
    });
    in->close();
    EVENTUALLY_EQUAL(client.left.size(), std::size_t(1));
    EVENTUALLY_EQUAL(out->state(), LinkState::Waiting);
    QCOMPARE(reasons.front(), LinkErrorCode::PeerClosed);
    out->send({}, asBytes("lost"));
    QCOMPARE(out->counters().txDropped, std::uint64_t(1));

    in = openLink("tcpin:" + address, server, quick());
    QCOMPARE(in->state(), LinkState::Listening);
    EVENTUALLY_EQUAL(out->state(), LinkState::Connected);
    QCOMPARE(client.joined.size(), std::size_t(2));
    out->send({}, asBytes("again"));
    out->flush();
    EVENTUALLY_EQUAL(server.stream(), std::string("again"));
}

void TcpLinkTest::bytesBeforeTheEndAreDelivered()
{
    BlockRecorder server;
    const auto in = openLink("tcpin:127.0.0.1:0", server, quick());
    QTcpSocket socket;
    socket.connectToHost(QHostAddress(QHostAddress::LocalHost), in->localEndpoint()->port);
    QVERIFY(socket.waitForConnected(kDeadlineMs));
    socket.write("last words");
    socket.disconnectFromHost();
    EVENTUALLY_EQUAL(server.left.size(), std::size_t(1));
    QCOMPARE(server.stream(), std::string("last words"));
    QCOMPARE(server.left, server.joined);
    QCOMPARE(in->state(), LinkState::Listening);
}

void TcpLinkTest::serverKeepsClientsApart()
{
    BlockRecorder server;
    const auto in = openLink("tcpin:127.0.0.1:0", server, quick());
    std::array<BlockRecorder, 3> clients;
    std::vector<std::unique_ptr<Link>> links;
    for (BlockRecorder &client : clients) {
        links.push_back(openLink("tcp:" + in->localAddress(), client, quick()));
        EVENTUALLY_EQUAL(links.back()->state(), LinkState::Connected);
        EVENTUALLY_EQUAL(server.joined.size(), links.size());
    }
    for (std::size_t i = 0; i < links.size(); ++i) {
        links[i]->send({}, asBytes(std::to_string(i)));
        links[i]->flush();
    }
    EVENTUALLY_EQUAL(server.blocks.size(), std::size_t(3));
    for (const BlockRecorder::Block &block : server.blocks) {
        const auto index = static_cast<std::size_t>(std::stoi(std::string(asText(block.bytes))));
        QCOMPARE(block.path.remote, *links[index]->localEndpoint());
        in->send(block.path.remote, asBytes("to " + std::to_string(index)));
    }
    in->send({}, asBytes(" and all"));
    in->flush();
    for (std::size_t i = 0; i < links.size(); ++i)
        EVENTUALLY_EQUAL(clients[i].stream(), "to " + std::to_string(i) + " and all");

    links[1]->close();
    EVENTUALLY_EQUAL(server.left, (std::vector<Path>{server.joined[1]}));
    in->send(server.joined[1].remote, asBytes("gone"));
    QCOMPARE(in->counters().txDropped, std::uint64_t(1));
    links[2]->send({}, asBytes("still here"));
    links[2]->flush();
    EVENTUALLY_EQUAL(asText(server.blocks.back().bytes), std::string_view("still here"));
}

void TcpLinkTest::serverRefusesTooManyClients()
{
    BlockRecorder server;
    const auto in = openLink("tcpin:127.0.0.1:0", server, quick());
    std::vector<std::unique_ptr<QTcpSocket>> sockets;
    for (std::size_t i = 0; i < TcpServerLink::kMostClients + 1; ++i) {
        sockets.push_back(std::make_unique<QTcpSocket>());
        sockets.back()->connectToHost(QHostAddress(QHostAddress::LocalHost), in->localEndpoint()->port);
        QVERIFY(sockets.back()->waitForConnected(kDeadlineMs));
    }
    EVENTUALLY_EQUAL(sockets.back()->state(), QAbstractSocket::UnconnectedState);
    QCOMPARE(server.joined.size(), TcpServerLink::kMostClients);
    QCOMPARE(sockets.front()->state(), QAbstractSocket::ConnectedState);
}

namespace {

/// Connects from the given local address.
std::unique_ptr<QTcpSocket> clientOf(const Link &server, const char *from = "127.0.0.1")
{
    auto socket = std::make_unique<QTcpSocket>();
    socket->bind(QHostAddress(QLatin1String(from)));
    socket->connectToHost(QHostAddress(QHostAddress::LocalHost), server.localEndpoint()->port);
    return socket->waitForConnected(kDeadlineMs) ? std::move(socket) : nullptr;
}

bool isOut(const QTcpSocket &socket)
{
    return socket.state() == QAbstractSocket::UnconnectedState;
}

} // namespace

void TcpLinkTest::uselessClientsAreReplaced()
{
    LinkOptions options = quick();
    options.uselessAfter = Duration::zero();
    BlockRecorder server;
    const auto in = openLink("tcpin:127.0.0.1:0", server, options);
    std::vector<std::unique_ptr<QTcpSocket>> sockets;
    const auto add = [&] {
        sockets.push_back(clientOf(*in));
        QVERIFY(sockets.back());
        EVENTUALLY_EQUAL(server.joined.size(), sockets.size());
    };
    for (std::size_t i = 0; i < TcpServerLink::kMostClients; ++i)
        add();
    // Two clients were never useful; of the others the tenth was useful the longest time ago.
    for (std::size_t i = 0; i < sockets.size(); ++i) {
        if (i != 5 && i != 20)
            in->noteUse(server.joined[i].remote);
    }
    for (std::size_t i = 0; i < sockets.size(); ++i) {
        if (i != 5 && i != 20 && i != 10)
            in->noteUse(server.joined[i].remote);
    }
    for (const std::size_t gone : {5u, 20u}) {
        add();
        in->noteUse(server.joined.back().remote);
        EVENTUALLY(isOut(*sockets[gone]));
        QCOMPARE(server.left.back(), server.joined[gone]);
    }
    add();
    EVENTUALLY(isOut(*sockets[10]));
    QCOMPARE(server.left.back(), server.joined[10]);
    QCOMPARE(server.left.size(), std::size_t(3));
    QCOMPARE(static_cast<const TcpServerLink &>(*in).clients(), TcpServerLink::kMostClients);
    sockets.back()->write("here"); // the new clients are served
    sockets.back()->flush();
    EVENTUALLY_EQUAL(server.stream(), std::string("here"));
}

void TcpLinkTest::oneHostCannotTakeAllPlaces()
{
    BlockRecorder server;
    const auto in = openLink("tcpin:127.0.0.1:0", server, quick());
    std::vector<std::unique_ptr<QTcpSocket>> sockets;
    for (std::size_t i = 0; i < TcpServerLink::kMostClients; ++i) {
        sockets.push_back(clientOf(*in));
        QVERIFY(sockets.back());
        EVENTUALLY_EQUAL(server.joined.size(), sockets.size());
        in->noteUse(server.joined.back().remote); // all of them are useful
    }
    const auto other = clientOf(*in, "127.0.0.2");
    QVERIFY(other);
    EVENTUALLY(isOut(*sockets.front()));
    QCOMPARE(server.joined.size(), TcpServerLink::kMostClients + 1);
    // A further client of the first host is refused.
    const auto again = clientOf(*in);
    QVERIFY(again);
    EVENTUALLY(isOut(*again));
    QCOMPARE(server.joined.size(), TcpServerLink::kMostClients + 1);
    QVERIFY(!isOut(*other) && !isOut(*sockets.back()));
    // Clients of other hosts are accepted until the first host is down to its share.
    std::vector<std::unique_ptr<QTcpSocket>> more;
    for (std::ptrdiff_t i = 0; i < 40; ++i)
        more.push_back(clientOf(*in, qPrintable(QStringLiteral("127.0.0.%1").arg(10 + i))));
    const auto firstsLeft = [&] {
        return std::count_if(sockets.begin(), sockets.end(), [](const auto &socket) { return !isOut(*socket); });
    };
    EVENTUALLY_EQUAL(firstsLeft(), TcpServerLink::kShareOfHost);
}

void TcpLinkTest::portInUseFails()
{
    BlockRecorder server;
    const auto first = openLink("tcpin:127.0.0.1:0", server, quick());
    const auto second = openLink("tcpin:" + first->localAddress(), server, quick());
    QCOMPARE(second->state(), LinkState::Failed);
    QCOMPARE(second->error().code, LinkErrorCode::PortInUse);
    QCOMPARE(second->localAddress(), first->localAddress());
    QVERIFY2(second->error().detail.text().starts_with("link_tests (process "), second->error().detail.text().c_str());
    first->close();
    second->open();
    QCOMPARE(second->state(), LinkState::Listening);
}

void TcpLinkTest::unknownHostIsReported()
{
    BlockRecorder client;
    const auto out = openLink("tcp:no-such-host.invalid:5760", client, quick());
    EVENTUALLY_EQUAL(out->state(), LinkState::Waiting);
    QCOMPARE(out->error().code, LinkErrorCode::HostUnknown);
    QCOMPARE(out->error().sentence(), std::string("the host name \"no-such-host.invalid\" is not known"));
}

void TcpLinkTest::fullQueueDropsWholeBlocks()
{
    BlockRecorder server;
    BlockRecorder client;
    LinkOptions small = quick();
    small.streamQueueBytes = 1000;
    const auto in = openLink("tcpin:127.0.0.1:0", server, quick());
    const auto out = openLink("tcp:" + in->localAddress(), client, small);
    EVENTUALLY_EQUAL(out->state(), LinkState::Connected);
    const std::string block(300, 'x');
    for (int i = 0; i < 5; ++i)
        out->send({}, asBytes(block));
    QCOMPARE(out->counters().txBlocks, std::uint64_t(3));
    QCOMPARE(out->counters().txDropped, std::uint64_t(2));
    out->flush();
    EVENTUALLY_EQUAL(server.stream().size(), std::size_t(900));
    out->send({}, asBytes(block));
    out->flush();
    EVENTUALLY_EQUAL(server.stream().size(), std::size_t(1200));
}

void TcpLinkTest::listenerMayCloseEitherEnd()
{
    BlockRecorder server;
    BlockRecorder client;
    const auto in = openLink("tcpin:127.0.0.1:0", server, quick());
    const auto out = openLink("tcp:" + in->localAddress(), client, quick());
    EVENTUALLY_EQUAL(server.joined.size(), std::size_t(1));
    client.onReceived = [](Link &link) { link.close(); };
    in->send({}, asBytes("stop"));
    in->flush();
    EVENTUALLY_EQUAL(out->state(), LinkState::Closed);
    EVENTUALLY_EQUAL(server.left.size(), std::size_t(1));

    client.onReceived = {};
    out->open();
    EVENTUALLY_EQUAL(server.joined.size(), std::size_t(2));
    server.onReceived = [](Link &link) { link.close(); };
    EVENTUALLY_EQUAL(out->state(), LinkState::Connected);
    out->send({}, asBytes("stop"));
    out->flush();
    EVENTUALLY_EQUAL(in->state(), LinkState::Closed);
    EVENTUALLY_EQUAL(out->state(), LinkState::Waiting);
    out->close();
    QCOMPARE(client.joined.size(), client.left.size());
    QCOMPARE(server.joined.size(), server.left.size());
}

void TcpLinkTest::closeSendsWhatWasQueued()
{
    BlockRecorder server;
    BlockRecorder client;
    const auto in = openLink("tcpin:127.0.0.1:0", server, quick());
    const auto out = openLink("tcp:" + in->localAddress(), client, quick());
    EVENTUALLY_EQUAL(out->state(), LinkState::Connected);
    out->send({}, asBytes("goodbye"));
    out->close();
    EVENTUALLY_EQUAL(server.left.size(), std::size_t(1));
    QCOMPARE(server.stream(), std::string("goodbye"));
}

void TcpLinkTest::desktopProxyIsIgnored()
{
    QTcpServer proxy;
    QVERIFY(proxy.listen(QHostAddress::LocalHost));
    QNetworkProxy::setApplicationProxy({QNetworkProxy::Socks5Proxy, QStringLiteral("127.0.0.1"), proxy.serverPort()});
    const auto back = qScopeGuard([] { QNetworkProxy::setApplicationProxy(QNetworkProxy::NoProxy); });
    BlockRecorder server;
    BlockRecorder client;
    const auto in = openLink("tcpin:127.0.0.1:0", server, quick());
    QCOMPARE(in->state(), LinkState::Listening);
    const auto out = openLink("tcp:" + in->localAddress(), client, quick());
    EVENTUALLY_EQUAL(out->state(), LinkState::Connected);
    out->send({}, asBytes("hello"));
    out->flush();
    EVENTUALLY_EQUAL(server.stream(), std::string("hello"));
    QVERIFY(!proxy.hasPendingConnections());
}

SKYSEAL_TEST(TcpLinkTest)
#include "tcp_link_test.moc"
