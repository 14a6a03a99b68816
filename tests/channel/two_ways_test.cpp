// An agent with two modems to one station, on a virtual clock: the session uses the way that works, also where the other one
// fails in one direction only, and loses nothing once it has changed over. On another carrier a new session does so.
#include "core/channel/endpoint.h"
#include "tests/channel/pair.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <map>
#include <random>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

constexpr std::size_t kPaths = 2;
constexpr std::uint32_t kSecondOfStation = 9; ///< the station's link to a second way of another carrier

/// The agent has a link to each modem; the station listens at one port, and knows the modems by their addresses.
class TwoWays
{
public:
    /// `second`: carrier of the second way; the first one is datagrams.
    explicit TwoWays(std::uint64_t seed, Carrier second = Carrier::Datagram) : m_random(seed), m_second(second)
    {
        for (const Side side : {Ground, Air})
            m_keys[side] = newIdentity(m_random);
        for (const Side side : {Ground, Air})
            m_ends[side].endpoint = std::make_unique<Endpoint>(configOf(side), m_random, m_ends[side].counters, now);
    }

    /// Loses all that `from` sends through this modem.
    void cut(std::size_t way, Side from, bool isCut) { m_cut[way][from] = isCut; }
    void setDelay(std::size_t way, Duration delay) { m_delay[way] = delay; }
    /// The agent takes no more than so many records of a session, as if it were deaf.
    void setRecordsTaken(std::size_t count) { m_recordsTaken = count; }

    /// Each end seals a frame every 50 ms, as far as it has a session.
    void run(Duration span)
    {
        for (const TimePoint end = now + span; now < end;) {
            TimePoint due = std::min(end, m_nextFrames);
            if (!m_flying.empty())
                due = std::min(due, m_flying.begin()->first);
            for (const End &one : m_ends)
                due = std::min(due, one.endpoint->nextDeadline());
            now = std::max(now, due);
            while (!m_flying.empty() && m_flying.begin()->first <= now)
                arrive(m_flying.extract(m_flying.begin()).mapped());
            for (End &one : m_ends) {
                if (one.endpoint->nextDeadline() <= now)
                    one.endpoint->handleDeadline(now);
            }
            if (now >= m_nextFrames) {
                m_nextFrames += 50ms;
                sendFrame(Ground);
                sendFrame(Air);
            }
            pump();
        }
    }

    bool isUp(Side side) const { return !m_ends[side].endpoint->sessions().empty(); }
    std::size_t sessions(Side side) const { return m_ends[side].ups; }
    /// The frames of `from` that were sealed and arrived at the other end.
    std::uint64_t sealed(Side from) const { return m_ends[from].sealed; }
    std::uint64_t delivered(Side from) const { return m_ends[from == Ground ? Air : Ground].delivered; }
    /// When the other end had a frame last.
    TimePoint lastFrameOf(Side from) const { return m_ends[from == Ground ? Air : Ground].lastFrame; }
    /// The way of the present session.
    std::size_t wayOf(Side side) const
    {
        const Endpoint &endpoint = *m_ends[side].endpoint;
        return wayOf(side, endpoint.recordPath(endpoint.sessions().back()));
    }
    /// Datagrams that the end took for forged, replayed or damaged ones, except records of a session that it has replaced.
    std::uint64_t refused(Side side) const
    {
        const Endpoint &endpoint = *m_ends[side].endpoint;
        const ReceiveCounters rx = endpoint.stats(endpoint.sessions().back())->rx;
        const ReceiveCounters &other = endpoint.unmatched();
        return rx.forged + rx.replayed + rx.malformed + other.forged;
    }

    TimePoint now{1h};

private:
    struct End
    {
        std::unique_ptr<Endpoint> endpoint;
        MemoryCounterStore counters;
        std::size_t ups = 0;
        std::uint64_t sealed = 0, delivered = 0;
        TimePoint lastFrame{};
    };
    struct Datagram
    {
        Side from{};
        std::size_t way = 0;
        Bytes bytes;
    };

