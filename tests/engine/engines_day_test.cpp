// A day of whole engines in simulated time: two agents and three stations with their gateways, over radios that lose, repeat,
// reorder and damage datagrams. Switches, outages, changed addresses, forged and replayed datagrams and restarts of either
// side. No session gets stuck, nothing is forwarded twice or without the right, the counters of both ends agree, and the memory
// of the process does not grow.
//
// SKYSEAL_MINUTES of the environment is the simulated time.
#include "core/crypto/init_crypto.h"
#include "tests/engine/simulated_fleet.h"
#include "tests/support/heap_bytes.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <cstdio>

#if defined(__GLIBC__)
#endif

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

/// Longest time until all sessions are up and positions pass, after each kind of disturbance and with the losses of the radio.
constexpr Duration kRecovery = 30s;
constexpr int kSettleMinutes = 10;
constexpr SimulatedNetwork::Radio kBad{.loss = .02, .duplicate = .01, .corrupt = .002, .reorder = .01, .delay = 20ms};

SimulatedNetwork &network()
{
    return SimulatedNetwork::instance();
}

} // namespace

class EnginesDayTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void nothingGrowsOrSticks();

private:
    void disturb(SimulatedFleet &fleet);
    void attack(SimulatedFleet &fleet);
    /// Holds whatever happens on the radio.
    static void judgeAccount(SimulatedFleet &fleet);
    /// On a radio that loses nothing, everything arrives once, and both ends count the same.
    static void settle(SimulatedFleet &fleet);
    void restart(SimulatedFleet &fleet, int turn);

    std::size_t m_switches = 0, m_outages = 0, m_moves = 0, m_attacks = 0, m_revocations = 0, m_restarts = 0;
};

void EnginesDayTest::disturb(SimulatedFleet &fleet)
{
    const std::size_t agent = network().dice() % SimulatedFleet::kAgents;
    SimulatedFleet::Station &station = fleet.stations[network().dice() % SimulatedFleet::kStations];
    switch (network().dice() % 6) {
    case 0:
    case 1:
        if (station.snapshot && !station.snapshot->sessions.empty()) {
            const auto suites = channel::defaultSuites();
            const auto &sessions = station.snapshot->sessions;
            station.core->switchSuite(sessions[network().dice() % sessions.size()].info.session,
                                      suites[network().dice() % suites.size()]);
            ++m_switches;
        }
        return;
    case 2:
        network().cut(network().dice() % 2 ? station.ip : fleet.agents[agent].ip);
        fleet.pass(std::chrono::seconds(network().dice() % 60 + 1));
        network().restore();
        ++m_outages;
        return;
    case 3: m_moves += network().move(network().dice() % 2 ? station.ip : fleet.agents[agent].ip); return;
    case 4: return attack(fleet);
    default: { // the agent's list loses a station for a while
        const std::vector<channel::Peer> peers = fleet.peersOfAgents();
        auto fewer = peers;
        fewer.erase(fewer.begin() + std::ptrdiff_t(network().dice() % fewer.size()));
        fleet.agents[agent].core->setPeers(fewer);
        fleet.pass(5s);
        fleet.agents[agent].core->setPeers(peers);
        ++m_revocations;
    }
    }
}

/// Old datagrams, changed ones and noise, from their senders' addresses and from others.
void EnginesDayTest::attack(SimulatedFleet &fleet)
{
    for (int i = 0; i < 20; ++i) {
        auto datagram = network().overheard();
        if (!datagram)
            return;
        const auto kind = network().dice() % 3;
        if (kind == 1 && !datagram->bytes.empty()) {
            datagram->bytes[network().dice() % datagram->bytes.size()] ^= 1;
        } else if (kind == 2) {
            for (std::uint8_t &byte : datagram->bytes)
                byte = static_cast<std::uint8_t>(network().dice());
        }
        if (network().dice() % 2)
            datagram->from = SimulatedNetwork::address("10.6.6.6:666");
        network().send(datagram->from, datagram->to, datagram->bytes);
    }
    fleet.pass(1s);
    ++m_attacks;
}

void EnginesDayTest::judgeAccount(SimulatedFleet &fleet)
{
    for (std::size_t i = 0; i < SimulatedFleet::kStations; ++i) {
        for (std::size_t j = 0; j < SimulatedFleet::kAgents; ++j) {
            const Numbered &down = fleet.stations[i].positions[j], &up = fleet.vehicles[j].commands[i];
            QCOMPARE(down.repeated(), std::size_t(0));
            QCOMPARE(down.strange(fleet.vehicles[j].positions), std::size_t(0));
            QCOMPARE(up.repeated(), std::size_t(0));
            QCOMPARE(up.strange(fleet.stations[i].commands[j]), std::size_t(0));
            if (i == SimulatedFleet::kObserver)
                QCOMPARE(up.arrived(), std::size_t(0));
        }
    }
}

