// UDP links over the loopback, each case with the batching socket and with QUdpSocket: both must behave alike.
#include "core/link/address_text.h"
#include "core/link/steady_now.h"
#include "core/link/udp_link.h"
#include "tests/link/block_recorder.h"
#include "tests/support/eventually.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtNetwork/QNetworkProxy>
#include <QtNetwork/QTcpServer>
#include <QtNetwork/QUdpSocket>
#include <QtTest/QTest>

#include <numeric>

using namespace skyseal;
using namespace skyseal::link;
using namespace skyseal::test;

class UdpLinkTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase_data();
    void carriesBothWays();
    void tenThousandDatagramsArriveCompleteAndInOrder();
    void datagramsOfAnySizesKeepTheirBounds();
    void carriesIpv6();
    void dualStackReportsIpv4AsIpv4();
    void portInUseFailsAndOpensWhenFree();
    void foreignAddressIsReported();
    void unknownHostIsReportedAndRetried();
    void hostNameIsLookedUp();
    void absentPeerDoesNotCloseTheLink();
    void oversizedDatagramsAreCountedAndDropped();
    void floodLeavesRoomForTimers();
    void expensiveDatagramsDoNotDelayOtherLinks();
    void listenerMayCloseTheLink();
    void receivedBytesMayBeChangedInPlace();
    void sendWithoutPeerIsCounted();
    void desktopProxyIsIgnored();

private:
    static LinkOptions options()
    {
        QFETCH_GLOBAL(bool, portable);
        LinkOptions out;
        out.portableUdp = portable;
        QFETCH_GLOBAL(bool, segmented);
        out.segmentedUdp = segmented;
        out.retryFirst = std::chrono::milliseconds(20);
        return out;
    }
};

static ByteView text(std::string_view words)
{
    return asBytes(words);
}

void UdpLinkTest::initTestCase_data()
{
    QTest::addColumn<bool>("portable");
    QTest::addColumn<bool>("segmented");
    QTest::newRow("batch") << false << false;
    QTest::newRow("segmented") << false << true;
    QTest::newRow("qt") << true << false;
}

void UdpLinkTest::carriesBothWays()
{
    BlockRecorder ground;
    BlockRecorder air;
    const auto in = openLink("udpin:127.0.0.1:0", ground, options(), LinkId{7});
    QCOMPARE(in->state(), LinkState::Listening);
    QCOMPARE(in->localAddress(), "127.0.0.1:" + portOf(*in));
    const auto out = openLink("udpout:127.0.0.1:" + portOf(*in), air, options(), LinkId{8});
    QCOMPARE(out->state(), LinkState::Connected);
    QCOMPARE(toText(out->remote()), in->localAddress());

    out->send({}, text("hello"));
    out->send(out->remote(), text("again"));
    out->flush();
    EVENTUALLY_EQUAL(ground.blocks.size(), std::size_t(2));
    QCOMPARE(ground.stream(), std::string("helloagain"));
    const Path from = ground.blocks[0].path;
    QCOMPARE(from.link, LinkId{7});
    QCOMPARE(from.remote.port, out->localEndpoint()->port);
    QVERIFY(isIpv4(from.remote));

    in->send(from.remote, text("answer"));
    in->flush();
    EVENTUALLY_EQUAL(air.stream(), std::string("answer"));
    QCOMPARE(air.blocks[0].path, (Path{LinkId{8}, *in->localEndpoint()}));
    QCOMPARE(out->counters().txBlocks, std::uint64_t(2));
    QCOMPARE(out->counters().txBytes, std::uint64_t(10));
    QCOMPARE(in->counters().rxBlocks, std::uint64_t(2));
    QCOMPARE(in->counters().rxBytes, std::uint64_t(10));
}

