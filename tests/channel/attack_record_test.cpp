// Attacks on single records, under every suite: reading, changing, truncating, inventing, replaying and moving them. After
// each attack the session is up, the stream continues, and the counters have changed by exactly the number of attempts.
#include "every_suite.h"
#include "core/base/hex.h"
#include "core/crypto/init_crypto.h"
#include "tests/support/holds.h"
#include "tests/support/test_runner.h"

#include <unordered_set>

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
    void splicedRecords_data() { everySuite(); }
    void splicedRecords();
    void fabricatedRecords_data() { everySuite(); }
    void fabricatedRecords();
    void replayOfEverything_data() { everySuite(); }
    void replayOfEverything();
    void replayAtTheEdgeOfTheWindow();
    void acrossSuitesAndEpochs();
    void replayFourEpochsLater();
    void acrossSessions();

private:
    std::mt19937_64 m_random{kAttackSeed};
};

void AttackRecordTest::eavesdropping()
{
    PAIR_UNDER_SUITE;
    // Frames of zeros except for their number: on the wire every byte behind the header looks random.
    std::array<std::uint64_t, 256> histogram{};
    std::uint64_t total = 0;
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
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
    HOLDS(chi < 350, "the wire looks uniform"); // 255 degrees of freedom: 1 in 50,000 runs of a uniform source
    QVERIFY(aliveAndExact(pair));
}

void AttackRecordTest::keystreamReuse()
{
    PAIR_UNDER_SUITE;
    // Equal plaintexts, so two records under one keystream would begin alike.
    std::unordered_set<std::string> bodies;
    std::unordered_set<std::uint32_t> counters;
    std::uint64_t records = 0;
    const Bytes frame(28, 0xfd);
    Bytes record(28 + kMaxRecordOverhead);
    for (; records < 100000; ++records) {
        QVERIFY(pair.air().seal(pair.now, frame, record));
        counters.insert(counterOf(record));
        bodies.emplace(reinterpret_cast<const char *>(record.data()) + 6, 12);
    }
    HOLDS(counters.size() == records, "no counter comes twice");
    HOLDS(bodies.size() == records, "no keystream comes twice");
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
            HOLDS(!offer(pair, Ground, changed), "no changed bit is accepted");
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
    const auto before = refusedInAll(pair.ground()), good = received(pair.ground()).good;
    const std::size_t full = caught.flight.bytes.size();
    for (std::size_t length = 0; length <= full + 32; ++length) {
        Bytes changed = caught.flight.bytes;
        changed.resize(length, 0xa5);
        if (length != full)
            offer(pair, Ground, changed);
    }
    HOLDS(received(pair.ground()).good == good, "no other length is accepted");
    QCOMPARE(refusedInAll(pair.ground()) - before, std::uint64_t(full + 32));
    pair.link.inject(pair.now, caught.flight);
    QVERIFY(aliveAndExact(pair));
}

void AttackRecordTest::splicedRecords()
{
    PAIR_UNDER_SUITE;
    // A record is one datagram and is never reassembled; an attacker can only truncate and join.
    const Caught one = catchOne(pair, 64), two = catchOne(pair, 64);
    const auto good = received(pair.ground()).good;
    const Bytes &a = one.flight.bytes, &b = two.flight.bytes;
    for (std::size_t cut = 1; cut < a.size(); ++cut) {
        const auto at = static_cast<std::ptrdiff_t>(cut);
        Bytes spliced(a.begin(), a.begin() + at);
        spliced.insert(spliced.end(), b.begin() + at, b.end());
        Bytes tail(a.begin() + at, a.end());
        Bytes overlapping(a.begin(), a.begin() + at);
        overlapping.insert(overlapping.end(), a.begin() + at / 2, a.end());
        for (const Bytes &made : {spliced, tail, overlapping}) {
            if (made != a && made != b)
                offer(pair, Ground, made);
        }
    }
    Bytes joined = a;
    joined.insert(joined.end(), b.begin(), b.end());
    offer(pair, Ground, joined);
    HOLDS(received(pair.ground()).good == good, "no piece is accepted");
    pair.link.inject(pair.now, one.flight);
    pair.link.inject(pair.now, two.flight);
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
        setCounter(forged, 1000 + static_cast<std::uint32_t>(m_random() % 0xfff000));
        for (std::size_t k = i % 2 ? 6 : forged.size() - 16; k < forged.size(); ++k)
            forged[k] = static_cast<std::uint8_t>(m_random());
        HOLDS(!offer(pair, Ground, forged), "nothing made up is accepted");
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
    Tap tap(pair);
    for (int i = 0; i < 300; ++i) {
        pair.sendFrame(Air);
        pair.sendFrame(Ground);
        pair.run(10ms);
    }
    pair.run(50ms);
    pair.link.attacker = nullptr;
    const auto replayed = [&] { return received(pair.ground()).replayed + received(pair.air()).replayed; };
    for (int round = 0; round < 3; ++round) {
        const std::uint64_t before = replayed();
        HOLDS(offerAll(pair, tap.flights) == 0, "nothing is accepted twice");
        QCOMPARE(replayed() - before, std::uint64_t(tap.flights.size()));
        // At once, a second later, and when more than the window's entries have come since.
        for (int i = 0; round == 1 && i < 2100; ++i) {
            pair.sendFrame(Air);
            pair.sendFrame(Ground);
        }
        pair.run(1s);
    }
    QVERIFY(aliveAndExact(pair));
}

