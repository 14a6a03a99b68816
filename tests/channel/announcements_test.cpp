// The addresses and intervals of an agent's announcements, on a virtual clock: many stations that fall silent at the same time,
// and links of which one carries a session.
#include "core/channel/endpoint.h"
#include "tests/channel/pair.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <map>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

using Identity = std::shared_ptr<const crypto::X25519KeyPair>;

Config configFor(Role role, Identity identity)
{
    Config config;
    config.role = role;
    config.identity = std::move(identity);
    config.policy = {defaultSuites(), false, false};
    return config;
}

/// One agent, and stations at addresses of one of its links. Datagrams arrive at once.
class Stations
{
public:
    static constexpr std::uint32_t kLink = 2;

    /// `absent`: further stations that the agent lists and that are switched off.
    Stations(std::size_t stations, std::size_t absent, std::vector<Path> announceTo)
    {
        const Identity air = newIdentity(m_random);
        Config agent = configFor(Role::Agent, air);
        agent.announceTo = std::move(announceTo);
        m_counters.resize(stations);
        std::vector<Config> configs;
        for (std::size_t i = 0; i < stations + absent; ++i) {
            Config config = configFor(Role::Station, newIdentity(m_random));
            agent.peers.push_back({publicKeyOf(*config.identity), "station", PeerRole::Observer, {}, {}});
            config.peers.push_back({publicKeyOf(*air), "agent", PeerRole::Pilot, {}, {}});
            configs.push_back(std::move(config));
        }
        m_agent = std::make_unique<Endpoint>(std::move(agent), m_random, m_agentCounters, now);
        for (std::size_t i = 0; i < stations; ++i) {
            m_stations.push_back(std::make_unique<Endpoint>(std::move(configs[i]), m_random, m_counters[i], now));
            m_stations.back()->setCallAt(now, {Path{LinkId{1}, {}}});
        }
    }

    static Path pathOf(std::size_t station)
    {
        Path path{LinkId{kLink}, {}};
        path.remote.ip[14] = static_cast<std::uint8_t>((1 + station) >> 8);
        path.remote.ip[15] = static_cast<std::uint8_t>(1 + station);
        path.remote.port = 14550;
        return path;
    }

    void run(Duration span)
    {
        for (const TimePoint end = now + span; now < end; now += 10ms) {
            if (m_agent->nextDeadline() <= now)
                m_agent->handleDeadline(now);
            for (const auto &station : m_stations) {
                if (station->nextDeadline() <= now)
                    station->handleDeadline(now);
            }
            while (pump()) {}
        }
    }
    std::size_t sessions() const { return m_agent->sessions().size(); }
    /// From now on the agent's datagrams are counted, and no end receives anything.
    void cut() { m_cut = true; }
    void forgetCounts()
    {
        announcements.clear();
        bytes = 0;
    }

    TimePoint now{1h};
    std::map<Path, int> announcements; ///< by target
    std::uint64_t bytes = 0;           ///< that the agent sent by itself

private:
    bool pump()
    {
        bool any = false;
        while (const auto sent = m_agent->pollTransmit()) {
            any = true;
            bytes += sent->bytes.size();
            announcements[sent->to] += sent->bytes[0] == 0x58;
            for (std::size_t i = 0; i < m_stations.size() && !m_cut; ++i) {
                Bytes copy(sent->bytes.begin(), sent->bytes.end());
                if (sent->to == pathOf(i))
                    m_stations[i]->handleDatagram(now, Path{LinkId{1}, {}}, copy);
            }
        }
        while (m_agent->pollEvent()) {}
        for (std::size_t i = 0; i < m_stations.size(); ++i) {
            while (const auto sent = m_stations[i]->pollTransmit()) {
                any = true;
                Bytes copy(sent->bytes.begin(), sent->bytes.end());
                if (!m_cut)
                    m_agent->handleDatagram(now, pathOf(i), copy);
            }
            while (m_stations[i]->pollEvent()) {}
        }
        return any;
    }

    SeededRandom m_random{7};
    MemoryCounterStore m_agentCounters;
    std::vector<MemoryCounterStore> m_counters;
    std::unique_ptr<Endpoint> m_agent;
    std::vector<std::unique_ptr<Endpoint>> m_stations;
    bool m_cut = false;
};

Path farModem()
{
    return {LinkId{3}, {{}, 14550}};
}

} // namespace

class AnnouncementsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void silentStationsAreAllAnnouncedTo_data();
    void silentStationsAreAllAnnouncedTo();
    void eachLinkHasItsInterval();
};

void AnnouncementsTest::silentStationsAreAllAnnouncedTo_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("perStation"); // announcements in 10 s
    for (const int count : {1, 12, 47})
        QTest::addRow("%d", count) << count << 20;
    QTest::addRow("200, in turn") << 200 << 4;
}

/// All stations fall silent at once, as in an outage of the agent's modem.
void AnnouncementsTest::silentStationsAreAllAnnouncedTo()
{
    QFETCH(int, count);
    QFETCH(int, perStation);
    Stations stations(static_cast<std::size_t>(count), 0, {farModem()});
    stations.run(60s);
    QCOMPARE(stations.sessions(), static_cast<std::size_t>(count));
    stations.cut();
    stations.run(5s);
    stations.forgetCounts();
    stations.run(10s);
    for (int i = 0; i < count; ++i) {
        const int sent = stations.announcements[Stations::pathOf(static_cast<std::size_t>(i))];
        QVERIFY2(sent >= perStation, qPrintable(QStringLiteral("station %1 of %2: %3").arg(i).arg(count).arg(sent)));
    }
    QVERIFY(stations.announcements[farModem()] >= perStation);
    // 48 announcements and 16 requests in a round at most, and the reports of the sessions.
    QVERIFY(stations.bytes <= 20u * (48 * 127 + 16 * 130) + static_cast<unsigned>(count) * 11 * 130);
}

/// A listed station is switched off. On the link with a session the agent looks for it every 2 s, on an idle one every 0.5 s.
void AnnouncementsTest::eachLinkHasItsInterval()
{
    Path other{LinkId{Stations::kLink}, {}};
    other.remote.port = 14999;
    for (const bool idleLink : {false, true}) {
        std::vector<Path> targets{Stations::pathOf(0), other};
        if (idleLink)
            targets.push_back(farModem());
        Stations stations(1, 1, targets);
        stations.run(5s);
        QCOMPARE(stations.sessions(), std::size_t(1));
        stations.forgetCounts();
        stations.run(60s);
        QCOMPARE(stations.announcements[Stations::pathOf(0)], 0);
        QCOMPARE(stations.announcements[other], 30);
        QCOMPARE(stations.announcements[farModem()], idleLink ? 120 : 0);
    }
}

SKYSEAL_TEST(AnnouncementsTest)
#include "announcements_test.moc"
