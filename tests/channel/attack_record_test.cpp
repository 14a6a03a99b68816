// Attacks on single records, under every suite: what an attacker can read, change, cut, make up, repeat and carry elsewhere.
// After each one the session is up, the stream goes on, and the counter has moved by exactly what was done.
#include "attack.h"
#include "core/base/hex.h"
#include "core/crypto/init_crypto.h"

using namespace skyseal;
using namespace skyseal::test;

class AttackRecordTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(crypto::initCrypto());
        qInfo("seed %llu", static_cast<unsigned long long>(kAttackSeed));
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
    void replayOfEverything_data() { everySuite(); }
    void replayOfEverything();
    void acrossSuitesAndEpochs();
    void acrossSessions();

private:
    std::mt19937_64 m_random{kAttackSeed};
};

void AttackRecordTest::eavesdropping()
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

void AttackRecordTest::keystreamReuse()
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

void AttackRecordTest::everyBitFlipped()
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

void AttackRecordTest::everyLength()
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

void AttackRecordTest::fabricatedRecords()
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

void AttackRecordTest::replayOfEverything()
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

void AttackRecordTest::acrossSuitesAndEpochs()
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

void AttackRecordTest::acrossSessions()
{
    auto one = pairUnder(SuiteId::Aes256Ctr);
    PairOptions options;
    options.seed = kAttackSeed + 1;
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

QTEST_GUILESS_MAIN(AttackRecordTest)
#include "attack_record_test.moc"
