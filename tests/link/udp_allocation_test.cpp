// The packet path of a UDP link does not allocate: this program replaces operator new to count.
#include "tests/link/block_recorder.h"
#include "tests/support/allocation_count.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::link;

class UdpAllocationTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sendingAndReceivingAllocateNothingPerDatagram();
};

void UdpAllocationTest::sendingAndReceivingAllocateNothingPerDatagram()
{
    struct Echo : LinkListener
    {
        void linkReceived(Link &link, std::span<const ReceivedBlock> blocks) override
        {
            received += blocks.size();
            for (const ReceivedBlock &block : blocks)
                link.send(block.path.remote, block.bytes);
            link.flush();
        }
        std::size_t received = 0;
    } echo;
    struct Counter : LinkListener
    {
        void linkReceived(Link &, std::span<const ReceivedBlock> blocks) override { received += blocks.size(); }
        std::size_t received = 0;
    } counter;
    const auto in = test::openLink("udpin:127.0.0.1:0", echo);
    const auto out = test::openLink("udpout:" + in->localAddress(), counter);
    const Bytes datagram(60);
    const auto round = [&] {
        const std::size_t target = counter.received + 512;
        for (int i = 0; i < 512; ++i)
            out->send({}, datagram);
        out->flush();
        while (counter.received < target)
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    };
    round();
    const std::uint64_t before = test::allocations;
    for (int i = 0; i < 20; ++i)
        round();
    const std::uint64_t allocated = test::allocations - before;
    QCOMPARE(counter.received, std::size_t(21 * 512));
    // The event loop may allocate a little per wake-up; 20 × 1024 datagrams were sent and received.
    QVERIFY2(allocated < 200, qPrintable(QStringLiteral("%1 allocations").arg(allocated)));
    qInfo("%llu allocations for %d datagrams", static_cast<unsigned long long>(allocated), 20 * 1024);
}

SKYSEAL_TEST(UdpAllocationTest)
#include "udp_allocation_test.moc"
