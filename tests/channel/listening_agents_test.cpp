// Agents that listen and announce nothing, on a virtual clock: a station that knows their addresses, but not which agent is at
// which, gets a session with each.
#include "core/channel/endpoint.h"
#include "core/channel/mac1.h"
#include "tests/channel/pair.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <map>
#include <set>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

/// Agents at addresses of their own, in an order that the station cannot know; every datagram arrives after 10 ms.
class Listeners
{
public:
    explicit Listeners(std::size_t agents) : m_agents(agents)
    {
        Config station = configFor(Role::Station, newIdentity(m_random));
        for (Agent &agent : m_agents) {
            agent.identity = newIdentity(m_random);
            station.peers.push_back({publicKeyOf(*agent.identity), "agent", PeerRole::Pilot, {}, {}});
        }
        m_stationKey = publicKeyOf(*station.identity);
        for (Agent &agent : m_agents)
            start(agent);
        m_station = std::make_unique<Endpoint>(std::move(station), m_random, m_stationCounters, now);
    }

    void call(const std::vector<std::size_t> &addresses)
    {
        std::vector<Path> paths;
        for (const std::size_t address : addresses)
            paths.push_back(pathOf(address));
        m_station->setCallAt(now, std::move(paths));
        pump();
    }
    void run(Duration span, const std::function<bool()> &until = {})
    {
        const TimePoint end = now + span;
        while (now < end && !(until && until())) {
            TimePoint due = std::min(end, m_station->nextDeadline());
            for (const Agent &agent : m_agents)
                due = std::min(due, agent.endpoint ? agent.endpoint->nextDeadline() : kNever);
            if (!m_flying.empty())
                due = std::min(due, m_flying.begin()->first);
            now = std::max(now, due);
            while (!m_flying.empty() && m_flying.begin()->first <= now)
                arrive(m_flying.extract(m_flying.begin()).mapped());
            if (m_station->nextDeadline() <= now)
                m_station->handleDeadline(now);
            for (Agent &agent : m_agents) {
                if (agent.endpoint && agent.endpoint->nextDeadline() <= now)
                    agent.endpoint->handleDeadline(now);
            }
            pump();
        }
    }
    std::size_t sessions() const { return m_station->sessions().size(); }
    /// Sessions in which records arrive.
    std::size_t heard() const
    {
        return static_cast<std::size_t>(
            std::ranges::count_if(m_station->sessions(), [&](SessionId id) { return !m_station->sessionInfo(id)->silent; }));
    }
    /// From now on the agents are at other addresses, this much further.
    void move(std::size_t addresses) { m_moved += addresses; }
    void kill(std::size_t agent) { m_agents[agent].endpoint.reset(); }
    void restart(std::size_t agent) { start(m_agents[agent]); }

    TimePoint now{1h};
    std::uint64_t firsts = 0;       ///< first messages that the station sent
    std::set<std::size_t> called;   ///< agents to which they were addressed
    std::set<std::size_t> calledAt; ///< addresses to which they went

private:
    struct Agent
    {
        std::shared_ptr<const crypto::X25519KeyPair> identity;
        MemoryCounterStore counters;
        std::unique_ptr<Endpoint> endpoint;
    };
    struct Datagram
    {
        bool toStation = false;
        std::size_t address = 0;
        Bytes bytes;
    };