    Path pathOf(Side from, std::size_t way) const
    {
        const Carrier carrier = way == 0 ? Carrier::Datagram : m_second;
        if (from == Ground) // as the agent sees it
            return {LinkId{static_cast<std::uint32_t>(2 + way)}, {}, carrier, {}};
        if (carrier != Carrier::Datagram)
            return {LinkId{kSecondOfStation}, {}, carrier, {}};
        Path path{LinkId{1}, {}};
        path.remote.ip[15] = 1;
        path.remote.port = static_cast<std::uint16_t>(40000 + way);
        return path;
    }
    static std::size_t wayOf(Side from, const Path &to)
    {
        if (from == Air)
            return static_cast<std::size_t>(to.link) - 2;
        return to.link == LinkId{kSecondOfStation} ? 1 : to.remote.port - 40000u;
    }

    Config configOf(Side side) const
    {
        const Side other = side == Ground ? Air : Ground;
        Config config;
        config.role = side == Ground ? Role::Station : Role::Agent;
        config.identity = m_keys[side];
        config.peers.push_back({publicKeyOf(*m_keys[other]), "other", PeerRole::Pilot, {}, {}});
        config.policy = {defaultSuites(), false, false};
        for (std::size_t way = 0; side == Air && way < kPaths; ++way)
            config.announceTo.push_back(pathOf(Ground, way));
        return config;
    }

    void sendFrame(Side from)
    {
        Endpoint &endpoint = *m_ends[from].endpoint;
        if (!isUp(from))
            return;
        const SessionId session = endpoint.sessions().back();
        const Bytes frame(28, 0xfd);
        Bytes record(frame.size() + kMaxRecordOverhead);
        if (const auto size = endpoint.seal(now, session, frame, record)) {
            record.resize(*size);
            ++m_ends[from].sealed;
            send(from, endpoint.recordPath(session), std::move(record));
        }
    }
    void send(Side from, const Path &to, Bytes bytes)
    {
        const std::size_t way = wayOf(from, to);
        if (!m_cut[way][from])
            m_flying.emplace(now + m_delay[way], Datagram{from, way, std::move(bytes)});
    }
    void arrive(Datagram datagram)
    {
        End &end = m_ends[datagram.from == Ground ? Air : Ground];
        const bool isRecord = (datagram.bytes[0] & 0xfc) == 0x50;
        if (datagram.from == Ground && isRecord && ++m_records[{datagram.bytes[1], datagram.bytes[2]}] > m_recordsTaken)
            return;
        if (end.endpoint->handleDatagram(now, pathOf(datagram.from, datagram.way), datagram.bytes)) {
            ++end.delivered;
            end.lastFrame = now;
        }
        pump();
    }
    void pump()
    {
        for (const Side side : {Ground, Air}) {
            End &end = m_ends[side];
            while (const auto transmit = end.endpoint->pollTransmit())
                send(side, transmit->to, Bytes(transmit->bytes.begin(), transmit->bytes.end()));
            while (const auto event = end.endpoint->pollEvent())
                end.ups += std::holds_alternative<SessionUp>(*event);
        }
    }

    SeededRandom m_random;
    Carrier m_second;
    std::array<std::shared_ptr<const crypto::X25519KeyPair>, 2> m_keys;
    std::array<End, 2> m_ends;
    std::array<std::array<bool, 2>, kPaths> m_cut{};
    std::array<Duration, kPaths> m_delay{5ms, 5ms};
    std::size_t m_recordsTaken = SIZE_MAX;
    std::map<std::array<std::uint8_t, 2>, std::size_t> m_records; ///< of the station, by connection id
    std::multimap<TimePoint, Datagram> m_flying;
    TimePoint m_nextFrames = now;
};

} // namespace

class TwoWaysTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void bothAtOnceAreOneSession();
    void takesTheWayThatWorks_data();
    void takesTheWayThatWorks();
    void outagesInTurnLeaveNoLongGap();
    void agentThatClaimsToBeDeafCostsLittle();
};

void TwoWaysTest::bothAtOnceAreOneSession()
{
    TwoWays ways(1);
    ways.run(60s);
    for (const Side side : {Ground, Air}) {
        QCOMPARE(ways.sessions(side), std::size_t(1));
        QCOMPARE(ways.wayOf(side), ways.wayOf(Air));
        QVERIFY(ways.sealed(side) > 1100);
        QVERIFY(ways.sealed(side) - ways.delivered(side) <= 1); // under way
        QCOMPARE(ways.refused(side), std::uint64_t(0));
    }
}

