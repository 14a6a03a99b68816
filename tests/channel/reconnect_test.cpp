// Getting a session, keeping it over an outage, and getting it back: in either order of start, with replayed messages, and
// with lost counters.
#include "core/channel/endpoint.h"
#include "core/crypto/x25519.h"
#include "core/channel/handshake.h"
#include "core/crypto/init_crypto.h"
#include "pair.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;

class ReconnectTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void startsInAnyOrder();
    void fiveMinutesOutage();
    void outageBeyondTenMinutes();
    void retriesAreJittered();
    void repeatedAnnouncementsDoNotRenew();
    void repeatedAnnouncementsDoNotEvictTheAgent();
    void repeatedAnnouncementsDoNotDelayRetries();
    void lostCountersRecover();
    void restoredCountersRecover();
    void counterCorrectionIsBoundToItsStation();
    void counterCorrectionThatCannotBeStored();
    void greatestCounterIsNotAccepted();
    void lastCounterIsTheLast();
    void changedCounterCorrectionIsRefused();
    void firstMessagesOfAThiefDoNotBlock_data();
    void firstMessagesOfAThiefDoNotBlock();
    void repeatedOlderFirstMessagesDisplaceNothing();
    void unconfirmedAnswersAreBounded_data();
    void unconfirmedAnswersAreBounded();

private:
    SeededRandom m_random{13};

    /// A forged first message of the pair's station, possible with the agent's key; the thief cannot use the answer.
    Bytes firstOfAThief(Pair &pair, std::uint64_t counter) { return firstOfAThief(pair, counter, *pair.ground().identity); }
    Bytes firstOfAThief(Pair &pair, std::uint64_t counter, const crypto::X25519KeyPair &station)
    {
        const Peer agent{pair.air().publicKey(), "air", {}, {}, {}};
        const auto forged = Initiator::begin(
            station, agent, {ConnectionId{1}, offerOf(Policy{defaultSuites(), true, false}), counter}, m_random);
        return Bytes(forged->message().begin(), forged->message().end());
    }
    static Path elsewhere(const Pair &pair)
    {
        Path path = pair.pathOf(Ground);
        path.remote.ip[15] = 66;
        return path;
    }
};

void ReconnectTest::startsInAnyOrder()
{
    for (const Side first : {Ground, Air}) {
        for (const Duration later : {0ms, 1ms, 100ms, 499ms, 501ms, 3000ms}) {
            for (const bool both : {false, true}) {
                Pair pair;
                if (both)
                    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
                pair.kill(Ground);
                pair.kill(Air);
                pair.run(1s);
                pair.start(first);
                pair.run(later);
                pair.start(first == Ground ? Air : Ground);
                QVERIFY(pair.run(1s, [&] { return pair.bothUp(); }));
                pair.run(5s);
                QVERIFY(pair.bothUp());
                QCOMPARE(pair.ground().all<SessionUp>().size(), both ? 2u : 1u);
            }
        }
    }
}

void ReconnectTest::fiveMinutesOutage()
{
    PairOptions options;
    options.link.delay = 30ms;
    Pair pair(options);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.every(10ms, [&pair] { pair.sendFrame(Air); });
    pair.run(5s);
    bool cut = true;
    std::uint64_t handshakes = 0;
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        handshakes += !cut && (flight.bytes[0] == 0x59 || flight.bytes[0] == 0x5a);
        return !cut;
    };
    pair.run(5min);
    QVERIFY(pair.bothUp());
    cut = false;
    const std::size_t delivered = pair.ground().delivered.size();
    QVERIFY(pair.run(50ms, [&] { return pair.ground().delivered.size() > delivered; })); // The first record after it.
    pair.run(2s);
    pair.stopTraffic();
    pair.run(2s);
    QCOMPARE(QString::fromStdString(pair.accountFrom(Air)), QString());
    QCOMPARE(pair.ground().stats()->rx.lost > 29000, true);
    QCOMPARE(pair.ground().all<SessionUp>().size(), 1u);
    QCOMPARE(pair.air().all<SessionUp>().size(), 1u);
    QVERIFY(handshakes <= 2); // one was already in transit
}

