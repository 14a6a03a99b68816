// The agent coalesces the clear frames of one wake-up as it does sealed ones, so that a comparison with plain MAVLink compares
// suites. Real sockets on both sides of the agent.
#include "core/engine/agent/agent_core.h"
#include "tests/engine/bare_end.h"
#include "tests/engine/sample_traffic.h"
#include "tests/support/addresses.h"
#include "tests/support/eventually.h"
#include "tests/support/joined.h"
#include "tests/support/test_runner.h"

#include <QtCore/QCoreApplication>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;

namespace {

/// An agent that may send in clear and has no session.
class ClearAgent
{
public:
    ClearAgent()
    {
        engine::AgentConfig config{urlOf("udpin:127.0.0.1:0"),
                                   {{urlOf("udpout:127.0.0.1:" + std::to_string(m_ground.port()))}},
                                   {channel::defaultSuites(), true, true},
                                   true};
        m_agent = std::make_unique<engine::AgentCore>(std::move(config), m_keys.secrets(channel::Role::Agent),
                                                      [](const engine::AgentEvent &) {});
        m_agent->start();
        m_port = portOf(m_agent->snapshot().vehicle.localAddress);
    }

    /// Sends each frame as a datagram and returns the datagrams that the agent forwards, without its own messages.
    std::vector<Bytes> carry(std::span<const ByteView> frames)
    {
        m_vehicle.send(m_port, frames); // all are there before the agent wakes
        std::size_t wanted = 0, got = 0;
        for (const ByteView frame : frames)
            wanted += frame.size();
        std::vector<Bytes> out;
        const bool all = eventually([&] {
            for (std::size_t count = m_ground.receive(), i = 0; i < count; ++i) {
                const MutableByteView datagram = m_ground.received(i);
                if (datagram.empty() || datagram[0] != mavlink::kMagic2)
                    continue;
                out.emplace_back(datagram.begin(), datagram.end());
                got += datagram.size();
            }
            return got >= wanted;
        });
        return all ? out : std::vector<Bytes>();
    }

private:
    Introduced m_keys;
    BareSocket m_ground, m_vehicle;
    std::unique_ptr<engine::AgentCore> m_agent;
    std::uint16_t m_port = 0;
};

} // namespace

class ClearFrameCoalescerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void oneFrameGoesAtOnce();
    void framesOfOneWakeUpShareADatagram();
    void datagramsAreNotLargerThanSealedOnes();
};

void ClearFrameCoalescerTest::oneFrameGoesAtOnce()
{
    ClearAgent agent;
    const SampleTraffic traffic(16);
    for (const ByteView &frame : traffic.frames()) {
        const auto datagrams = agent.carry({&frame, 1});
        QCOMPARE(datagrams.size(), std::size_t(1));
        QVERIFY(std::ranges::equal(datagrams[0], frame));
    }
}

void ClearFrameCoalescerTest::framesOfOneWakeUpShareADatagram()
{
    ClearAgent agent;
    const SampleTraffic traffic(16);
    for (const std::size_t count : {2u, 5u, 16u}) {
        const auto frames = std::span(traffic.frames()).first(count);
        bool inOne = false;
        for (int i = 0; i < 50 && !inOne; ++i) { // a busy kernel may hand them over in two wake-ups
            const auto datagrams = agent.carry(frames);
            QVERIFY(joined(datagrams) == joined(frames)); // in their order, none changed
            inOne = datagrams.size() == 1;
        }
        QVERIFY(inOne);
    }
}

void ClearFrameCoalescerTest::datagramsAreNotLargerThanSealedOnes()
{
    ClearAgent agent;
    const SampleTraffic traffic(256);
    const auto datagrams = agent.carry(traffic.frames());
    QVERIFY(datagrams.size() < traffic.frames().size());
    QVERIFY(joined(datagrams) == joined(traffic.frames()));
    for (const Bytes &datagram : datagrams)
        QVERIFY(datagram.size() <= channel::kMaxRecordPayload);
    const mavlink::Dialect &dialect = mavlink::Dialect::builtin();
    for (const Bytes &datagram : datagrams) {
        mavlink::FrameScanner scanner(datagram, dialect);
        while (const auto item = scanner.next())
            QVERIFY(item->frame);
    }
}

SKYSEAL_TEST(ClearFrameCoalescerTest)
#include "clear_frame_coalescer_test.moc"