void TwoWaysTest::takesTheWayThatWorks_data()
{
    QTest::addColumn<bool>("toGround");
    QTest::addColumn<bool>("toAir");
    QTest::addColumn<int>("delayMs");
    QTest::addColumn<Carrier>("second");
    const std::pair<Carrier, const char *> carriers[] = {
        {Carrier::Datagram, "datagrams"}, {Carrier::Serial, "a serial line"}, {Carrier::Tunnel, "TUNNEL"}};
    for (const auto &[carrier, name] : carriers) {
        for (const int delay : {5, 150}) {
            const auto row = [&, name = name](const char *what) -> QTestData & {
                return QTest::addRow("%s, second way of %s, other way of %d ms", what, name, delay);
            };
            row("both directions are cut") << true << true << delay << carrier;
            row("nothing reaches the station") << true << false << delay << carrier;
            row("nothing reaches the agent") << false << true << delay << carrier;
        }
    }
}

void TwoWaysTest::takesTheWayThatWorks()
{
    QFETCH(bool, toGround);
    QFETCH(bool, toAir);
    QFETCH(int, delayMs);
    QFETCH(Carrier, second);
    const Duration delay = std::chrono::milliseconds(delayMs);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        TwoWays ways(seed, second);
        ways.run(10s + seed * 37ms); // at any moment between two reports
        QVERIFY(ways.isUp(Ground) && ways.isUp(Air));
        const std::size_t used = ways.wayOf(Air), other = 1 - used;
        ways.setDelay(other, delay);
        ways.cut(used, Air, toGround);
        ways.cut(used, Ground, toAir);
        // The agent announces itself there after 1.5 s of silence at the latest, and every 0.5 s. For a new session on another
        // carrier, the station waits for 2.5 s of silence, or for a report that nothing reaches the agent, up to 1 s later.
        ways.run((second == Carrier::Datagram ? 2200ms : 3700ms) + 6 * delay);
        for (const Side side : {Ground, Air})
            QCOMPARE(ways.wayOf(side), other);
        // From then on nothing is lost, also when the former way works again.
        const std::array before{ways.sealed(Ground) - ways.delivered(Ground), ways.sealed(Air) - ways.delivered(Air)};
        const std::array sessions{ways.sessions(Ground), ways.sessions(Air)};
        ways.run(5s);
        ways.cut(used, Air, false);
        ways.cut(used, Ground, false);
        ways.run(20s);
        for (const Side side : {Ground, Air}) {
            QVERIFY(ways.sealed(side) - ways.delivered(side) <= before[side] + 1 + std::uint64_t(delay / 50ms));
            QCOMPARE(ways.sessions(side), sessions[side]);
            QCOMPARE(ways.refused(side), std::uint64_t(0));
        }
    }
}

/// Each way and direction fails and comes back at random, but one way always works.
void TwoWaysTest::outagesInTurnLeaveNoLongGap()
{
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        TwoWays ways(seed);
        std::mt19937_64 random(seed);
        ways.setDelay(1, 60ms);
        ways.run(5s);
        for (int outage = 0; outage < 60; ++outage) {
            const std::size_t good = random() % kPaths, bad = 1 - good;
            ways.cut(good, Air, false);
            ways.cut(good, Ground, false);
            const std::uint64_t what = 1 + random() % 3;
            ways.cut(bad, Air, what & 1);
            ways.cut(bad, Ground, what & 2);
            ways.run(4s + std::chrono::milliseconds(random() % 4000));
            for (const Side side : {Ground, Air})
                QVERIFY2(ways.now - ways.lastFrameOf(side) < 200ms, qPrintable(QStringLiteral("seed %1").arg(seed)));
        }
    }
}

/// An agent that says in all its sessions that it receives nothing makes the station begin others, on both carriers in turn: no
/// more often than it can be quiet for 1.5 s, and under the same limits as any handshake.
void TwoWaysTest::agentThatClaimsToBeDeafCostsLittle()
{
    TwoWays ways(1, Carrier::Tunnel);
    ways.setRecordsTaken(2);
    ways.run(120s);
    QVERIFY2(ways.sessions(Ground) >= 20, qPrintable(QString::number(ways.sessions(Ground))));
    QVERIFY2(ways.sessions(Ground) <= 80, qPrintable(QString::number(ways.sessions(Ground))));
}

SKYSEAL_TEST(TwoWaysTest)
#include "two_ways_test.moc"