void ReconnectTest::outageBeyondTenMinutes()
{
    Pair pair;
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(2s);
    pair.link.attacker = [](TimePoint, SentDatagram &) { return false; };
    pair.run(11min);
    QVERIFY(!pair.ground().up() && !pair.air().up());
    QCOMPARE(pair.ground().all<SessionDown>().at(0).reason, DownReason::TimedOut);
    pair.link.attacker = {};
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
}

void ReconnectTest::retriesAreJittered()
{
    // Retransmissions of the silent session: 250 ms, 500 ms, 1 s, 2 s, 2 s …, each varied by up to a quarter.
    std::set<Duration> firstPauses;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        PairOptions options;
        options.seed = seed;
        Pair pair(options);
        QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
        pair.run(1s);
        std::vector<TimePoint> sent;
        pair.link.attacker = [&](TimePoint at, SentDatagram &flight) {
            if (flight.bytes[0] == 0x59)
                sent.push_back(at);
            return false;
        };
        pair.run(20s);
        QVERIFY(sent.size() >= 7);
        const std::array<Duration, 6> pauses{250ms, 500ms, 1s, 2s, 2s, 2s};
        for (std::size_t i = 0; i < pauses.size(); ++i) {
            const Duration pause = sent[i + 1] - sent[i];
            QVERIFY2(pause >= pauses[i] * 3 / 4 && pause <= pauses[i] * 5 / 4, qPrintable(QString::number(seconds(pause))));
        }
        firstPauses.insert(sent[1] - sent[0]);
    }
    QVERIFY(firstPauses.size() > 10);
}

void ReconnectTest::repeatedAnnouncementsDoNotRenew()
{
    // The answer takes 1.5 s; meanwhile an attacker replays an old announcement twenty times a second.
    PairOptions options;
    options.link.delay = 750ms;
    Pair pair(options);
    std::optional<SentDatagram> announcement;
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        if (flight.bytes[0] == 0x58)
            announcement = flight;
        return true;
    };
    pair.every(50ms, [&] {
        if (announcement)
            pair.link.inject(pair.now, *announcement);
    });
    QVERIFY(pair.run(4s, [&] { return pair.bothUp(); }));
}

void ReconnectTest::repeatedAnnouncementsDoNotEvictTheAgent()
{
    // The same from many addresses. Each is answered at its source address, and the legitimate agent as well.
    PairOptions options;
    options.link.delay = 40ms;
    Pair pair(options);
    std::optional<Bytes> announcement;
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        if (flight.bytes[0] == 0x58)
            announcement = flight.bytes;
        return true;
    };
    pair.run(10ms);
    pair.kill(Ground);
    std::uint16_t port = 1000;
    pair.every(2ms, [&] {
        if (!pair.ground().endpoint || !announcement)
            return;
        Path path = pair.pathOf(Air);
        path.remote.ip[15] = 77;
        path.remote.port = ++port;
        Bytes copy = *announcement;
        pair.ground().handleDatagram(pair.now, path, copy);
        while (const auto out = pair.ground().pollTransmit()) {
            if (out->to == pair.pathOf(Air))
                pair.link.send(pair.now, {Ground, pair.ground().port, 0, Bytes(out->bytes.begin(), out->bytes.end())});
        }
    });
    pair.run(1s);
    pair.start(Ground);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
}