    static Config configFor(Role role, std::shared_ptr<const crypto::X25519KeyPair> identity)
    {
        Config config;
        config.role = role;
        config.identity = std::move(identity);
        config.policy = {defaultSuites(), false, false};
        return config;
    }
    void start(Agent &agent)
    {
        Config config = configFor(Role::Agent, agent.identity);
        config.peers.push_back({m_stationKey, "station", PeerRole::Pilot, {}, {}});
        agent.endpoint = std::make_unique<Endpoint>(std::move(config), m_random, agent.counters, now);
    }
    /// The last agent of the list is at the first address.
    Agent *findAt(std::size_t address)
    {
        const std::size_t place = address - m_moved;
        return place < m_agents.size() ? &m_agents[m_agents.size() - 1 - place] : nullptr;
    }
    static Path pathOf(std::size_t address)
    {
        Path path{LinkId{1 + static_cast<std::uint32_t>(address)}, {}};
        path.remote.ip[15] = static_cast<std::uint8_t>(1 + address);
        path.remote.port = 14550;
        return path;
    }
    void arrive(Datagram datagram)
    {
        if (datagram.toStation)
            m_station->handleDatagram(now, pathOf(datagram.address), datagram.bytes);
        else if (Agent *agent = findAt(datagram.address); agent && agent->endpoint)
            agent->endpoint->handleDatagram(now, Path{LinkId{9}, {{}, 40000}}, datagram.bytes);
        pump();
    }
    void noteFirst(ByteView message)
    {
        ++firsts;
        for (std::size_t i = 0; i < m_agents.size(); ++i) {
            if (Mac1(publicKeyOf(*m_agents[i].identity)).verify(message))
                called.insert(i);
        }
    }
    void pump()
    {
        while (const auto sent = m_station->pollTransmit()) {
            const std::size_t address = static_cast<std::size_t>(sent->to.link) - 1;
            if (sent->bytes[0] == 0x59) {
                noteFirst(sent->bytes);
                calledAt.insert(address);
            }
            m_flying.emplace(now + 10ms, Datagram{false, address, Bytes(sent->bytes.begin(), sent->bytes.end())});
        }
        while (m_station->pollEvent()) {}
        for (std::size_t address = m_moved; const Agent *agent = findAt(address); ++address) {
            if (!agent->endpoint)
                continue;
            while (const auto sent = agent->endpoint->pollTransmit())
                m_flying.emplace(now + 10ms, Datagram{true, address, Bytes(sent->bytes.begin(), sent->bytes.end())});
            while (agent->endpoint->pollEvent()) {}
        }
    }

    SeededRandom m_random{1};
    std::vector<Agent> m_agents;
    PublicKey m_stationKey{};
    MemoryCounterStore m_stationCounters;
    std::unique_ptr<Endpoint> m_station;
    std::multimap<TimePoint, Datagram> m_flying;
    std::size_t m_moved = 0;
};

std::vector<std::size_t> upTo(std::size_t count)
{
    std::vector<std::size_t> out(count);
    for (std::size_t i = 0; i < count; ++i)
        out[i] = i;
    return out;
}

} // namespace

class ListeningAgentsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nobodyIsCalledWithoutAnAddress();
    void oneIsFoundAtOnce();
    void manyAreFoundInTurns();
    void isFoundAgainAfterARestart();
    void isFoundAtAnotherAddress();
    void silentAddressIsCalledSparingly();
    void fourAreCalledAtATime();
    void changesBeginNoTurn();
    void removedAddressIsCalledNoMore();
};

void ListeningAgentsTest::nobodyIsCalledWithoutAnAddress()
{
    Listeners listeners(3);
    listeners.run(60s);
    QCOMPARE(listeners.firsts, std::uint64_t(0));
    QCOMPARE(listeners.sessions(), std::size_t(0));
}

void ListeningAgentsTest::oneIsFoundAtOnce()
{
    Listeners listeners(1);
    listeners.call({0});
    listeners.run(50ms);
    QCOMPARE(listeners.sessions(), std::size_t(1));
    listeners.run(60s);
    QCOMPARE(listeners.firsts, std::uint64_t(1)); // and no call follows
    QCOMPARE(listeners.sessions(), std::size_t(1));
}

void ListeningAgentsTest::manyAreFoundInTurns()
{
    // Four agents at four addresses take one turn; 18 agents at 18 addresses, 5 x 5 groups, at most 25.
    for (const std::size_t count : {4u, 18u}) {
        Listeners listeners(count);
        listeners.call(upTo(count));
        listeners.run(count == 4 ? 1s : 25 * 5s, [&] { return listeners.sessions() == count; });
        QCOMPARE(listeners.sessions(), count);
        listeners.run(12s); // attempts that a found agent made superfluous have ended
        const std::uint64_t before = listeners.firsts;
        listeners.run(60s);
        QCOMPARE(listeners.firsts, before);
        QCOMPARE(listeners.sessions(), count);
    }
}