void UdpLinkTest::tenThousandDatagramsArriveCompleteAndInOrder()
{
    BlockRecorder ground;
    BlockRecorder air;
    const auto in = openLink("udpin:127.0.0.1:0", ground, options());
    const auto out = openLink("udpout:127.0.0.1:" + portOf(*in), air, options());
    constexpr std::uint32_t kCount = 10'000;
    std::vector<std::uint8_t> datagram(40);
    for (std::uint32_t i = 0; i < kCount; ++i) {
        for (std::size_t byte = 0; byte < 4; ++byte)
            datagram[byte] = static_cast<std::uint8_t>(i >> (8 * byte));
        out->send({}, datagram);
        // Let the receiver run before the system's buffer is full; its size is not under the test's control.
        if (i % 512 == 511) {
            out->flush();
            EVENTUALLY_EQUAL(ground.blocks.size(), std::size_t(i + 1));
        }
    }
    out->flush();
    EVENTUALLY_EQUAL(ground.blocks.size(), std::size_t(kCount));
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const Bytes &bytes = ground.blocks[i].bytes;
        QCOMPARE(bytes.size(), datagram.size());
        QCOMPARE(std::uint32_t(bytes[0] | bytes[1] << 8 | bytes[2] << 16 | bytes[3] << 24), i);
    }
    QCOMPARE(in->counters().rxBlocks, std::uint64_t(kCount));
    QCOMPARE(in->counters().rxBytes, std::uint64_t(kCount * datagram.size()));
    QCOMPARE(in->counters().rxKernelDrops, std::uint64_t(0));
    QCOMPARE(out->counters().txBlocks, std::uint64_t(kCount));
    QVERIFY(ground.largestBatch > 1);
}

void UdpLinkTest::datagramsOfAnySizesKeepTheirBounds()
{
    BlockRecorder ground, other, air;
    const auto in = openLink("udpin:127.0.0.1:0", ground, options());
    const auto second = openLink("udpin:127.0.0.1:0", other, options());
    const auto out = openLink("udpin:127.0.0.1:0", air, options());
    // Runs of one size, single ones, sizes that come again, the longest, and two destinations in between.
    std::vector<std::size_t> sizes;
    for (const std::size_t size : {40u, 40u, 40u, 41u, 40u, 1400u, 1400u, 1400u, 7u, 7u, 1u, 1400u})
        sizes.insert(sizes.end(), size == 7 ? 50 : 1, size);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const std::vector<std::uint8_t> datagram(sizes[i], static_cast<std::uint8_t>(i));
        out->send(*in->localEndpoint(), datagram);
        if (i % 10 == 0)
            out->send(*second->localEndpoint(), datagram);
    }
    out->flush();
    EVENTUALLY_EQUAL(ground.blocks.size(), sizes.size());
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        QCOMPARE(ground.blocks[i].bytes.size(), sizes[i]);
        const Bytes expected(sizes[i], static_cast<std::uint8_t>(i));
        QVERIFY(ground.blocks[i].bytes == expected);
    }
    EVENTUALLY_EQUAL(other.blocks.size(), (sizes.size() + 9) / 10);
    for (std::size_t i = 0; i < other.blocks.size(); ++i)
        QCOMPARE(other.blocks[i].bytes.size(), sizes[10 * i]);
    QCOMPARE(out->counters().txBlocks, std::uint64_t(sizes.size() + other.blocks.size()));
}

void UdpLinkTest::carriesIpv6()
{
    SKYSEAL_REQUIRES("ipv6");
    BlockRecorder ground;
    BlockRecorder air;
    const auto in = openLink("udpin:[::1]:0", ground, options());
    QCOMPARE(in->state(), LinkState::Listening);
    QCOMPARE(in->localAddress(), "[::1]:" + portOf(*in));
    const auto out = openLink("udpout:[::1]:" + portOf(*in), air, options());
    out->send({}, text("six"));
    out->flush();
    EVENTUALLY_EQUAL(ground.stream(), std::string("six"));
    in->send(ground.blocks[0].path.remote, text("back"));
    in->flush();
    EVENTUALLY_EQUAL(air.stream(), std::string("back"));
}