void ReconnectTest::repeatedAnnouncementsDoNotDelayRetries()
{
    // The agent is silent. An attacker replays its announcement ten times a second from another address; the timed
    // retransmissions still go to the address of the agent.
    Pair pair;
    std::optional<Bytes> announcement;
    std::size_t copies = 0;
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        if (flight.bytes[0] == 0x58)
            announcement = flight.bytes;
        copies += flight.bytes[0] == 0x59;
        return true;
    };
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    pair.kill(Air);
    QVERIFY(announcement);
    std::size_t answers = 0;
    pair.every(100ms, [&] {
        Bytes copy = *announcement;
        pair.ground().handleDatagram(pair.now, elsewhere(pair), copy);
        while (const auto out = pair.ground().pollTransmit()) {
            const bool first = out->bytes[0] == 0x59;
            copies += first && out->to == pair.pathOf(Air);
            answers += first && out->to == elsewhere(pair);
        }
    });
    pair.run(2s); // It is silent by then.
    copies = 0;
    pair.run(20s);
    QVERIFY2(copies >= 8, qPrintable(QString::number(copies))); // as without an attack
    QVERIFY2(answers > 100, qPrintable(QString::number(answers)));
}

void ReconnectTest::lostCountersRecover()
{
    Pair pair;
    for (int i = 0; i < 30; ++i) { // A past.
        pair.kill(Ground);
        pair.start(Ground);
        QVERIFY(pair.run(4s, [&] { return pair.bothUp() && pair.air().all<SessionUp>().size() == std::size_t(i + 1); }));
        pair.run(100ms);
    }
    const auto before = pair.air().counters.lastSeen(pair.ground().publicKey());
    pair.kill(Ground);
    pair.ground().counters.loseOwn();
    pair.start(Ground);
    QVERIFY(pair.run(4s, [&] { return pair.air().all<SessionUp>().size() == 31; }));
    QVERIFY(pair.air().counters.lastSeen(pair.ground().publicKey()) > before);
    // Reported at both ends.
    const auto refused = [](const Pair::End &end, RefusalReason reason) {
        const auto events = end.all<HandshakeRefused>();
        return std::count_if(events.begin(), events.end(), [&](const auto &e) { return e.reason == reason; });
    };
    QCOMPARE(refused(pair.ground(), RefusalReason::CounterBehind), 1);
    QVERIFY(refused(pair.air(), RefusalReason::ReplayedHandshake) >= 1);
    QCOMPARE(pair.ground().all<HandshakeRefused>().back().peer, pair.air().publicKey());
}

void ReconnectTest::restoredCountersRecover()
{
    // On a bad link as well, where the number may be lost.
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        PairOptions options;
        options.seed = seed;
        options.link.loss = 0.3;
        options.link.delay = 60ms;
        Pair pair(options);
        pair.air().counters.remember(pair.ground().publicKey(), 1000000);
        QVERIFY2(pair.run(15s, [&] { return pair.bothUp(); }), qPrintable(QString::number(seed)));
        QVERIFY(pair.ground().counters.next() > 1000001);
    }
}

void ReconnectTest::counterCorrectionIsBoundToItsStation()
{
    // An attacker replays an old first message to an agent without a station: it receives short answers that it cannot read, at
    // a limited rate, and they have no effect at the station, then or later.
    Pair pair;
    std::vector<Bytes> firsts, numbers;
    std::uint64_t in = 0, out = 0;
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        if (flight.bytes[0] == 0x59)
            firsts.push_back(flight.bytes);
        if (flight.bytes[0] == 0x5b) {
            numbers.push_back(flight.bytes);
            out += flight.bytes.size();
            return false;
        }
        return true;
    };
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    QVERIFY(numbers.empty());
    pair.kill(Ground);
    pair.kill(Air);
    pair.start(Air);
    const auto before = pair.air().counters.lastSeen(pair.ground().publicKey());
    for (int i = 0; i < 100; ++i) {
        Bytes copy = firsts[0];
        in += copy.size();
        pair.air().handleDatagram(pair.now, pair.pathOf(Ground), copy);
        pair.run(50ms);
    }
    QVERIFY(!numbers.empty() && numbers.size() <= 26);
    QVERIFY(out <= in);
    QVERIFY(!pair.air().up());
    QCOMPARE(pair.air().counters.lastSeen(pair.ground().publicKey()), before);
    const std::uint64_t own = *pair.ground().counters.next();
    pair.start(Ground);
    for (const Bytes &number : numbers) {
        QCOMPARE(number.size(), kNumberLength);
        QVERIFY(number.size() <= kFirstLength);
        Bytes copy = number;
        pair.ground().handleDatagram(pair.now, pair.pathOf(Air), copy);
    }
    QCOMPARE(pair.ground().unmatched().forged, std::uint64_t(numbers.size()));
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    QVERIFY(pair.ground().counters.next() <= own + 3);
}

