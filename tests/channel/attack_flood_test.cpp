// Attacks by quantity: garbage, forgeries, first messages, oversized datagrams. An end never sends more bytes than it
// received.
#include "attack.h"
#include "core/channel/handshake_messages.h"
#include "core/channel/mac1.h"
#include "core/crypto/init_crypto.h"
#include "tests/support/holds.h"
#include "tests/support/test_runner.h"

#include <array>

using namespace skyseal;
using namespace skyseal::test;

class AttackFloodTest : public QObject
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
    void forgeriesInAFlood();
    void handshakeFlood();
    void handshakeFloodWithTheRightMac();
    void answerFloodWithTheRightMac_data();
    void answerFloodWithTheRightMac();
    void numberFloodWithTheRightMac();
    void floodRaisesFewEvents();
    void noMoreOutThanIn();
    void noMoreOutThanInDuringASession_data();
    void noMoreOutThanInDuringASession();

private:
    void floodAnswers(Pair &pair, std::size_t length, double &took);
    void fill(Bytes &bytes)
    {
        for (auto &byte : bytes)
            byte = static_cast<std::uint8_t>(m_random());
    }
    std::mt19937_64 m_random{kAttackSeed};
};

void AttackFloodTest::injectedGarbage()
{
    auto owner = pairUnder(SuiteId::Aes256Gcm);
    Pair &pair = *owner;
    const Caught toGround = catchOne(pair), toAir = catchOne(pair, 28, Ground);
    const int asked = qEnvironmentVariableIntValue("SKYSEAL_FORGERIES");
    const int count = asked > 0 ? asked : 50000;
    const auto before = refusedInAll(pair.ground()) + refusedInAll(pair.air());
    Bytes datagram;
    for (int i = 0; i < count; ++i) {
        datagram.resize(m_random() % 1501);
        fill(datagram);
        if (!datagram.empty())
            datagram[0] = static_cast<std::uint8_t>(i);
        // Every fourth is addressed to the session, so that only its tag is wrong.
        const Bytes &head = (i & 1 ? toGround : toAir).flight.bytes;
        if (i & 2 && datagram.size() >= 3)
            std::copy_n(head.begin(), 3, datagram.begin());
        HOLDS(!offer(pair, i & 1 ? Ground : Air, datagram), "no garbage is accepted");
    }
    QCOMPARE(refusedInAll(pair.ground()) + refusedInAll(pair.air()) - before, static_cast<std::uint64_t>(count));
    pair.link.inject(pair.now, toGround.flight);
    pair.link.inject(pair.now, toAir.flight);
    QVERIFY(aliveAndExact(pair));
}

void AttackFloodTest::oversizedDatagrams()
{
    auto owner = pairUnder(SuiteId::Aes256Ctr);
    Pair &pair = *owner;
    const Caught caught = catchOne(pair);
    for (const std::size_t size : {1201u, 9000u, 65507u}) {
        for (int first = 0x40; first < 0x80; ++first) {
            Bytes datagram = caught.flight.bytes;
            datagram.resize(size);
            datagram[0] = static_cast<std::uint8_t>(first);
            HOLDS(!offer(pair, Ground, datagram), "no oversized datagram is accepted");
            QVERIFY(!offer(pair, Air, datagram));
        }
    }
    pair.link.inject(pair.now, caught.flight);
    QVERIFY(aliveAndExact(pair));
}

void AttackFloodTest::forgeriesInAFlood()
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
            bytes.back() ^= 1;
            offer(pair, Ground, bytes);
        }
    });
    pair.every(20ms, [&] { pair.sendFrame(Air); });
    pair.run(3s);
    pair.stopTraffic();
    HOLDS(received(pair.ground()).forged - before == forged, "each forgery is counted");
    QVERIFY(pair.ground().all<ForgeryAlarm>().size() <= 5);
    QVERIFY(aliveAndExact(pair));
}

void AttackFloodTest::handshakeFlood()
{
    // First messages without a valid mac1: no answer, no state, and the station gets its session meanwhile.
    Pair pair(attackOptions());
    pair.kill(Ground);
    std::uint64_t answered = 0;
    Bytes flood(127);
    pair.every(1ms, [&] {
        for (int i = 0; i < 20; ++i) {
            fill(flood);
            flood[0] = 0x59;
            offer(pair, Air, flood);
        }
    });
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        answered += flight.bytes[0] == 0x5a;
        return true;
    };
    pair.run(2s);
    QCOMPARE(answered, std::uint64_t(0));
    pair.start(Ground);
    HOLDS(pair.run(3s, [&] { return pair.bothUp(); }), "a station that calls gets its session");
}

void AttackFloodTest::handshakeFloodWithTheRightMac()
{
    // A sender that knows the agent's public key can compute mac1; the agent computes few handshakes for it.
    Pair pair(attackOptions());
    pair.kill(Ground);
    pair.run(1s);
    const Mac1 mac(pair.air().publicKey());
    Bytes flood(127);
    const auto before = pair.air().unmatched().forged;
    pair.every(1ms, [&] {
        for (int i = 0; i < 20; ++i) {
            fill(flood);
            flood[0] = 0x59;
            mac.sign(flood);
            offer(pair, Air, flood);
        }
    });
    pair.run(2s);
    // Each computed handshake was refused and counted; the others were not read.
    const auto computed = pair.air().unmatched().forged - before;
    HOLDS(computed <= 20 + 2 * 50, "at most fifty computations a second");
    QVERIFY(!pair.air().up());
}