void UdpLinkTest::dualStackReportsIpv4AsIpv4()
{
    SKYSEAL_REQUIRES("ipv6");
    BlockRecorder ground;
    BlockRecorder air;
    const auto in = openLink("udpin:[::]:0", ground, options());
    QCOMPARE(in->state(), LinkState::Listening);
    const auto out = openLink("udpout:127.0.0.1:" + portOf(*in), air, options());
    out->send({}, text("four"));
    out->flush();
    EVENTUALLY_EQUAL(ground.stream(), std::string("four"));
    QCOMPARE(toText(ground.blocks[0].path.remote), "127.0.0.1:" + portOf(*out));
    in->send(ground.blocks[0].path.remote, text("back"));
    in->flush();
    EVENTUALLY_EQUAL(air.stream(), std::string("back"));
}

void UdpLinkTest::portInUseFailsAndOpensWhenFree()
{
    BlockRecorder listener;
    const auto first = openLink("udpin:127.0.0.1:0", listener, options());
    const std::string address = first->localAddress();
    for (const std::string &host : {std::string("127.0.0.1"), std::string("0.0.0.0")}) {
        const auto second = openLink("udpin:" + host + ":" + portOf(*first), listener, options());
        QCOMPARE(second->state(), LinkState::Failed);
        QCOMPARE(second->error().code, LinkErrorCode::PortInUse);
        // This program holds the port, and the message names it.
        QCOMPARE(second->error().sentence(),
                 "port " + host + ":" + portOf(*first) + " is in use by another program: link_tests (process "
                     + std::to_string(QCoreApplication::applicationPid()) + ")");
        // The requested address is still shown.
        QCOMPARE(second->localAddress(), host + ":" + portOf(*first));
    }
    const auto second = openLink("udpin:" + address, listener, options());
    QCOMPARE(second->state(), LinkState::Failed);
    first->close();
    QCOMPARE(first->state(), LinkState::Closed);
    second->open();
    QCOMPARE(second->state(), LinkState::Listening);
    QCOMPARE(second->localAddress(), address);
}

void UdpLinkTest::foreignAddressIsReported()
{
    BlockRecorder listener;
    // TEST-NET-1 (RFC 5737) is not assigned to any host.
    const auto link = openLink("udpin:192.0.2.1:0", listener, options());
    QCOMPARE(link->state(), LinkState::Failed);
    QCOMPARE(link->error().code, LinkErrorCode::AddressUnavailable);
    QCOMPARE(link->error().sentence(), std::string("192.0.2.1:0 is not an address of this machine"));
}

void UdpLinkTest::unknownHostIsReportedAndRetried()
{
    BlockRecorder listener;
    const auto link = openLink("udpout:no-such-host.invalid:14550", listener, options());
    EVENTUALLY_EQUAL(link->state(), LinkState::Waiting);
    QCOMPARE(link->error().code, LinkErrorCode::HostUnknown);
    QVERIFY(link->error().sentence().find("no-such-host.invalid") != std::string::npos);
    link->send({}, text("x"));
    QCOMPARE(link->counters().txDropped, std::uint64_t(1));
    link->close();
    QCOMPARE(link->state(), LinkState::Closed);
    QCOMPARE(link->error().code, LinkErrorCode::None);
}

void UdpLinkTest::hostNameIsLookedUp()
{
    SKYSEAL_REQUIRES("localhost");
    BlockRecorder ground;
    BlockRecorder air;
    const auto in = openLink("udpin:127.0.0.1:0", ground, options());
    const auto out = openLink("udpout:localhost:" + portOf(*in), air, options());
    QCOMPARE(out->state(), LinkState::Opening);
    EVENTUALLY_EQUAL(out->state(), LinkState::Connected);
    out->send({}, text("named"));
    out->flush();
    EVENTUALLY_EQUAL(ground.stream(), std::string("named"));
}