void ReconnectTest::counterCorrectionThatCannotBeStored()
{
    // The store fails: no session, and the event is repeated, at most once a second.
    class Stubborn final : public CounterStore
    {
    public:
        std::optional<std::uint64_t> next() override { return ++m_own; }
        std::uint64_t lastSeen(const channel::PublicKey &) override { return 0; }
        bool remember(const channel::PublicKey &, std::uint64_t) override { return true; }

    private:
        std::uint64_t m_own = 0;
    } stubborn;
    Pair pair;
    pair.air().counters.remember(pair.ground().publicKey(), 1000000);
    SeededRandom random(3);
    pair.ground().endpoint = std::make_unique<Endpoint>(pair.configOf(Ground), random, stubborn, pair.now);
    pair.run(10s);
    QVERIFY(!pair.bothUp());
    const auto told = pair.ground().all<HandshakeRefused>().size();
    QVERIFY2(told >= 4 && told <= 11, qPrintable(QString::number(told)));
}

void ReconnectTest::greatestCounterIsNotAccepted()
{
    Pair pair;
    pair.air().counters.remember(pair.ground().publicKey(), kGreatestCounter - 5);
    pair.run(5s);
    QVERIFY(!pair.bothUp());
    QVERIFY(pair.ground().counters.next() < 100);
    QCOMPARE(pair.ground().all<HandshakeRefused>().at(0).reason, RefusalReason::CounterBehind);
}

void ReconnectTest::lastCounterIsTheLast()
{
    // The last counter still makes a session. After it the station sends no first message, and reports why.
    Pair pair;
    QVERIFY(pair.ground().counters.skipTo(kGreatestCounter - 1));
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    QCOMPARE(pair.air().counters.lastSeen(pair.ground().publicKey()), kGreatestCounter);
    pair.kill(Ground);
    pair.start(Ground);
    std::size_t firsts = 0;
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        firsts += flight.bytes[0] == 0x59;
        return true;
    };
    pair.run(10s);
    QVERIFY(!pair.ground().up());
    QCOMPARE(firsts, std::size_t(0));
    const auto refusals = pair.ground().all<HandshakeRefused>();
    QVERIFY(!refusals.empty() && refusals.size() <= 11);
    QCOMPARE(refusals.back().reason, RefusalReason::CountersUsedUp);
    QCOMPARE(refusals.back().peer, pair.air().publicKey());
}

void ReconnectTest::changedCounterCorrectionIsRefused()
{
    SeededRandom random(7);
    const auto station = crypto::X25519KeyPair::generate(random), agent = crypto::X25519KeyPair::generate(random);
    const Peer knownAgent{agent.publicKey, "agent", {}, {}, {}}, knownStation{station.publicKey, "station", {}, {}, {}};
    const SuiteOffer offer = offerOf(Policy{defaultSuites(), false, false});
    auto initiator = Initiator::begin(station, knownAgent, {ConnectionId{0x1234}, offer, 5}, random);
    const auto number = *std::move(*Responder::read(agent, initiator->message())).writeNumber(knownStation, 77, random);
    QCOMPARE(answeredConnection(number), ConnectionId{0x1234});
    for (std::size_t bit = 0; bit < number.size() * 8; ++bit) {
        NumberMessage changed = number;
        changed[bit / 8] = static_cast<std::uint8_t>(changed[bit / 8] ^ 1u << bit % 8);
        QVERIFY(!initiator->readNumber(changed));
        Mac1(station.publicKey).sign(changed);
        if (bit >= 24 && bit < (kNumberLength - kMacLength) * 8)
            QVERIFY(!initiator->readNumber(changed));
        QVERIFY(!initiator->readAnswer(changed));
    }
    QVERIFY(!initiator->readNumber(ByteView(number).first(kNumberLength - 1)));
    QCOMPARE(initiator->readNumber(number), std::optional<std::uint64_t>(77));
    QVERIFY(!initiator->readNumber(number));
}

