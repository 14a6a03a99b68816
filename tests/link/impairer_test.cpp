// The relay with real sockets on both sides: its log and counters match the arrivals exactly.
#include "core/link/impairer.h"
#include "tests/link/block_recorder.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <map>

using namespace skyseal;
using namespace skyseal::link;
using namespace skyseal::test;
using std::chrono::milliseconds;

class ImpairerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void perfectRelayCarriesBothWays();
    void arrivalsMatchTheLog();
    void sameSeedDropsTheSame();
    void relaysTcp();
    void blocksWithoutAPeerAreNotOffered();

private:
    struct Setup
    {
        explicit Setup(const impair::ImpairmentSettings &settings)
            : station(openLink("udpin:127.0.0.1:0", stationHeard)),
              relay(*LinkUrl::parse("udpin:127.0.0.1:0"), *LinkUrl::parse("udpout:" + station->localAddress()), settings)
        {
            relay.setLog([this](Impairer::Direction direction, TimePoint, const impair::Treatment &verdict, ByteView) {
                verdicts[direction].push_back(verdict);
            });
            relay.open();
            agent = openLink("udpout:" + relay.listenLink().localAddress(), agentHeard);
        }

        BlockRecorder stationHeard;
        BlockRecorder agentHeard;
        std::unique_ptr<Link> station;
        Impairer relay;
        std::unique_ptr<Link> agent;
        std::map<Impairer::Direction, std::vector<impair::Treatment>> verdicts;
    };
};

static Bytes numbered(std::uint32_t number)
{
    // All bytes are derived from the number, so that a damaged number is detected as well.
    Bytes out(50);
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = static_cast<std::uint8_t>(number >> (8 * (i % 4)));
    return out;
}

static std::uint32_t numberOf(const Bytes &bytes)
{
    return std::uint32_t(bytes[0] | bytes[1] << 8 | bytes[2] << 16 | bytes[3] << 24);
}

void ImpairerTest::perfectRelayCarriesBothWays()
{
    Setup setup{{}};
    setup.agent->send({}, asBytes("to the station"));
    setup.agent->flush();
    EVENTUALLY_EQUAL(setup.stationHeard.stream(), std::string("to the station"));
    setup.station->send(setup.stationHeard.blocks[0].path.remote, asBytes("to the agent"));
    setup.station->flush();
    EVENTUALLY_EQUAL(setup.agentHeard.stream(), std::string("to the agent"));
    QCOMPARE(setup.agentHeard.blocks[0].path.remote, *setup.relay.listenLink().localEndpoint());
    QCOMPARE(setup.relay.totals(Impairer::Direction::Forward).counters.delivered, std::uint64_t(1));
    QCOMPARE(setup.relay.totals(Impairer::Direction::Backward).counters.deliveredBytes, std::uint64_t(12));
}

void ImpairerTest::arrivalsMatchTheLog()
{
    impair::ImpairmentSettings settings;
    settings.loss = 0.2;
    settings.duplicate = 0.1;
    settings.reorder = 0.1;
    settings.corrupt = 0.05;
    settings.jitter = milliseconds(20);
    settings.seed = 11;
    Setup setup{settings};
    constexpr std::uint32_t kCount = 2000;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        setup.agent->send({}, numbered(i));
        if (i % 50 == 49) {
            setup.agent->flush();
            EVENTUALLY_EQUAL(setup.relay.totals(Impairer::Direction::Forward).counters.offered, std::uint64_t(i + 1));
        }
    }
    const auto counters = [&] { return setup.relay.totals(Impairer::Direction::Forward).counters; };
    EVENTUALLY_EQUAL(counters().waiting, std::uint64_t(0));
    EVENTUALLY_EQUAL(setup.stationHeard.blocks.size(), std::size_t(counters().delivered));
    QCOMPARE(counters().offered, std::uint64_t(kCount));
    QCOMPARE(counters().offered + counters().duplicated, counters().dropped() + counters().delivered);
    QVERIFY(counters().lost > 300 && counters().lost < 500);

    std::map<std::uint32_t, int> copies;
    int damaged = 0;
    for (const BlockRecorder::Block &block : setup.stationHeard.blocks) {
        const bool intact = numberOf(block.bytes) < kCount && block.bytes == numbered(numberOf(block.bytes));
        if (intact)
            ++copies[numberOf(block.bytes)];
        else
            ++damaged;
    }
    int expectedDamaged = 0;
    const auto &verdicts = setup.verdicts[Impairer::Direction::Forward];
    QCOMPARE(verdicts.size(), std::size_t(kCount));
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const impair::Treatment &verdict = verdicts[i];
        const int sent = verdict.dropped() ? 0 : verdict.duplicated ? 2 : 1;
        expectedDamaged += verdict.corrupted ? sent : 0;
        QCOMPARE(copies[i], verdict.corrupted ? 0 : sent);
    }
    QCOMPARE(damaged, expectedDamaged);
}

void ImpairerTest::sameSeedDropsTheSame()
{
    impair::ImpairmentSettings settings;
    settings.loss = 0.3;
    settings.seed = 5;
    const auto run = [&] {
        Setup setup{settings};
        for (std::uint32_t i = 0; i < 200; ++i)
            setup.agent->send({}, numbered(i));
        setup.agent->flush();
        [&] { EVENTUALLY_EQUAL(setup.relay.totals(Impairer::Direction::Forward).counters.offered, std::uint64_t(200)); }();
        [&] {
            EVENTUALLY_EQUAL(setup.stationHeard.blocks.size(),
                             std::size_t(setup.relay.totals(Impairer::Direction::Forward).counters.delivered));
        }();
        std::vector<std::uint32_t> out;
        for (const BlockRecorder::Block &block : setup.stationHeard.blocks)
            out.push_back(numberOf(block.bytes));
        return out;
    };
    const auto first = run();
    QVERIFY(first.size() > 100 && first.size() < 180);
    QCOMPARE(run(), first);
}

void ImpairerTest::relaysTcp()
{
    BlockRecorder vehicle;
    BlockRecorder station;
    const auto server = openLink("tcpin:127.0.0.1:0", vehicle);
    Impairer relay(*LinkUrl::parse("tcpin:127.0.0.1:0"), *LinkUrl::parse("tcp:" + server->localAddress()), {});
    relay.open();
    const auto client = openLink("tcp:" + relay.listenLink().localAddress(), station);
    EVENTUALLY_EQUAL(client->state(), LinkState::Connected);
    EVENTUALLY_EQUAL(relay.toLink().state(), LinkState::Connected);
    client->send({}, asBytes("up"));
    client->flush();
    EVENTUALLY_EQUAL(vehicle.stream(), std::string("up"));
    server->send({}, asBytes("down"));
    server->flush();
    EVENTUALLY_EQUAL(station.stream(), std::string("down"));
}

void ImpairerTest::blocksWithoutAPeerAreNotOffered()
{
    Setup setup{{}};
    // The relay is bound to every address; use the loopback address to reach it.
    Address loopback = *setup.relay.listenLink().localEndpoint();
    loopback.port = setup.relay.toLink().localEndpoint()->port;
    setup.station->send(loopback, asBytes("early"));
    setup.station->flush();
    EVENTUALLY_EQUAL(setup.relay.totals(Impairer::Direction::Backward).unroutable, std::uint64_t(1));
    QCOMPARE(setup.relay.totals(Impairer::Direction::Backward).counters.offered, std::uint64_t(0));
}

SKYSEAL_TEST(ImpairerTest)
#include "impairer_test.moc"
