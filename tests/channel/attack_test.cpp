// Attacks on the wire: what an attacker can send, change, hold back and repeat. After each one the session is up, the stream goes
// on, and the counter that it belongs to has moved by exactly what was done.
#include "core/base/hex.h"
#include "core/crypto/init_crypto.h"
#include "pair.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;
using crypto::SuiteId;

class AttackTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(crypto::initCrypto());
        qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    }
    void eavesdropping_data() { everySuite(); }
    void eavesdropping();
    void keystreamReuse_data() { everySuite(); }
    void keystreamReuse();
    void everyBitFlipped_data() { everySuite(); }
    void everyBitFlipped();
    void everyLength_data() { everySuite(); }
    void everyLength();
    void fabricatedRecords_data() { everySuite(); }
    void fabricatedRecords();
    void injectedGarbage();
    void oversizedDatagrams();
    void replayOfEverything_data() { everySuite(); }
    void replayOfEverything();
    void replayOfAnEarlierSession();
    void reflection();
    void acrossSuitesAndEpochs();
    void acrossSessions();
    void windowPoisoning();
    void hijackOfAnAddress();
    void storm();
    void forgeriesInAFlood();
    void handshakeFlood();
    void noMoreOutThanIn();
    void replayedAnnouncementsEndNothing();
    void killedTwoHundredTimes();
    void everyControlRecordDropped();

private:
    static constexpr std::uint64_t kSeed = 20240607;
    void everySuite();
    std::unique_ptr<Pair> pairUnder(SuiteId suite, LinkModel link = {});

    std::mt19937_64 m_random{kSeed};
};

namespace {

struct Caught
{
    Flight flight;
    std::uint64_t number = 0;
};

/// Seals one frame from the agent and keeps the record off the wire.
Caught catchOne(Pair &pair, std::size_t size = 28, Side from = Air)
{
    Caught caught;
    const auto before = std::exchange(pair.link.attacker, [&caught](TimePoint, Flight &flight) {
        caught.flight = flight;
        return false;
    });
    caught.number = pair.sendFrame(from, size);
    pair.link.attacker = before;
    pair.dropped[from].erase(caught.number); // It will be delivered by hand.
    return caught;
}

/// Hands a datagram to an endpoint; true when frames came out.
bool offer(Pair &pair, Side to, Bytes bytes, std::optional<Path> from = {})
{
    return pair.ends[to].endpoint->handleDatagram(pair.now, from.value_or(pair.pathOf(to == Air ? Ground : Air)), bytes).has_value();
}

ReceiveCounters received(const Pair::End &end) { return end.endpoint->stats(end.session())->rx; }
std::uint64_t refused(const ReceiveCounters &c) { return c.forged + c.replayed + c.malformed; }
std::uint64_t refusedInAll(const Pair::End &end) { return refused(received(end)) + refused(end.endpoint->strays()); }

/// The session of before still carries frames both ways.
bool aliveAndExact(Pair &pair)
{
    pair.run(10ms);
    const auto ground = pair.ground().delivered.size(), air = pair.air().delivered.size();
    for (int i = 0; i < 5; ++i) {
        pair.sendFrame(Air);
        pair.sendFrame(Ground);
    }
    pair.run(2s);
    return pair.ground().delivered.size() == ground + 5 && pair.air().delivered.size() == air + 5
        && pair.ground().all<SessionUp>().size() == 1 && pair.ground().all<SessionDown>().empty()
        && pair.accountFrom(Air).empty() && pair.accountFrom(Ground).empty();
}

} // namespace

void AttackTest::everySuite()
{
    QTest::addColumn<int>("suite");
    for (const auto &info : crypto::suites()) {
        if (info.id != SuiteId::None && crypto::suiteAvailable(info.id))
            QTest::newRow(info.name.data()) << static_cast<int>(info.id);
    }
}

std::unique_ptr<Pair> AttackTest::pairUnder(SuiteId suite, LinkModel link)
{
    PairOptions options;
    options.seed = kSeed;
    options.link = link;
    auto pair = std::make_unique<Pair>(options);
    pair->run(5s, [&] { return pair->bothUp(); });
    pair->run(1s);
    if (suite != SuiteId::ChaCha20Poly1305) {
        pair->ground().endpoint->switchSuite(pair->now, pair->ground().session(), suite);
        pair->run(5s);
    }
    return pair;
}