void ReconnectTest::firstMessagesOfAThiefDoNotBlock_data()
{
    QTest::addColumn<quint64>("counter");
    QTest::addColumn<bool>("rising");
    QTest::newRow("greatest") << quint64(kGreatestCounter) << false;
    QTest::newRow("great") << (quint64(1) << 38) << true;
    QTest::newRow("those that the station is about to use") << quint64(1) << true;
}

void ReconnectTest::firstMessagesOfAThiefDoNotBlock()
{
    QFETCH(quint64, counter);
    QFETCH(bool, rising);
    PairOptions options;
    options.link.delay = 20ms;
    Pair pair(options);
    pair.kill(Ground);
    std::uint64_t next = counter;
    pair.every(50ms, [&] {
        Bytes forged = firstOfAThief(pair, rising ? next++ : next);
        pair.air().handleDatagram(pair.now, elsewhere(pair), forged);
    });
    pair.run(3s);
    pair.start(Ground);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(15s);
    QVERIFY(pair.bothUp());
    QCOMPARE(pair.air().all<SessionUp>().size(), 1u);
    QVERIFY(pair.air().counters.lastSeen(pair.ground().publicKey()) < 10);
}

void ReconnectTest::repeatedOlderFirstMessagesDisplaceNothing()
{
    // An attacker withheld the answers for a minute and recorded first messages that were never confirmed. Later he replays all
    // of them behind each true one.
    Pair pair;
    std::vector<SentDatagram> kept;
    bool jammed = true;
    pair.link.attacker = [&](TimePoint at, SentDatagram &flight) {
        if (flight.bytes[0] != 0x59)
            return !jammed || flight.bytes[0] != 0x5a;
        if (!jammed) {
            for (const SentDatagram &old : kept)
                pair.link.inject(at + 1100us, old);
        } else if (kept.empty() || kept.back().bytes != flight.bytes) {
            kept.push_back(flight);
        }
        return true;
    };
    pair.run(60s);
    QVERIFY2(kept.size() > 5, qPrintable(QString::number(kept.size())));
    QVERIFY(!pair.bothUp());
    jammed = false;
    QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
    QCOMPARE(pair.ground().all<SessionUp>().size(), 1u);
    pair.run(5s);
    QVERIFY(pair.bothUp());
    QCOMPARE(pair.air().all<SessionUp>().size(), 1u);
}

void ReconnectTest::unconfirmedAnswersAreBounded_data()
{
    QTest::addColumn<int>("stations");
    QTest::newRow("in the name of the station") << 0;
    QTest::newRow("in the names of as many others as a list has") << 255;
}

void ReconnectTest::unconfirmedAnswersAreBounded()
{
    // At the rate that the agent computes, for as long as it keeps an answer: there is always room for the legitimate station.
    QFETCH(int, stations);
    Pair pair;
    pair.kill(Ground);
    auto peers = pair.configOf(Air).peers;
    std::vector<crypto::X25519KeyPair> others;
    for (int i = 0; i < stations; ++i) {
        others.push_back(crypto::X25519KeyPair::generate(m_random));
        peers.push_back({others.back().publicKey, "other", PeerRole::Pilot, {}, {}});
    }
    pair.air().setPeers(pair.now, peers);
    for (std::size_t i = 0; i < 390; ++i) {
        Bytes forged = others.empty() ? firstOfAThief(pair, kGreatestCounter)
                                      : firstOfAThief(pair, kGreatestCounter, others[i % others.size()]);
        pair.air().handleDatagram(pair.now, elsewhere(pair), forged);
        pair.run(25ms);
    }
    QCOMPARE(pair.air().unmatched().replayed, std::uint64_t(0)); // each was answered
    pair.start(Ground);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
}

SKYSEAL_TEST(ReconnectTest)
#include "reconnect_test.moc"