/// An eavesdropper learns the station's handshake number from an answer, and with the station's key computes mac1. The true
/// answers are withheld for a while; then the session comes up. Returns the seconds that this took.
void AttackFloodTest::floodAnswers(Pair &pair, std::size_t length, double &took)
{
    const std::size_t sessions = pair.ground().all<SessionUp>().size();
    Bytes heard;
    TimePoint knownFrom = kNever;
    bool jammed = true;
    pair.link.attacker = [&](TimePoint at, SentDatagram &flight) {
        if (flight.bytes[0] != 0x5a)
            return true;
        heard = flight.bytes;
        knownFrom = at + 2ms; // its distance to the agent is that of the station
        return !jammed;
    };
    const Mac1 mac(pair.ground().publicKey());
    pair.every(1ms, [&, length] {
        if (heard.empty())
            return;
        Bytes forged(length);
        for (int i = 0; i < 20; ++i) {
            fill(forged);
            forged[0] = length == kNumberLength ? 0x5b : 0x5a;
            forged[1] = pair.now >= knownFrom ? heard[1] : 0;
            if (pair.now >= knownFrom && i % 2 == 0)
                forged[2] = heard[2]; // the other bytes are arbitrary
            mac.sign(forged);
            offer(pair, Ground, forged);
        }
    });
    const TimePoint begun = pair.now;
    pair.run(2s);
    QVERIFY(!heard.empty());
    QCOMPARE(pair.ground().all<SessionUp>().size(), sessions);
    jammed = false;
    const bool up = pair.run(3s, [&] { return pair.ground().all<SessionUp>().size() > sessions && pair.bothUp(); });
    pair.stopTasks();
    pair.link.attacker = nullptr;
    QVERIFY(up);
    took = seconds(pair.now - begun);
}

void AttackFloodTest::answerFloodWithTheRightMac_data()
{
    QTest::addColumn<bool>("hadASession");
    QTest::newRow("first session") << false;
    QTest::newRow("restarted agent") << true;
}

void AttackFloodTest::answerFloodWithTheRightMac()
{
    QFETCH(bool, hadASession);
    Pair pair(attackOptions());
    if (hadASession) {
        QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
        pair.kill(Air);
        pair.run(3s);
        pair.start(Air);
    }
    const auto before = pair.ground().unmatched().forged;
    double took = 0;
    floodAnswers(pair, kAnswerLength, took);
    QVERIFY(took > 0);
    // Each computed answer was counted as forged.
    const auto computed = pair.ground().unmatched().forged - before;
    HOLDS(static_cast<double>(computed) <= 20 + 50 * took, "at most fifty computations a second");
    QVERIFY(computed > 0);
}

void AttackFloodTest::numberFloodWithTheRightMac()
{
    // The same with the message that corrects the counter of a station. After a few forged ones no correction for this first
    // message is computed, not even the true one: a new first message replaces it.
    Pair pair(attackOptions());
    for (std::size_t life = 1; life <= 5; ++life) { // a past
        QVERIFY(pair.run(4s, [&] { return pair.bothUp() && pair.air().all<SessionUp>().size() == life; }));
        pair.kill(Ground);
        pair.start(Ground);
    }
    pair.kill(Ground);
    pair.ground().counters.loseOwn();
    Bytes number;
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        if (flight.bytes[0] != 0x5b)
            return true;
        number = flight.bytes;
        return false;
    };
    pair.start(Ground);
    QVERIFY(pair.run(4s, [&] { return !number.empty(); }));
    const Mac1 mac(pair.ground().publicKey());
    for (int i = 0; i < 20; ++i) {
        Bytes forged(number.size());
        fill(forged);
        std::copy_n(number.begin(), 3, forged.begin());
        mac.sign(forged);
        offer(pair, Ground, forged);
    }
    offer(pair, Ground, number);
    pair.pump();
    const auto told = pair.ground().all<HandshakeRefused>();
    HOLDS(std::ranges::none_of(told, [](const auto &e) { return e.reason == RefusalReason::CounterBehind; }),
          "a few false numbers are computed on");
    pair.link.attacker = nullptr;
    double took = 0;
    floodAnswers(pair, kNumberLength, took);
    QVERIFY(took > 0);
}

void AttackFloodTest::floodRaisesFewEvents()
{
    Pair pair(attackOptions());
    pair.kill(Ground);
    pair.air().events.clear();
    Path source = pair.pathOf(Ground);
    Bytes flood(127);
    pair.every(1ms, [&] {
        fill(flood);
        flood[0] = 0x59;
        source.remote.port = static_cast<std::uint16_t>(m_random());
        offer(pair, Air, flood, source);
    });
    pair.run(5s);
    HOLDS(pair.air().events.size() <= 6, "a flood from everywhere causes few notices");
}