#define PAIR_UNDER_SUITE \
    QFETCH(int, suite); \
    auto pairOwner = pairUnder(static_cast<SuiteId>(suite)); \
    Pair &pair = *pairOwner; \
    QVERIFY(pair.bothUp()); \
    QCOMPARE(static_cast<int>(pair.ground().endpoint->sessionInfo(pair.ground().session())->suite), suite)

void AttackTest::eavesdropping()
{
    PAIR_UNDER_SUITE;
    // Frames of zeros but for their number: on the wire every byte behind the header is as good as random.
    std::array<std::uint64_t, 256> histogram{};
    std::uint64_t total = 0;
    pair.link.attacker = [&](TimePoint, Flight &flight) {
        if (flight.tag == 0)
            return true;
        for (std::size_t i = 6; i < flight.bytes.size(); ++i, ++total)
            ++histogram[flight.bytes[i]];
        return true;
    };
    for (int i = 0; i < 2000; ++i) {
        pair.sendFrame(Air, 100);
        pair.run(10ms);
    }
    double chi = 0;
    const double expected = static_cast<double>(total) / 256;
    for (const std::uint64_t count : histogram)
        chi += (static_cast<double>(count) - expected) * (static_cast<double>(count) - expected) / expected;
    QVERIFY2(chi < 350, qPrintable(QString::number(chi))); // 255 degrees of freedom: 1 in 50,000 runs of a uniform source
    QVERIFY(aliveAndExact(pair));
}

void AttackTest::keystreamReuse()
{
    PAIR_UNDER_SUITE;
    // Equal plaintexts, so two records under one keystream would be equal, or differ by a known difference at most.
    std::set<std::string> bodies;
    std::set<std::uint32_t> counters;
    std::uint64_t records = 0;
    const Bytes frame(28, 0xfd);
    Bytes record(28 + kMaxRecordOverhead);
    for (; records < 20000; ++records) {
        const auto size = pair.air().endpoint->seal(pair.now, pair.air().session(), frame, record);
        QVERIFY(size);
        counters.insert(record[3] | record[4] << 8u | record[5] << 16u);
        bodies.insert(toHex(ByteView(record).subspan(6, 12)));
    }
    QCOMPARE(counters.size(), records);
    QCOMPARE(bodies.size(), records);
}

void AttackTest::everyBitFlipped()
{
    PAIR_UNDER_SUITE;
    for (const std::size_t size : {9u, 28u, 64u}) {
        const Caught caught = catchOne(pair, size);
        const auto before = refusedInAll(pair.ground());
        for (std::size_t bit = 0; bit < caught.flight.bytes.size() * 8; ++bit) {
            Bytes changed = caught.flight.bytes;
            changed[bit / 8] = static_cast<std::uint8_t>(changed[bit / 8] ^ 1u << bit % 8);
            QVERIFY(!offer(pair, Ground, changed));
        }
        QCOMPARE(refusedInAll(pair.ground()) - before, std::uint64_t(caught.flight.bytes.size() * 8));
        pair.link.inject(pair.now, caught.flight);
        pair.run(1ms);
        QCOMPARE(pair.ground().delivered[caught.number], 1);
    }
    QVERIFY(aliveAndExact(pair));
}

void AttackTest::everyLength()
{
    PAIR_UNDER_SUITE;
    const Caught caught = catchOne(pair, 40);
    const auto before = refusedInAll(pair.ground());
    const std::size_t full = caught.flight.bytes.size();
    for (std::size_t length = 0; length <= full + 32; ++length) {
        Bytes changed = caught.flight.bytes;
        changed.resize(length, 0xa5);
        if (length != full)
            QVERIFY(!offer(pair, Ground, changed));
    }
    QCOMPARE(refusedInAll(pair.ground()) - before, std::uint64_t(full + 32));
    pair.link.inject(pair.now, caught.flight);
    QVERIFY(aliveAndExact(pair));
}