void ListeningAgentsTest::isFoundAgainAfterARestart()
{
    Listeners listeners(2);
    listeners.call(upTo(2));
    listeners.run(1s);
    QCOMPARE(listeners.sessions(), std::size_t(2));
    for (const Duration away : {Duration(100ms), Duration(30s), Duration(900s)}) { // the last is longer than a session is kept
        listeners.kill(0);
        listeners.run(away);
        listeners.restart(0);
        const std::uint64_t before = listeners.firsts;
        listeners.run(6s);
        QVERIFY(listeners.firsts > before);
        QCOMPARE(listeners.sessions(), std::size_t(2));
    }
}

/// Its modem or its address changes while the station still has the session, which it keeps for ten minutes.
void ListeningAgentsTest::isFoundAtAnotherAddress()
{
    Listeners listeners(1);
    listeners.call({0, 1});
    listeners.run(20s);
    QCOMPARE(listeners.heard(), std::size_t(1));
    listeners.move(1);
    listeners.run(15s); // silence, and two turns of calls at the most
    QCOMPARE(listeners.heard(), std::size_t(1));
    QCOMPARE(listeners.sessions(), std::size_t(1));
}

void ListeningAgentsTest::silentAddressIsCalledSparingly()
{
    Listeners listeners(100);
    listeners.call({200}); // where nobody is
    listeners.run(60s);
    // Twelve turns of four agents, each called at once, after 250 ms, 500 ms, 1 s and 2 s, less a quarter.
    QVERIFY(listeners.firsts > 100);
    QVERIFY2(listeners.firsts <= 12 * 4 * 6, qPrintable(QString::number(listeners.firsts)));
    QCOMPARE(listeners.sessions(), std::size_t(0));
}

void ListeningAgentsTest::fourAreCalledAtATime()
{
    Listeners listeners(10);
    listeners.call({200});
    std::set<std::size_t> all;
    for (int turn = 0; turn < 3; ++turn) {
        listeners.run(5s - 1ms);
        QCOMPARE(listeners.called.size(), std::size_t(4));
        all.merge(std::exchange(listeners.called, {}));
        listeners.run(1ms);
    }
    QCOMPARE(all.size(), std::size_t(10));
}

/// Forged MAVLink makes addresses come and go; it must not make the station call more agents.
void ListeningAgentsTest::changesBeginNoTurn()
{
    Listeners listeners(30);
    for (int turn = 0; turn < 10; ++turn) {
        listeners.called.clear();
        listeners.calledAt.clear();
        for (int change = 0; change < 7; ++change) { // within one turn
            std::vector<std::size_t> places = upTo(100 + 12);
            places.erase(places.begin(), places.begin() + 100); // where nobody is
            places.erase(places.begin() + (turn + change) % 12);
            listeners.call(change == 3 ? std::vector<std::size_t>{} : places);
            listeners.run(700ms);
        }
        QVERIFY2(listeners.called.size() <= 4 + (turn > 0 ? 4 : 0), qPrintable(QString::number(listeners.called.size())));
        QVERIFY2(listeners.calledAt.size() <= 4 + (turn > 0 ? 4 : 0), qPrintable(QString::number(listeners.calledAt.size())));
        QVERIFY(turn > 0 || !listeners.called.empty());
    }
}

void ListeningAgentsTest::removedAddressIsCalledNoMore()
{
    Listeners listeners(3);
    listeners.call({100, 101});
    listeners.run(100ms);
    QCOMPARE(listeners.calledAt, (std::set<std::size_t>{100, 101}));
    listeners.calledAt.clear();
    listeners.call({101, 102});
    listeners.run(4800ms);
    QCOMPARE(listeners.calledAt, (std::set<std::size_t>{101})); // goes on; the new one waits for the next turn
    listeners.run(200ms);
    QCOMPARE(listeners.calledAt, (std::set<std::size_t>{101, 102}));
}

SKYSEAL_TEST(ListeningAgentsTest)
#include "listening_agents_test.moc"
