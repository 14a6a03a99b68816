// One agent and several stations on one link, as behind a router or at a listening port: the first station does not keep the
// others out, and an active session costs few announcements.
#include "core/crypto/x25519.h"
#include "core/crypto/init_crypto.h"
#include "pair.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::channel;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

constexpr std::uint8_t kAnnouncement = 0x58;
constexpr Duration kStep = 10ms;

/// Broadcasts reach every end; nothing is lost, and each delivery takes one step.
class Crowd
{
public:
    explicit Crowd(std::size_t stations)
    {
        m_air.identity = newIdentity();
        for (std::size_t i = 0; i < stations; ++i)
            m_stations.emplace_back().identity = newIdentity();
        Config config = configOf(Role::Agent, m_air);
        for (const End &station : m_stations)
            config.peers.push_back({station.identity->publicKey, "station", PeerRole::Observer, {}, {}});
        config.announceTo.push_back(Path{LinkId{1}, {}});
        m_air.endpoint = std::make_unique<Endpoint>(std::move(config), m_random, m_air.counters, m_now);
    }
    void start(std::size_t station)
    {
        End &end = m_stations[station];
        Config config = configOf(Role::Station, end);
        config.peers.push_back({m_air.identity->publicKey, "air", PeerRole::Pilot, {}, {}});
        end.endpoint = std::make_unique<Endpoint>(std::move(config), m_random, end.counters, m_now);
    }
    /// Restarts, if requested, from another port.
    void move(std::size_t station) { ++m_stations[station].port; }
    void kill(std::size_t station) { m_stations[station].endpoint.reset(); }
    bool up(std::size_t station) const
    {
        return m_stations[station].endpoint && !m_stations[station].endpoint->sessions().empty();
    }
    std::vector<Event> &events(std::size_t station) { return m_stations[station].events; }

    bool run(Duration span, const std::function<bool()> &until = {})
    {
        for (const TimePoint end = m_now + span; m_now < end; m_now += kStep) {
            if (until && until())
                return true;
            step();
        }
        return until && until();
    }
    /// Within this time.
    int announcementsIn(Duration span)
    {
        m_announcements = 0;
        run(span);
        return m_announcements;
    }

private:
    struct End
    {
        std::shared_ptr<const crypto::X25519KeyPair> identity;
        std::unique_ptr<Endpoint> endpoint;
        MemoryCounterStore counters;
        std::vector<Event> events;
        std::uint16_t port = 14550;
    };

    std::shared_ptr<const crypto::X25519KeyPair> newIdentity()
    {
        return std::make_shared<crypto::X25519KeyPair>(crypto::X25519KeyPair::generate(m_random));
    }
    static Config configOf(Role role, const End &end)
    {
        Config config;
        config.role = role;
        config.identity = end.identity;
        config.policy = {defaultSuites(), false, false};
        return config;
    }
    Path pathOf(std::size_t station) const
    {
        Path path{LinkId{1}, {}};
        path.remote.ip[15] = static_cast<std::uint8_t>(station + 1);
        path.remote.port = m_stations[station].port;
        return path;
    }
    static Path pathOfAir()
    {
        Path path{LinkId{1}, {}};
        path.remote.ip[15] = 100;
        path.remote.port = 40000;
        return path;
    }
    void step()
    {
        std::vector<std::pair<Path, Bytes>> down;
        std::vector<std::pair<std::size_t, Bytes>> up;
        m_air.endpoint->handleDeadline(m_now);
        while (const auto transmit = m_air.endpoint->pollTransmit()) {
            down.emplace_back(transmit->to, Bytes(transmit->bytes.begin(), transmit->bytes.end()));
            m_announcements += transmit->bytes[0] == kAnnouncement;
        }
        while (auto event = m_air.endpoint->pollEvent())
            m_air.events.push_back(std::move(*event));
        for (std::size_t i = 0; i < m_stations.size(); ++i) {
            End &station = m_stations[i];
            if (!station.endpoint)
                continue;
            station.endpoint->handleDeadline(m_now);
            for (auto &[to, bytes] : down) {
                Bytes copy = bytes;
                if (to.remote == Address{} || to == pathOf(i))
                    station.endpoint->handleDatagram(m_now, pathOfAir(), copy);
            }
            while (const auto transmit = station.endpoint->pollTransmit())
                up.emplace_back(i, Bytes(transmit->bytes.begin(), transmit->bytes.end()));
            while (auto event = station.endpoint->pollEvent())
                station.events.push_back(std::move(*event));
        }
        for (auto &[from, bytes] : up)
            m_air.endpoint->handleDatagram(m_now, pathOf(from), bytes);
    }

    SeededRandom m_random{20261121};
    TimePoint m_now{1h};
    End m_air;
    std::vector<End> m_stations;
    int m_announcements = 0;
};

} // namespace

class ManyStationsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void firstStationDoesNotBlockOthers();
    void activeSessionsNeedFewAnnouncements();
    void restartedStationIsBackSoon();
};

void ManyStationsTest::initTestCase()
{
    QVERIFY(crypto::initCrypto());
}

void ManyStationsTest::firstStationDoesNotBlockOthers()
{
    Crowd crowd(2);
    crowd.start(0);
    QVERIFY(crowd.run(1s, [&] { return crowd.up(0); }));
    crowd.run(30s);
    crowd.start(1);
    QVERIFY(crowd.run(3s, [&] { return crowd.up(1); }));
    crowd.run(30s);
    QVERIFY(crowd.up(0) && crowd.up(1));
    QCOMPARE(crowd.events(0).size(), std::size_t(1)); // up, and undisturbed since
    QCOMPARE(crowd.events(1).size(), std::size_t(1));
}

void ManyStationsTest::activeSessionsNeedFewAnnouncements()
{
    Crowd crowd(2);
    const int alone = crowd.announcementsIn(10s);
    QVERIFY2(alone >= 19 && alone <= 21, qPrintable(QString::number(alone)));
    crowd.start(0);
    QVERIFY(crowd.run(1s, [&] { return crowd.up(0); }));
    const int beside = crowd.announcementsIn(20s);
    QVERIFY2(beside >= 9 && beside <= 11, qPrintable(QString::number(beside)));
    crowd.start(1);
    QVERIFY(crowd.run(3s, [&] { return crowd.up(1); }));
    crowd.run(1s); // the last one's report
    QCOMPARE(crowd.announcementsIn(60s), 0);
}

void ManyStationsTest::restartedStationIsBackSoon()
{
    for (const bool elsewhere : {false, true}) {
        Crowd crowd(3);
        for (const std::size_t station : {0, 1})
            crowd.start(station);
        QVERIFY(crowd.run(3s, [&] { return crowd.up(0) && crowd.up(1); }));
        crowd.kill(1);
        crowd.run(100ms);
        if (elsewhere)
            crowd.move(1);
        crowd.start(1);
        QVERIFY(crowd.run(3s, [&] { return crowd.up(1); }));
        QCOMPARE(crowd.events(0).size(), std::size_t(1));
    }
}

SKYSEAL_TEST_APPLESS(ManyStationsTest)
#include "many_stations_test.moc"