void AttackTest::fabricatedRecords()
{
    PAIR_UNDER_SUITE;
    const Caught caught = catchOne(pair, 40);
    pair.link.inject(pair.now, caught.flight);
    pair.run(10ms);
    const auto before = received(pair.ground());
    constexpr std::uint64_t kForgeries = 5000;
    for (std::uint64_t i = 0; i < kForgeries; ++i) {
        Bytes forged = caught.flight.bytes;
        const std::uint32_t counter = 1000 + static_cast<std::uint32_t>(m_random() % 0xfff000);
        for (unsigned k = 0; k < 3; ++k)
            forged[3 + k] = static_cast<std::uint8_t>(counter >> 8 * k);
        for (std::size_t k = i % 2 ? 6 : forged.size() - 16; k < forged.size(); ++k)
            forged[k] = static_cast<std::uint8_t>(m_random());
        QVERIFY(!offer(pair, Ground, forged));
    }
    const auto after = received(pair.ground());
    QCOMPARE(after.forged - before.forged, kForgeries);
    QCOMPARE(after.lost, before.lost);
    QCOMPARE(after.good, before.good);
    QVERIFY(aliveAndExact(pair));
    const auto alarms = pair.ground().all<ForgeryAlarm>();
    QVERIFY(!alarms.empty() && alarms.size() <= 3);
    std::uint64_t told = 0;
    for (const ForgeryAlarm &alarm : alarms)
        told += alarm.forged;
    QCOMPARE(told, received(pair.ground()).forged);
}

void AttackTest::injectedGarbage()
{
    auto owner = pairUnder(SuiteId::Aes256Gcm);
    Pair &pair = *owner;
    const int count = qEnvironmentVariableIsSet("SKYSEAL_FORGERIES") ? qEnvironmentVariableIntValue("SKYSEAL_FORGERIES") : 50000;
    Bytes datagram;
    for (int i = 0; i < count; ++i) {
        datagram.resize(m_random() % 1501);
        for (auto &byte : datagram)
            byte = static_cast<std::uint8_t>(m_random());
        if (!datagram.empty())
            datagram[0] = static_cast<std::uint8_t>(i);
        QVERIFY(!offer(pair, i & 1 ? Ground : Air, datagram));
    }
    QCOMPARE(refusedInAll(pair.ground()) + refusedInAll(pair.air()), static_cast<std::uint64_t>(count));
    QVERIFY(aliveAndExact(pair));
}

void AttackTest::oversizedDatagrams()
{
    auto owner = pairUnder(SuiteId::Aes256Cbc);
    Pair &pair = *owner;
    Caught caught = catchOne(pair);
    for (const std::size_t size : {1201u, 9000u, 65507u}) {
        for (int first = 0x40; first < 0x80; ++first) {
            Bytes datagram = caught.flight.bytes;
            datagram.resize(size);
            datagram[0] = static_cast<std::uint8_t>(first);
            QVERIFY(!offer(pair, Ground, datagram));
            QVERIFY(!offer(pair, Air, datagram));
        }
    }
    pair.link.inject(pair.now, caught.flight);
    QVERIFY(aliveAndExact(pair));
}

void AttackTest::replayOfEverything()
{
    PAIR_UNDER_SUITE;
    std::vector<Flight> recorded;
    pair.link.attacker = [&](TimePoint, Flight &flight) {
        recorded.push_back(flight);
        return true;
    };
    for (int i = 0; i < 300; ++i) {
        pair.sendFrame(Air);
        pair.sendFrame(Ground);
        pair.run(10ms);
    }
    pair.run(50ms);
    pair.link.attacker = nullptr;
    const auto replayAll = [&] {
        const auto ground = received(pair.ground()), air = received(pair.air());
        for (const Flight &flight : recorded)
            QVERIFY(!offer(pair, flight.from == Air ? Ground : Air, flight.bytes));
        QCOMPARE(received(pair.ground()).replayed + received(pair.air()).replayed - ground.replayed - air.replayed,
                 std::uint64_t(recorded.size()));
        QCOMPARE(received(pair.ground()).good, ground.good);
    };
    replayAll();
    pair.run(1s);
    replayAll();
    for (int i = 0; i < 2100; ++i) {
        pair.sendFrame(Air);
        pair.sendFrame(Ground);
    }
    pair.run(100ms);
    replayAll();
    QVERIFY(aliveAndExact(pair));
}