void UdpLinkTest::absentPeerDoesNotCloseTheLink()
{
    BlockRecorder ground;
    BlockRecorder air;
    auto in = openLink("udpin:127.0.0.1:0", ground, options());
    const std::string address = in->localAddress();
    const auto out = openLink("udpout:" + in->localAddress(), air, options());
    in->close();
    // The system answers each of these with an ICMP error.
    for (int i = 0; i < 5; ++i) {
        out->send({}, text("lost"));
        out->flush();
        QCoreApplication::processEvents();
    }
    QCOMPARE(out->state(), LinkState::Connected);
    in = openLink("udpin:" + address, ground, options());
    QCOMPARE(in->state(), LinkState::Listening);
    out->send({}, text("found"));
    out->flush();
    EVENTUALLY_EQUAL(ground.stream(), std::string("found"));
}

void UdpLinkTest::oversizedDatagramsAreCountedAndDropped()
{
    BlockRecorder ground;
    const auto in = openLink("udpin:127.0.0.1:0", ground, options());
    QUdpSocket sender;
    const auto write = [&](qsizetype size, char fill) {
        const QByteArray bytes(size, fill);
        QCOMPARE(sender.writeDatagram(bytes, QHostAddress(QHostAddress::LocalHost), in->localEndpoint()->port), bytes.size());
    };
    write(3, 'a');
    write(kMaxDatagram + 1, 'b');
    write(kMaxDatagram, 'c');
    write(60'000, 'd');
    write(0, 'e');
    write(1, 'f');
    EVENTUALLY_EQUAL(ground.blocks.size(), std::size_t(4));
    QCOMPARE(ground.stream(), "aaa" + std::string(kMaxDatagram, 'c') + "f");
    QCOMPARE(in->counters().rxOversized, std::uint64_t(2));
    const auto out = openLink("udpout:" + in->localAddress(), ground, options());
    out->send({}, Bytes(kMaxDatagram + 1));
    QCOMPARE(out->counters().txDropped, std::uint64_t(1));
}

void UdpLinkTest::floodLeavesRoomForTimers()
{
    BlockRecorder ground;
    BlockRecorder air;
    LinkOptions bounded = options();
    bounded.turn = {};
    const auto in = openLink("udpin:127.0.0.1:0", ground, bounded);
    const auto out = openLink("udpout:127.0.0.1:" + portOf(*in), air, options());
    // Each received datagram is sent again, so the socket is never drained; the timer must fire nevertheless.
    ground.onReceived = [&](Link &) {
        for (int i = 0; i < 64; ++i)
            out->send({}, text("flood"));
        out->flush();
    };
    for (int i = 0; i < 256; ++i)
        out->send({}, text("flood"));
    out->flush();
    int ticks = 0;
    QTimer timer;
    connect(&timer, &QTimer::timeout, this, [&] { ++ticks; });
    timer.start(1);
    EVENTUALLY(ticks >= 20);
    QVERIFY(ground.batches > 20);
    in->close();
}

void UdpLinkTest::expensiveDatagramsDoNotDelayOtherLinks()
{
    BlockRecorder ground;
    BlockRecorder air;
    BlockRecorder other;
    const auto in = openLink("udpin:127.0.0.1:0", ground, options());
    const auto beside = openLink("udpin:127.0.0.1:0", other, options());
    const auto out = openLink("udpout:127.0.0.1:" + portOf(*in), air, options());
    const auto toBeside = openLink("udpout:127.0.0.1:" + portOf(*beside), air, options());
    const auto burst = [&](int count) {
        for (int i = 0; i < count; ++i)
            out->send({}, text("x"));
        out->flush();
    };
    // Each datagram takes four turns. After the first burst this is known, and the other link does not wait for a whole burst.
    ground.onReceived = [&](Link &) {
        for (const TimePoint begin = steadyNow(); steadyNow() - begin < 4 * options().turn;) {}
        if (ground.blocks.size() == 64) {
            burst(64);
            toBeside->send({}, text("y"));
            toBeside->flush();
        }
    };
    std::size_t before = 0;
    other.onReceived = [&](Link &) { before = ground.blocks.size() - 64; };
    burst(64);
    EVENTUALLY_EQUAL(ground.blocks.size(), std::size_t(128));
    EVENTUALLY_EQUAL(other.blocks.size(), std::size_t(1));
    QVERIFY2(before <= 16, qPrintable(QString::number(before)));
}

void UdpLinkTest::listenerMayCloseTheLink()
{
    BlockRecorder ground;
    BlockRecorder air;
    const auto in = openLink("udpin:127.0.0.1:0", ground, options());
    const std::string address = in->localAddress();
    const auto out = openLink("udpout:" + address, air, options());
    ground.onReceived = [](Link &link) { link.close(); };
    for (int i = 0; i < 200; ++i)
        out->send({}, text("x"));
    out->flush();
    EVENTUALLY_EQUAL(in->state(), LinkState::Closed);
    QCOMPARE(ground.batches, std::size_t(1));
    // The port is released at once.
    BlockRecorder other;
    QCOMPARE(openLink("udpin:" + address, other, options())->state(), LinkState::Listening);
}

void UdpLinkTest::receivedBytesMayBeChangedInPlace()
{
    struct Inverter : LinkListener
    {
        void linkReceived(Link &link, std::span<const ReceivedBlock> blocks) override
        {
            for (const ReceivedBlock &block : blocks) {
                for (std::uint8_t &byte : block.bytes)
                    byte = static_cast<std::uint8_t>(~byte);
                link.send(block.path.remote, block.bytes);
            }
            link.flush();
        }
    } inverter;
    BlockRecorder air;
    const auto in = openLink("udpin:127.0.0.1:0", inverter, options());
    const auto out = openLink("udpout:127.0.0.1:" + portOf(*in), air, options());
    Bytes all(256);
    std::iota(all.begin(), all.end(), std::uint8_t(0));
    out->send({}, all);
    out->flush();
    EVENTUALLY_EQUAL(air.blocks.size(), std::size_t(1));
    std::reverse(all.begin(), all.end());
    QVERIFY(air.blocks[0].bytes == all);
}

void UdpLinkTest::sendWithoutPeerIsCounted()
{
    BlockRecorder ground;
    const auto in = openLink("udpin:127.0.0.1:0", ground, options());
    in->send({}, text("whom?"));
    QCOMPARE(in->counters().txDropped, std::uint64_t(1));
    in->close();
    in->send(ipv4(0x7f000001, 9), text("closed"));
    QCOMPARE(in->counters().txDropped, std::uint64_t(2));
}

void UdpLinkTest::desktopProxyIsIgnored()
{
    QTcpServer proxy;
    QVERIFY(proxy.listen(QHostAddress::LocalHost));
    QNetworkProxy::setApplicationProxy({QNetworkProxy::Socks5Proxy, QStringLiteral("127.0.0.1"), proxy.serverPort()});
    const auto back = qScopeGuard([] { QNetworkProxy::setApplicationProxy(QNetworkProxy::NoProxy); });
    BlockRecorder station;
    BlockRecorder vehicle;
    const auto in = openLink("udpin:127.0.0.1:0", station, options());
    QCOMPARE(in->state(), LinkState::Listening);
    const auto out = openLink("udpout:" + in->localAddress(), vehicle, options());
    EVENTUALLY_EQUAL(out->state(), LinkState::Connected);
    out->send({}, text("hello"));
    out->flush();
    EVENTUALLY_EQUAL(station.stream(), std::string("hello"));
    QVERIFY(!proxy.hasPendingConnections());
}

SKYSEAL_TEST(UdpLinkTest)
#include "udp_link_test.moc"