void AttackFloodTest::noMoreOutThanIn()
{
    // No sender is authenticated: whatever is replayed to either end, it sends no more bytes than it receives.
    Pair pair(attackOptions());
    Tap tap(pair);
    pair.run(2s);
    QVERIFY(pair.bothUp());
    for (const Side victim : {Ground, Air}) {
        Pair fresh(attackOptions()); // the same keys, so that the recorded messages are addressed to these ends
        fresh.kill(victim == Ground ? Air : Ground);
        fresh.run(10ms);
        std::uint64_t in = 0, out = 0;
        fresh.link.attacker = [&](TimePoint, SentDatagram &flight) {
            out += flight.bytes[0] != 0x58 ? flight.bytes.size() : 0; // announcements are not answers
            return false;
        };
        for (int round = 0; round < 100; ++round) {
            for (const SentDatagram &flight : tap.flights) {
                if (flight.from == victim || (flight.bytes[0] & 0xfc) != 0x58)
                    continue; // shaped like an answer to a handshake
                offer(fresh, victim, flight.bytes);
                in += flight.bytes.size();
                fresh.run(20ms);
            }
        }
        HOLDS(out <= in, "no more goes out than came in");
    }
}

void AttackFloodTest::noMoreOutThanInDuringASession_data()
{
    QTest::addColumn<int>("messages");
    QTest::addColumn<int>("times");
    QTest::addColumn<int>("aSecond");
    QTest::addColumn<bool>("deaf");
    QTest::newRow("five in turn, ten a second") << 5 << 200 << 10 << false;
    QTest::newRow("five in turn, one a second") << 5 << 20 << 1 << false;
    QTest::newRow("one again and again") << 1 << 200 << 10 << false;
    // The agent receives replayed messages only.
    QTest::newRow("deaf, five in turn, ten a second") << 5 << 200 << 10 << true;
    QTest::newRow("deaf, five in turn, one a second") << 5 << 20 << 1 << true;
}

void AttackFloodTest::noMoreOutThanInDuringASession()
{
    // An attacker who jammed a link for a while holds first messages that were never confirmed, whose counters stay valid while
    // the session continues. An agent keeps four answers of one peer: of five messages replayed in turn, all but the newest are
    // new to it each time. The same flight without the attack is the reference.
    QFETCH(int, messages);
    QFETCH(int, times);
    QFETCH(int, aSecond);
    QFETCH(bool, deaf);
    std::uint64_t in = 0, toTheThief = 0;
    std::array<std::uint64_t, 2> said{};
    for (const bool attacked : {false, true}) {
        Pair pair(attackOptions());
        QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
        pair.run(1s);
        std::vector<Bytes> firsts;
        bool jammed = true;
        pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
            if (flight.bytes[0] == 0x59 && (firsts.empty() || firsts.back() != flight.bytes))
                firsts.push_back(flight.bytes);
            return !jammed && (flight.bytes[0] & 0xfc) != 0x58;
        };
        pair.run(45s); // the station makes a new one after four transmissions
        QVERIFY2(firsts.size() >= 5, qPrintable(QString::number(firsts.size())));
        jammed = false;
        pair.run(5s);
        pair.link.attacker = nullptr;
        QVERIFY(pair.bothUp() && pair.air().all<SessionUp>().size() == 1);
        if (deaf) {
            pair.link.attacker = [](TimePoint, SentDatagram &flight) { return flight.from != Ground; };
            pair.run(4s);
        }

        Path thief = pair.pathOf(Ground);
        thief.remote.ip[15] = 66;
        const std::uint64_t before = pair.ground().bytesOut + pair.air().bytesOut;
        std::uint64_t atOnce = 0;
        for (int i = 0; i < times; ++i) {
            if (attacked) {
                const Bytes &first = firsts[static_cast<std::size_t>(i % messages)];
                in += first.size();
                offer(pair, Air, first, thief);
            }
            while (const auto out = pair.air().pollTransmit()) {
                atOnce += out->bytes.size();
                if (out->to == thief)
                    toTheThief += out->bytes.size();
                else
                    pair.link.send(pair.now, {Air, pair.air().port, 0, Bytes(out->bytes.begin(), out->bytes.end())});
            }
            pair.run(std::chrono::milliseconds(1000 / aSecond));
        }
        pair.link.attacker = nullptr;
        said[attacked] = pair.ground().bytesOut + pair.air().bytesOut - before + atOnce;
        QVERIFY(aliveAndExact(pair));
    }
    const std::uint64_t caused = said[1] - said[0];
    qInfo("in %llu, to the thief %llu, caused in all %llu", static_cast<unsigned long long>(in),
          static_cast<unsigned long long>(toTheThief), static_cast<unsigned long long>(caused));
    QVERIFY(caused > 0); // each may be of the legitimate station and is answered
    HOLDS(toTheThief <= in && caused <= in, "no more goes out than came in");
}

SKYSEAL_TEST(AttackFloodTest)
#include "attack_flood_test.moc"