void AttackTest::replayOfAnEarlierSession()
{
    PairOptions options;
    options.seed = kSeed;
    Pair pair(options);
    std::vector<Flight> recorded;
    pair.link.attacker = [&](TimePoint, Flight &flight) {
        recorded.push_back(flight);
        return true;
    };
    pair.every(20ms, [&] {
        pair.sendFrame(Air);
        pair.sendFrame(Ground);
    });
    pair.run(5s);
    pair.link.attacker = nullptr;
    pair.kill(Ground);
    pair.kill(Air);
    pair.start(Ground);
    pair.start(Air);
    QVERIFY(pair.run(3s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    pair.stopTraffic();
    pair.run(1s);
    const auto ground = pair.ground().delivered.size(), air = pair.air().delivered.size();
    for (const Flight &flight : recorded) {
        QVERIFY(!offer(pair, flight.from == Air ? Ground : Air, flight.bytes));
        pair.run(1ms);
    }
    QCOMPARE(pair.ground().delivered.size(), ground);
    QCOMPARE(pair.air().delivered.size(), air);
    QCOMPARE(pair.ground().endpoint->sessions().size(), 1u);
    QCOMPARE(pair.ground().all<SessionUp>().size(), 2u);
    QCOMPARE(pair.air().all<SessionUp>().size(), 2u);
    QCOMPARE(pair.ground().all<SessionDown>().size(), 0u); // The endpoints that had the first session are gone.
}

void AttackTest::reflection()
{
    PairOptions options;
    options.seed = kSeed;
    Pair pair(options);
    // Each datagram, handshake included, also goes back to where it came from.
    std::vector<Flight> back;
    pair.link.attacker = [&](TimePoint, Flight &flight) {
        back.push_back(flight);
        return true;
    };
    pair.every(20ms, [&] {
        pair.sendFrame(Air);
        pair.sendFrame(Ground);
    });
    for (int i = 0; i < 100; ++i) {
        pair.run(30ms);
        const auto reflected = std::exchange(back, {});
        for (const Flight &flight : reflected)
            QVERIFY(!offer(pair, flight.from, flight.bytes));
    }
    pair.link.attacker = nullptr;
    pair.stopTraffic();
    pair.run(1s);
    QCOMPARE(received(pair.ground()).replayed, std::uint64_t(0));
    QVERIFY(refusedInAll(pair.ground()) > 100 && refusedInAll(pair.air()) > 100);
    QVERIFY(aliveAndExact(pair));
}

void AttackTest::acrossSuitesAndEpochs()
{
    for (const auto &info : crypto::suites()) {
        if (info.id == SuiteId::None || info.id == SuiteId::ChaCha20Poly1305 || !crypto::suiteAvailable(info.id))
            continue;
        auto owner = pairUnder(SuiteId::ChaCha20Poly1305);
        Pair &pair = *owner;
        const Caught before = catchOne(pair);
        pair.ground().endpoint->switchSuite(pair.now, pair.ground().session(), info.id);
        pair.run(1s);
        // The old record under the new epoch's bits, with counters that the new epoch has not seen.
        for (std::uint8_t bits = 0; bits < 4; ++bits) {
            Bytes changed = before.flight.bytes;
            changed[0] = static_cast<std::uint8_t>((changed[0] & ~3) | bits);
            if (changed != before.flight.bytes)
                QVERIFY(!offer(pair, Ground, changed));
        }
        // As it is, it is a late one of the previous epoch.
        pair.link.inject(pair.now, before.flight);
        QVERIFY(aliveAndExact(pair));
        QCOMPARE(pair.ground().delivered[before.number], 1);
    }
}

void AttackTest::acrossSessions()
{
    auto one = pairUnder(SuiteId::Aes256Ctr);
    PairOptions options;
    options.seed = kSeed + 1;
    Pair two(options);
    QVERIFY(two.run(2s, [&] { return two.bothUp(); }));
    const Caught foreign = catchOne(two);
    const Caught own = catchOne(*one);
    Bytes changed = foreign.flight.bytes;
    changed[0] = own.flight.bytes[0];
    changed[1] = own.flight.bytes[1];
    changed[2] = own.flight.bytes[2];
    changed[4] = 0x10; // A counter that is new to it.
    const auto before = received(one->ground()).forged;
    QVERIFY(!offer(*one, Ground, changed));
    QCOMPARE(received(one->ground()).forged, before + 1);
    one->link.inject(one->now, own.flight);
    QVERIFY(aliveAndExact(*one));
}

void AttackTest::windowPoisoning()
{
    auto owner = pairUnder(SuiteId::ChaCha20);
    Pair &pair = *owner;
    const Caught caught = catchOne(pair);
    for (std::uint32_t ahead = 1; ahead < 1u << 24; ahead = ahead * 2 + 1) {
        Bytes changed = caught.flight.bytes;
        for (unsigned k = 0; k < 3; ++k)
            changed[3 + k] = static_cast<std::uint8_t>((ahead | 0x800000) >> 8 * k);
        QVERIFY(!offer(pair, Ground, changed));
    }
    pair.link.inject(pair.now, caught.flight);
    QVERIFY(aliveAndExact(pair));
    QCOMPARE(received(pair.ground()).lost, std::uint64_t(0));
}

void AttackTest::hijackOfAnAddress()
{
    auto owner = pairUnder(SuiteId::ChaCha20Poly1305);
    Pair &pair = *owner;
    const Path home = pair.ground().endpoint->recordPath(pair.ground().session());
    Path thief = home;
    thief.remote.port = 6666;
    std::vector<Flight> recorded;
    pair.link.attacker = [&](TimePoint, Flight &flight) {
        recorded.push_back(flight);
        return true;
    };
    for (int i = 0; i < 50; ++i) {
        pair.sendFrame(Air);
        pair.run(5ms);
    }
    const Caught late = catchOne(pair);
    pair.sendFrame(Air);
    pair.run(10ms);
    for (const Flight &flight : recorded) {
        if (flight.from != Air)
            continue;
        offer(pair, Ground, flight.bytes, thief);
        Bytes damaged = flight.bytes;
        damaged.back() ^= 1;
        damaged[4] ^= 0x10;
        offer(pair, Ground, damaged, thief);
    }
    QCOMPARE(pair.ground().endpoint->recordPath(pair.ground().session()), home);
    // Even a genuine record that was held back and is not the newest any more does not move the session.
    QVERIFY(offer(pair, Ground, late.flight.bytes, thief));
    ++pair.ground().delivered[late.number];
    QCOMPARE(pair.ground().endpoint->recordPath(pair.ground().session()), home);
    QCOMPARE(pair.ground().all<PeerMoved>().size(), 0u);
    QVERIFY(aliveAndExact(pair));
}

void AttackTest::storm()
{
    LinkModel link;
    link.delay = 50ms;
    link.jitter = 250ms;
    link.reorder = 0.5;
    link.reorderBy = 100ms;
    link.duplicate = 0.5;
    auto owner = pairUnder(SuiteId::Aes256Gcm, link);
    Pair &pair = *owner;
    pair.every(5ms, [&] {
        pair.sendFrame(Air);
        pair.sendFrame(Ground);
    });
    pair.run(20s);
    pair.stopTraffic();
    pair.run(3s);
    QCOMPARE(QString::fromStdString(pair.accountFrom(Air)), QString());
    QCOMPARE(QString::fromStdString(pair.accountFrom(Ground)), QString());
    QCOMPARE(pair.dropped[Air].size() + pair.dropped[Ground].size(), 0u);
    QVERIFY(received(pair.ground()).late > 1000 && received(pair.ground()).replayed > 1000);
    QCOMPARE(pair.ground().all<ForgeryAlarm>().size(), 0u);
}

void AttackTest::forgeriesInAFlood()
{
    auto owner = pairUnder(SuiteId::ChaCha20Poly1305);
    Pair &pair = *owner;
    const Caught sample = catchOne(pair);
    pair.link.inject(pair.now, sample.flight);
    const auto before = received(pair.ground()).forged;
    std::uint64_t forged = 0;
    pair.every(1ms, [&] {
        for (int i = 0; i < 50; ++i, ++forged) {
            Bytes bytes = sample.flight.bytes;
            bytes[5] = 0x40;
            bytes[20] = static_cast<std::uint8_t>(i);
            offer(pair, Ground, bytes);
        }
    });
    pair.every(20ms, [&] { pair.sendFrame(Air); });
    pair.run(3s);
    pair.stopTraffic();
    QCOMPARE(received(pair.ground()).forged - before, forged);
    QVERIFY(pair.ground().all<ForgeryAlarm>().size() <= 5);
    QVERIFY(aliveAndExact(pair));
}

void AttackTest::handshakeFlood()
{
    // First messages without the right mac1: no answer, no state, and the session of a station that calls meanwhile comes up.
    PairOptions options;
    options.seed = kSeed;
    Pair pair(options);
    pair.kill(Ground);
    std::uint64_t answered = 0;
    Bytes flood(127);
    pair.every(1ms, [&] {
        for (int i = 0; i < 20; ++i) {
            for (auto &byte : flood)
                byte = static_cast<std::uint8_t>(m_random());
            flood[0] = 0x59;
            offer(pair, Air, flood);
        }
    });
    pair.link.attacker = [&](TimePoint, Flight &flight) {
        answered += flight.bytes[0] == 0x5a;
        return true;
    };
    pair.run(2s);
    QCOMPARE(answered, std::uint64_t(0));
    pair.start(Ground);
    QVERIFY(pair.run(3s, [&] { return pair.bothUp(); }));
}

void AttackTest::noMoreOutThanIn()
{
    // Nobody authenticated: whatever is repeated at either end, no more comes out than goes in.
    PairOptions options;
    options.seed = kSeed;
    Pair pair(options);
    std::vector<Flight> recorded;
    pair.link.attacker = [&](TimePoint, Flight &flight) {
        recorded.push_back(flight);
        return true;
    };
    pair.run(2s);
    QVERIFY(pair.bothUp());
    for (const Side victim : {Ground, Air}) {
        Pair fresh(options); // The same keys, so what was recorded is meant for these.
        fresh.kill(victim == Ground ? Air : Ground);
        fresh.run(10ms);
        std::uint64_t in = 0, out = 0;
        fresh.link.attacker = [&](TimePoint, Flight &flight) {
            out += flight.bytes[0] != 0x58 ? flight.bytes.size() : 0; // Announcements are no answer to anything.
            return false;
        };
        for (int round = 0; round < 100; ++round) {
            for (const Flight &flight : recorded) {
                if (flight.from == victim)
                    continue;
                offer(fresh, victim, flight.bytes);
                in += flight.bytes.size();
                fresh.run(20ms);
            }
        }
        QVERIFY2(out <= in, qPrintable(QStringLiteral("%1 out, %2 in").arg(out).arg(in)));
    }
}

void AttackTest::replayedAnnouncementsEndNothing()
{
    PairOptions options;
    options.seed = kSeed;
    Pair pair(options);
    std::optional<Flight> announcement;
    pair.link.attacker = [&](TimePoint, Flight &flight) {
        if (flight.bytes[0] == 0x58)
            announcement = flight;
        return true;
    };
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    QVERIFY(announcement);
    pair.link.attacker = nullptr;
    pair.run(1s);
    Path thief = pair.pathOf(Air);
    thief.remote.port = 6666;
    for (int i = 0; i < 200; ++i) {
        offer(pair, Ground, announcement->bytes, thief);
        pair.run(100ms);
    }
    QVERIFY(aliveAndExact(pair));
    QCOMPARE(pair.air().all<SessionUp>().size(), 1u);
}

void AttackTest::killedTwoHundredTimes()
{
    // Equal plaintexts through 200 lives of either end: no two records are equal, so no pair of key and nonce came twice.
    PairOptions options;
    options.seed = kSeed;
    Pair pair(options);
    std::set<std::string> bodies;
    std::uint64_t records = 0;
    const Bytes frame(40, 0xfd);
    Bytes record(40 + kMaxRecordOverhead);
    for (int life = 0; life < 200; ++life) {
        QVERIFY(pair.run(6s, [&] { return pair.bothUp(); }));
        for (auto &end : pair.ends) {
            for (int i = 0; i < 10; ++i, ++records) {
                const auto size = end.endpoint->seal(pair.now, end.session(), frame, record);
                QVERIFY(size);
                bodies.insert(toHex(ByteView(record).subspan(6, 20)));
            }
        }
        const Side victim = life % 2 ? Ground : Air;
        pair.kill(victim);
        pair.run(std::chrono::milliseconds(m_random() % 50));
        pair.start(victim);
    }
    QCOMPARE(bodies.size(), records);
}

void AttackTest::everyControlRecordDropped()
{
    PairOptions options;
    options.seed = kSeed;
    options.timing.rekeyAfterRecords = 500;
    options.timing.hardStopRecords = 3000;
    Pair pair(options);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    pair.link.attacker = [](TimePoint, Flight &flight) { return flight.tag != 0; }; // Only frames pass.
    const auto before = pair.air().endpoint->stats(pair.air().session())->tx.records;
    pair.every(10ms, [&] { pair.sendFrame(Air); });
    pair.every(20ms, [&] { pair.sendFrame(Ground); });
    QVERIFY(pair.run(60s, [&] { return !pair.air().all<SessionDown>().empty(); }));
    const SessionDown down = pair.air().all<SessionDown>()[0];
    QCOMPARE(down.reason, DownReason::Exhausted);
    QCOMPARE(down.stats.tx.records, std::uint64_t(3000));
    QVERIFY(before < 100);
    // The owner was warned: rekeys were tried and rolled back.
    const auto done = pair.air().all<SwitchDone>();
    QVERIFY(!done.empty());
    for (const SwitchDone &d : done)
        QVERIFY(d.rekey && d.failure != SwitchFailure::None);
    QCOMPARE(QString::fromStdString(pair.accountFrom(Air)), QString());
}

QTEST_GUILESS_MAIN(AttackTest)
#include "attack_test.moc"
