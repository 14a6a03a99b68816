// Attacks on sessions as a whole: floods, reflection, replay of everything, hijacked addresses, killed processes, a wire
// that drops every control record.
#include "attack.h"
#include "core/base/hex.h"
#include "core/crypto/init_crypto.h"

using namespace skyseal;
using namespace skyseal::test;

class AttackSessionTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(crypto::initCrypto());
        qInfo("seed %llu", static_cast<unsigned long long>(kAttackSeed));
    }
    void injectedGarbage();
    void oversizedDatagrams();
    void replayOfAnEarlierSession();
    void reflection();
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
    std::mt19937_64 m_random{kAttackSeed};
};

void AttackSessionTest::injectedGarbage()
{
    auto owner = pairUnder(SuiteId::Aes256Gcm);
    Pair &pair = *owner;
    const int asked = qEnvironmentVariableIntValue("SKYSEAL_FORGERIES");
    const int count = asked > 0 ? asked : 50000;
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

void AttackSessionTest::oversizedDatagrams()
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

void AttackSessionTest::replayOfAnEarlierSession()
{
    PairOptions options;
    options.seed = kAttackSeed;
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

void AttackSessionTest::reflection()
{
    PairOptions options;
    options.seed = kAttackSeed;
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

void AttackSessionTest::windowPoisoning()
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

void AttackSessionTest::hijackOfAnAddress()
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

void AttackSessionTest::storm()
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

void AttackSessionTest::forgeriesInAFlood()
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

void AttackSessionTest::handshakeFlood()
{
    // First messages without the right mac1: no answer, no state, and a station that calls meanwhile gets its session.
    PairOptions options;
    options.seed = kAttackSeed;
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

void AttackSessionTest::noMoreOutThanIn()
{
    // Nobody authenticated: whatever is repeated at either end, no more comes out than goes in.
    PairOptions options;
    options.seed = kAttackSeed;
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

void AttackSessionTest::replayedAnnouncementsEndNothing()
{
    PairOptions options;
    options.seed = kAttackSeed;
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

void AttackSessionTest::killedTwoHundredTimes()
{
    // Equal plaintexts through 200 lives of either end: no two records are equal, so no pair of key and nonce came twice.
    PairOptions options;
    options.seed = kAttackSeed;
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

void AttackSessionTest::everyControlRecordDropped()
{
    PairOptions options;
    options.seed = kAttackSeed;
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

QTEST_GUILESS_MAIN(AttackSessionTest)
#include "attack_session_test.moc"