void AttackRecordTest::replayAtTheEdgeOfTheWindow()
{
    auto owner = pairUnder(SuiteId::ChaCha20Poly1305);
    Pair &pair = *owner;
    // One delivered and one lost record, both replayed just inside, at the edge of and outside the window.
    pair.sendFrame(Air);
    const Caught withheld = catchOne(pair);
    Tap tap(pair);
    pair.sendFrame(Air);
    const Bytes arrived = tap.flights.at(0).bytes;
    pair.run(10ms);
    for (const std::uint32_t newer : {2047u, 2048u, 2049u}) {
        while (counterOf(tap.flights.back().bytes) < counterOf(arrived) + newer || tap.flights.back().from != Air) {
            pair.sendFrame(Air);
            pair.run(2ms);
        }
        QCOMPARE(counterOf(tap.flights.back().bytes), counterOf(arrived) + newer);
        HOLDS(!offer(pair, Ground, arrived), "nothing is accepted twice");
        HOLDS(!offer(pair, Ground, withheld.flight.bytes), "nothing older than the window is accepted");
    }
    pair.dropped[Air].insert(withheld.number);
    pair.link.attacker = nullptr;
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
        pair.ground().switchSuite(pair.now, info.id);
        pair.run(1s);
        // The old record under the new epoch's bits, with counters that the new epoch has not seen.
        for (std::uint8_t bits = 0; bits < 4; ++bits) {
            Bytes changed = before.flight.bytes;
            changed[0] = static_cast<std::uint8_t>((changed[0] & ~3) | bits);
            if (changed != before.flight.bytes)
                HOLDS(!offer(pair, Ground, changed), "no record opens under another suite");
        }
        // Unchanged, it is a late record of the previous epoch.
        pair.link.inject(pair.now, before.flight);
        QVERIFY(aliveAndExact(pair));
        QCOMPARE(pair.ground().delivered[before.number], 1);
    }
}

void AttackRecordTest::replayFourEpochsLater()
{
    auto owner = pairUnder(SuiteId::Aes256Gcm);
    Pair &pair = *owner;
    for (int i = 0; i < 50; ++i)
        pair.sendFrame(Air);
    const Caught old = catchOne(pair);
    pair.dropped[Air].insert(old.number);
    for (int i = 0; i < 4; ++i) {
        pair.ground().rekey(pair.now);
        pair.run(5s);
    }
    // Records carry only two bits of the epoch, so the old record's header fits again, and its counter is new.
    QCOMPARE(static_cast<int>(pair.ground().sessionInfo()->epoch), 5);
    HOLDS(!offer(pair, Ground, old.flight.bytes), "no record opens in a later epoch");
    QVERIFY(aliveAndExact(pair));
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
    std::copy_n(own.flight.bytes.begin(), 3, changed.begin());
    changed[4] = 0x10; // a counter that it has not received
    const auto before = received(one->ground()).forged;
    HOLDS(!offer(*one, Ground, changed), "no record opens in another session");
    QCOMPARE(received(one->ground()).forged, before + 1);
    one->link.inject(one->now, own.flight);
    QVERIFY(aliveAndExact(*one));
}

SKYSEAL_TEST(AttackRecordTest)
#include "attack_record_test.moc"