void EnginesDayTest::settle(SimulatedFleet &fleet)
{
    judgeAccount(fleet);
    if (QTest::currentTestFailed())
        return;
    network().radio = {};
    fleet.pass(10s); // the reports show the last gaps
    fleet.traffic = false;
    fleet.pass(1s);
    fleet.quiet();
    QVERIFY(fleet.isUp());
    fleet.beginAccount();
    const auto fromAgents = fleet.agentTotals(), fromStations = fleet.stationTotals();
    std::array<std::uint64_t, SimulatedFleet::kAgents> frames{}, forwarded{}, refused{}, read{};
    std::array<std::array<std::uint32_t, SimulatedFleet::kAgents>, SimulatedFleet::kStations> commands{};
    std::array<std::uint32_t, SimulatedFleet::kAgents> positions{};
    const auto differences = [&] {
        for (std::size_t j = 0; j < SimulatedFleet::kAgents; ++j) {
            const engine::AgentSnapshot snapshot = fleet.agents[j].core->snapshot();
            frames[j] = fleet.vehicles[j].frames - frames[j];
            read[j] = snapshot.mavlink.frames - read[j];
            forwarded[j] = snapshot.counters.toGround - forwarded[j];
            refused[j] = snapshot.counters.observerRefused - refused[j];
            positions[j] = fleet.vehicles[j].positions - positions[j];
            for (std::size_t i = 0; i < SimulatedFleet::kStations; ++i)
                commands[i][j] = fleet.stations[i].commands[j] - commands[i][j];
        }
    };
    differences();
    fleet.traffic = true;
    fleet.pass(20s);
    fleet.traffic = false;
    fleet.pass(1s);
    fleet.quiet();
    differences();
    judgeAccount(fleet);
    for (std::size_t j = 0; j < SimulatedFleet::kAgents; ++j) {
        QVERIFY(positions[j] > 90);
        QCOMPARE(read[j], frames[j]);
        QCOMPARE(forwarded[j], frames[j]);
        QVERIFY(refused[j] >= commands[SimulatedFleet::kObserver][j]);
        QCOMPARE(fleet.agents[j].up - fleet.agents[j].down, SimulatedFleet::kStations);
        for (std::size_t i = 0; i < SimulatedFleet::kStations; ++i) {
            QCOMPARE(fleet.stations[i].positions[j].arrived(), std::size_t(positions[j]));
            if (i != SimulatedFleet::kObserver)
                QCOMPARE(fleet.vehicles[j].commands[i].arrived(), std::size_t(commands[i][j]));
        }
    }
    const auto agents = fleet.agentTotals(), stations = fleet.stationTotals();
    QCOMPARE(stations.good - fromStations.good, agents.sent - fromAgents.sent);
    QCOMPARE(agents.good - fromAgents.good, stations.sent - fromStations.sent);
    QCOMPARE(stations.lost, fromStations.lost);
    QCOMPARE(agents.lost, fromAgents.lost);
    QCOMPARE(stations.refused, fromStations.refused);
    QCOMPARE(agents.refused, fromAgents.refused);
    network().radio = kBad;
    fleet.traffic = true;
    fleet.beginAccount();
}

/// One of the agents and one of the stations.
void EnginesDayTest::restart(SimulatedFleet &fleet, int turn)
{
    const std::size_t agent = std::size_t(turn) % SimulatedFleet::kAgents,
                      station = std::size_t(turn) % SimulatedFleet::kStations;
    fleet.endAgent(agent, turn % 4 < 2);
    fleet.pass(std::chrono::seconds(network().dice() % 5));
    fleet.startAgent(agent);
    QVERIFY(fleet.flows(kRecovery));
    fleet.endStation(station, turn % 6 < 3);
    fleet.pass(std::chrono::seconds(network().dice() % 5));
    fleet.startStation(station);
    QVERIFY(fleet.flows(kRecovery));
    m_restarts += 2;
}

void EnginesDayTest::nothingGrowsOrSticks()
{
    const int minutes = qEnvironmentVariableIsSet("SKYSEAL_MINUTES") ? qEnvironmentVariableIntValue("SKYSEAL_MINUTES") : 20;
    SimulatedFleet fleet;
    QVERIFY(fleet.flows(kRecovery));
    network().radio = kBad;
    fleet.beginAccount();
    std::vector<std::size_t> heap;
    int settled = 0;
    for (int minute = 1; minute <= minutes; ++minute) {
        const TimePoint end = SimulatedFleet::now() + 1min;
        for (int part = 0; part < 2; ++part) {
            disturb(fleet);
            QVERIFY2(fleet.flows(kRecovery), qPrintable(QStringLiteral("minute %1").arg(minute)));
            fleet.pass(10s);
        }
        if (SimulatedFleet::now() < end)
            fleet.pass(end - SimulatedFleet::now());
        if (minute % kSettleMinutes != 0)
            continue;
        settle(fleet);
        if (QTest::currentTestFailed()) {
            std::printf("minute %d\n", minute);
            return;
        }
        heap.push_back(heapBytes());
        restart(fleet, settled++);
        if (QTest::currentTestFailed())
            return;
    }
    const SimulatedNetwork::Counters &radio = network().counters();
    std::printf("%d min: %zu switches, %zu outages, %zu addresses, %zu attacks, %zu revocations, %zu restarts, %d times quiet; "
                "%llu datagrams, %llu lost, %llu repeated; %u and %u positions\n",
                minutes, m_switches, m_outages, m_moves, m_attacks, m_revocations, m_restarts, settled,
                static_cast<unsigned long long>(radio.sent), static_cast<unsigned long long>(radio.dropped),
                static_cast<unsigned long long>(radio.duplicated), fleet.vehicles[0].positions, fleet.vehicles[1].positions);
    QVERIFY(settled > 0);
    const std::size_t warm = std::min<std::size_t>((heap.size() - 1) / 2, 5); // what is kept for an hour at most is full then
    const auto most = *std::max_element(heap.begin() + static_cast<std::ptrdiff_t>(warm), heap.end());
    std::printf("heap: %zu kB after %zu min, %zu kB at most from then on, %zu kB at the end\n", heap[warm] / 1024,
                (warm + 1) * kSettleMinutes, most / 1024, heap.back() / 1024);
    QVERIFY2(most < heap[warm] + (256 << 10), qPrintable(QString::number(most)));
}

SKYSEAL_TEST(EnginesDayTest)
#include "engines_day_test.moc"
