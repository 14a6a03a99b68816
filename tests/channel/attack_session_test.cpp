// Attacks on whole sessions: reflection, replay of everything, hijacked addresses, interrupted and jammed links, killed
// processes, jumping clocks, and a wire that drops every control record.
#include "attack.h"
#include "core/crypto/init_crypto.h"
#include "tests/support/holds.h"
#include "tests/support/test_runner.h"

#include <unordered_set>

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
    void replayOfAnEarlierSession();
    void replayOnAnotherLink();
    void reflection();
    void windowPoisoning();
    void hijackOfAnAddress();
    void newPortResumesAtOnce();
    void withheldRecordDivertsForSeconds();
    void repeatedFirstMessageDivertsNothing();
    void answersToOtherAddressesEndNoTrial();
    void jitterReorderingAndDuplicates();
    void deletion_data();
    void deletion();
    void outageOfFiveMinutes();
    void jammedThenLossyLink();
    void clockSteps();
    void replayedAnnouncementsEndNothing();
    void withheldReportOfADeafAgent();
    void echoesOfAnHourAgoEndNoTrial();
    void killedTwoHundredTimes();
    void everyControlRecordDropped();
    void clonedEnd_data();
    void clonedEnd();
    void restoredEnd_data() { clonedEnd_data(); }
    void restoredEnd();

private:
    std::mt19937_64 m_random{kAttackSeed};
};

namespace {

void traffic(Pair &pair, Duration period = 20ms)
{
    pair.every(period, [&pair] {
        pair.sendFrame(Air);
        pair.sendFrame(Ground);
    });
}

/// A session of `victim`, which sends its records home, until an attacker has it send them to his own address.
struct Hijack
{
    explicit Hijack(Side end) : victim(end) { thief.remote.port = 6666; }

    Path where() const { return pair.ends[victim].recordPath(); }
    bool isHome() const { return where() == home; }
    bool isDiverted() const { return where() == thief; }
    bool offerFromThief(const Bytes &datagram) { return offer(pair, victim, datagram, thief); }

    const Side victim;
    const std::unique_ptr<Pair> owner = pairUnder(SuiteId::ChaCha20Poly1305);
    Pair &pair = *owner;
    const Path home = where();
    Path thief = home;
};

void swallowEverything(Pair &pair)
{
    pair.link.attacker = [](TimePoint, SentDatagram &) { return false; };
}

} // namespace

void AttackSessionTest::replayOfAnEarlierSession()
{
    Pair pair(attackOptions());
    Tap tap(pair);
    traffic(pair);
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
    for (const SentDatagram &flight : tap.flights) {
        QVERIFY(!offer(pair, flight.from == Air ? Ground : Air, flight.bytes));
        pair.run(1ms);
    }
    HOLDS(pair.ground().all<SessionUp>().size() == 2 && pair.air().all<SessionUp>().size() == 2,
          "no old handshake makes a session");
    QCOMPARE(pair.ground().delivered.size(), ground);
    QCOMPARE(pair.air().delivered.size(), air);
    QCOMPARE(pair.ground().sessions().size(), 1u);
    QCOMPARE(pair.ground().all<SessionDown>().size(), 0u); // The endpoints that had the first session are gone.
}

void AttackSessionTest::replayOnAnotherLink()
{
    // All messages of one link, including the handshake, are replayed on another link with the same carrier.
    Pair pair(attackOptions());
    Tap tap(pair);
    traffic(pair);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(5s);
    pair.stopTraffic();
    pair.run(1s);
    pair.link.attacker = nullptr;
    const auto onAnother = [&pair](Side from) {
        Path path = pair.pathOf(from);
        path.link = LinkId{2};
        return path;
    };
    const auto linkOfRecords = [&pair] { return pair.ground().recordPath().link; };
    QVERIFY(!tap.ofKind(0x59).empty() && !tap.ofKind(0x5a).empty());
    QVERIFY(tap.flights.size() > 500);
    std::size_t taken = 0;
    for (const SentDatagram &flight : tap.flights) {
        taken += offer(pair, flight.from == Air ? Ground : Air, flight.bytes, onAnother(flight.from));
        pair.run(1ms);
    }
    HOLDS(taken == 0, "nothing is delivered twice");
    pair.run(2s);
    HOLDS(pair.ground().all<SessionUp>().size() == 1 && pair.air().all<SessionUp>().size() == 1,
          "no old handshake makes a session");
    QVERIFY(received(pair.ground()).replayed > 200 && received(pair.air()).replayed > 200);
    QCOMPARE(pair.air().unmatched().replayed, static_cast<std::uint64_t>(tap.ofKind(0x59).size()));
    QCOMPARE(linkOfRecords(), LinkId{1});
    // A record is bound to its carrier, not to its link. A record that never arrived is accepted once from another link, and
    // the session follows it: so a second modem can take over.
    const Caught kept = catchOne(pair);
    QVERIFY(offer(pair, Ground, kept.flight.bytes, onAnother(Air)));
    ++pair.ground().delivered[kept.number];
    QCOMPARE(linkOfRecords(), LinkId{2});
    for (const Path &path : {onAnother(Air), pair.pathOf(Air)})
        HOLDS(!offer(pair, Ground, kept.flight.bytes, path), "nothing is delivered twice");
    QVERIFY(aliveAndExact(pair));
    QCOMPARE(linkOfRecords(), LinkId{1});
}

void AttackSessionTest::reflection()
{
    // Each datagram, including the handshake, is also reflected to its sender. The connection ids of both ends are made equal,
    // as in one of 256 sessions, so that a reflected record has a valid address.
    PairOptions options = attackOptions();
    std::unique_ptr<Pair> owner;
    std::unique_ptr<Tap> tap;
    const auto idFrom = [&](Side side) -> int {
        for (const SentDatagram &flight : tap->flights) {
            if (flight.from == side && (flight.bytes[0] & 0xfc) == 0x50)
                return flight.bytes[1] | flight.bytes[2] << 8;
        }
        return side == Ground ? -1 : -2;
    };
    do {
        ++options.seed;
        owner = std::make_unique<Pair>(options);
        tap = std::make_unique<Tap>(*owner);
        owner->run(2s, [&] { return idFrom(Ground) >= 0 && idFrom(Air) >= 0; });
    } while (idFrom(Ground) != idFrom(Air));
    Pair &pair = *owner;
    pair.every(10ms, [&] { pair.sendFrame(Air); });
    pair.every(50ms, [&] { pair.sendFrame(Ground); }); // fewer, so that the agent has not received its own counters
    for (int i = 0; i < 100; ++i) {
        pair.run(30ms);
        for (const SentDatagram &flight : std::exchange(tap->flights, {}))
            HOLDS(!offer(pair, flight.from, flight.bytes), "nothing is accepted by its own sender");
    }
    pair.link.attacker = nullptr;
    pair.stopTraffic();
    pair.run(1s);
    QVERIFY(refusedInAll(pair.ground()) > 50 && refusedInAll(pair.air()) > 100);
    QVERIFY(aliveAndExact(pair));
}

void AttackSessionTest::windowPoisoning()
{
    auto owner = pairUnder(SuiteId::ChaCha20);
    Pair &pair = *owner;
    const Caught caught = catchOne(pair);
    for (std::uint32_t ahead = 1; ahead < 1u << 24; ahead = ahead * 2 + 1) {
        Bytes changed = caught.flight.bytes;
        setCounter(changed, ahead | 0x800000);
        QVERIFY(!offer(pair, Ground, changed));
    }
    pair.link.inject(pair.now, caught.flight);
    HOLDS(aliveAndExact(pair), "the stream goes on");
    QCOMPARE(received(pair.ground()).lost, std::uint64_t(0));
}

void AttackSessionTest::hijackOfAnAddress()
{
    Hijack hijack(Ground);
    Pair &pair = hijack.pair;
    Tap tap(pair);
    for (int i = 0; i < 50; ++i) {
        pair.sendFrame(Air);
        pair.run(5ms);
    }
    const Caught late = catchOne(pair);
    pair.sendFrame(Air);
    pair.run(10ms);
    for (const SentDatagram &flight : tap.flights) {
        if (flight.from != Air)
            continue;
        hijack.offerFromThief(flight.bytes);
        Bytes damaged = flight.bytes;
        damaged.back() ^= 1;
        damaged[4] ^= 0x10;
        hijack.offerFromThief(damaged);
    }
    HOLDS(hijack.isHome(), "no refused record moves the session");
    // A genuine record that was delayed and is not the newest does not move it either.
    QVERIFY(hijack.offerFromThief(late.flight.bytes));
    ++pair.ground().delivered[late.number];
    HOLDS(hijack.isHome(), "no late record moves the session");
    QCOMPARE(pair.ground().all<PeerMoved>().size(), 0u);
    QVERIFY(aliveAndExact(pair));
}

void AttackSessionTest::newPortResumesAtOnce()
{
    auto owner = pairUnder(SuiteId::ChaCha20Poly1305);
    Pair &pair = *owner;
    traffic(pair);
    pair.run(1s);
    // As after a new NAT mapping. An attacker who follows the session to its new port gains nothing either.
    const Caught sample = catchOne(pair);
    pair.link.inject(pair.now, sample.flight);
    Path thief = pair.pathOf(Air);
    pair.air().port = 40001;
    thief.remote.port = 40002;
    pair.every(1ms, [&] {
        Bytes forged = sample.flight.bytes;
        setCounter(forged, 1u << 20);
        forged.back() ^= 1;
        offer(pair, Ground, forged, thief);
    });
    const auto moved = [&] { return pair.ground().recordPath().remote.port == 40001; };
    HOLDS(pair.run(1s, moved), "the session follows its peer");
    pair.run(2s);
    HOLDS(moved(), "the session stays with its peer");
    pair.stopTraffic();
    pair.run(1s);
    QCOMPARE(pair.air().all<SessionUp>().size(), 1u);
    QVERIFY(aliveAndExact(pair));
}

void AttackSessionTest::withheldRecordDivertsForSeconds()
{
    // An attacker withholds the newest record from the agent, blocks the station, and delivers that record from his own
    // address: he receives the telemetry for two and a half seconds, not until the session times out.
    Hijack hijack(Air);
    Pair &pair = hijack.pair;
    const Caught kept = catchOne(pair, 28, Ground);
    pair.link.attacker = [](TimePoint, SentDatagram &flight) { return flight.from == Air; };
    pair.every(20ms, [&pair] { pair.sendFrame(Air); });
    pair.run(300ms);
    QVERIFY(hijack.offerFromThief(kept.flight.bytes));
    ++pair.air().delivered[kept.number];
    QVERIFY(hijack.isDiverted());
    pair.run(2s);
    QVERIFY(hijack.isDiverted()); // as long as an honest peer may be out of reach after it moved
    pair.run(1s);
    HOLDS(hijack.isHome(), "the session goes back to its peer");
    const auto moved = pair.air().all<PeerMoved>();
    QCOMPARE(moved.size(), std::size_t(2)); // there and back, each reported
    QVERIFY(moved[0].to == hijack.thief && moved[1].to == hijack.home);
    pair.link.attacker = nullptr;
    pair.stopTraffic();
    QVERIFY(aliveAndExact(pair));
}

void AttackSessionTest::repeatedFirstMessageDivertsNothing()
{
    // A first message reaches the agent in the name of another address before it comes from the station, which confirms from
    // its own. Blocked from then on, the station cannot prove its address, and the session must not turn to the other one.
    constexpr std::uint16_t kVictim = 6666;
    Pair pair(attackOptions());
    std::uint64_t in = 0, out = 0;
    bool blocked = false;
    pair.link.attacker = [&](TimePoint at, SentDatagram &flight) {
        if (flight.from == Air && flight.targetPort == kVictim) {
            out += flight.bytes.size();
            return false;
        }
        if (flight.bytes[0] == 0x59 && in == 0) {
            SentDatagram copy = flight;
            copy.sourcePort = kVictim;
            in = copy.bytes.size();
            pair.link.inject(at, copy);
        }
        return flight.from == Air || !blocked;
    };
    pair.every(20ms, [&pair] { pair.sendFrame(Air); });
    QVERIFY(pair.run(5s, [&] { return !pair.air().all<SessionUp>().empty(); }));
    QVERIFY(in > 0 && out > 0); // it was answered at the victim's address
    blocked = true;
    pair.run(30s);
    HOLDS(out <= in, "the address of a first message alone gets no records");
    QCOMPARE(pair.air().all<SessionDown>().size(), std::size_t(1));
    blocked = false;
    QVERIFY(pair.run(10s, [&] { return pair.bothUp(); }));
    pair.run(30s);
    QVERIFY(out <= in);
    pair.stopTraffic();
    pair.run(1s);
    QVERIFY(pair.bothUp());
}

void AttackSessionTest::answersToOtherAddressesEndNoTrial()
{
    // As above, but the agent of the quiet session asks at its configured address, and the attacker delivers the station's
    // answer from his own: it echoes a stamp of after the move, which proves nothing about his address.
    Hijack hijack(Air);
    Pair &pair = hijack.pair;
    const Caught kept = catchOne(pair, 28, Ground);
    Bytes newest;
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        if (flight.from == Ground)
            newest = flight.bytes;
        return flight.from == Air && flight.targetPort != hijack.thief.remote.port;
    };
    pair.every(20ms, [&pair] { pair.sendFrame(Air); });
    pair.run(300ms);
    hijack.offerFromThief(kept.flight.bytes);
    QVERIFY(hijack.isDiverted());
    newest.clear();
    pair.run(2400ms); // The agent has asked by then.
    QVERIFY(hijack.isDiverted() && !newest.empty());
    hijack.offerFromThief(newest);
    pair.run(5s);
    HOLDS(hijack.isHome(), "the session goes back to its peer");
}

void AttackSessionTest::echoesOfAnHourAgoEndNoTrial()
{
    // The stamps of reports repeat after 2^32 us: by the sign of their difference, one that is older by more than half of that
    // looks newer. The attacker withholds a station's reports, and delivers one of them every nine minutes, which does not keep
    // the session up; if it did, he would then deliver the others from his own address.
    Hijack hijack(Air);
    Pair &pair = hijack.pair;
    pair.every(20ms, [&pair] { pair.sendFrame(Air); });
    pair.run(3s);
    std::vector<SentDatagram> withheld;
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        if (flight.from == Ground)
            withheld.push_back(flight);
        return flight.from == Air && flight.targetPort != hijack.thief.remote.port;
    };
    pair.run(15s);
    pair.stopTraffic();
    pair.kill(Ground);
    std::size_t next = 0;
    for (int turn = 0; turn < 5; ++turn) {
        pair.run(9min);
        pair.link.inject(pair.now, withheld.at(next++));
    }
    pair.run(1s);
    QVERIFY(next + 5 < withheld.size());
    const bool isOver = !pair.air().up();
    for (; !isOver && next < withheld.size(); ++next) {
        hijack.offerFromThief(withheld[next].bytes);
        if (hijack.isDiverted())
            pair.run(10ms);
    }
    QVERIFY(isOver || hijack.isDiverted());
    pair.run(5s);
    HOLDS(isOver || hijack.isHome(), "the session goes back to its peer");
}

void AttackSessionTest::jitterReorderingAndDuplicates()
{
    WireModel link;
    link.delay = 50ms;
    link.jitter = 250ms;
    link.reorder = 0.5;
    link.reorderBy = 100ms;
    link.duplicate = 0.5;
    auto owner = pairUnder(SuiteId::Aes256Gcm, link);
    Pair &pair = *owner;
    traffic(pair, 5ms);
    pair.run(20s);
    pair.stopTraffic();
    pair.run(3s);
    HOLDS(pair.accountFrom(Air).empty() && pair.accountFrom(Ground).empty(), "each frame arrives once");
    QCOMPARE(pair.dropped[Air].size() + pair.dropped[Ground].size(), 0u);
    QVERIFY(received(pair.ground()).late > 1000 && received(pair.ground()).replayed > 1000);
    QCOMPARE(pair.ground().all<ForgeryAlarm>().size(), 0u);
}

void AttackSessionTest::deletion_data()
{
    QTest::addColumn<double>("loss");
    QTest::addColumn<double>("burst");
    QTest::addColumn<double>("burstEnd");
    for (const int percent : {1, 10, 30, 50, 70, 90})
        QTest::addRow("%d percent", percent) << percent / 100.0 << 0.0 << 0.1;
    QTest::newRow("bursts of 10, 1 percent between") << 0.01 << 0.02 << 0.1;
    QTest::newRow("bursts of 100") << 0.0 << 0.01 << 0.01;
}

void AttackSessionTest::deletion()
{
    QFETCH(double, loss);
    QFETCH(double, burst);
    QFETCH(double, burstEnd);
    auto owner = pairUnder(SuiteId::Aes256Ctr);
    Pair &pair = *owner;
    const Caught sample = catchOne(pair);
    pair.link.inject(pair.now, sample.flight);
    pair.run(10ms);
    pair.link.model.loss = loss;
    pair.link.model.burst = burst;
    pair.link.model.burstEnd = burstEnd;
    // On a lossy link an attacker forges counters that have not arrived yet: loss and forgeries are counted apart.
    std::uint64_t sealedByAir = 0;
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        sealedByAir = flight.from == Air ? counterOf(flight.bytes) + 1 : sealedByAir;
        return true;
    };
    traffic(pair);
    pair.every(1s, [&] {
        Bytes forged = sample.flight.bytes;
        setCounter(forged, static_cast<std::uint32_t>(sealedByAir) + 500);
        offer(pair, Ground, forged);
    });
    pair.run(30s);
    pair.stopTraffic();
    pair.link.model.loss = pair.link.model.burst = 0;
    pair.sendFrame(Air);
    pair.run(100ms);
    HOLDS(received(pair.ground()).good + received(pair.ground()).lost == pair.air().stats()->tx.records,
          "lost is exactly what was dropped");
    HOLDS(pair.accountFrom(Air).empty() && pair.accountFrom(Ground).empty(), "each frame arrives once");
    QCOMPARE(pair.ground().all<SessionUp>().size(), 1u);
}

void AttackSessionTest::outageOfFiveMinutes()
{
    auto owner = pairUnder(SuiteId::ChaCha20Poly1305);
    Pair &pair = *owner;
    traffic(pair, 10ms);
    pair.run(5s);
    swallowEverything(pair);
    pair.run(300s + 100ms); // An agent that had forgotten the session would announce itself only 400 ms later.
    pair.link.attacker = nullptr;
    const auto before = pair.ground().delivered.size();
    HOLDS(pair.run(20ms, [&] { return pair.ground().delivered.size() > before; }), "the first record after it is accepted");
    pair.stopTraffic();
    pair.run(2s);
    QCOMPARE(pair.air().all<SessionUp>().size(), 1u);
    QVERIFY(received(pair.ground()).lost >= 30000);
    QCOMPARE(received(pair.ground()).good + received(pair.ground()).lost, pair.air().stats()->tx.records);
    QVERIFY(aliveAndExact(pair));
}

void AttackSessionTest::jammedThenLossyLink()
{
    auto owner = pairUnder(SuiteId::Aes256Cbc);
    Pair &pair = *owner;
    traffic(pair);
    pair.run(5s);
    const auto silent = [&] { return pair.ground().up() && pair.ground().sessionInfo()->silent; };
    swallowEverything(pair);
    QVERIFY(pair.run(3500ms, silent)); // Long enough for a display that says "link lost" after 3.5 s.
    pair.run(30s);
    pair.link.attacker = nullptr;
    pair.link.model.loss = 0.5;
    const auto before = pair.ground().delivered.size();
    HOLDS(pair.run(1s, [&] { return pair.ground().delivered.size() > before; }), "the first record after it is accepted");
    pair.run(30s);
    pair.link.model.loss = 0;
    pair.stopTraffic();
    pair.run(2s);
    QCOMPARE(pair.air().all<SessionUp>().size(), 1u);
    QVERIFY(aliveAndExact(pair));
}

void AttackSessionTest::clockSteps()
{
    constexpr std::uint64_t kTenYears = 10ull * 365 * 24 * 3600;
    PairOptions options = attackOptions();
    Pair pair(options);
    pair.ground().counters.timeOfDay = pair.air().counters.timeOfDay = 2 * kTenYears;
    traffic(pair);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    // During a session, and back before the next handshake.
    for (const std::uint64_t time : {3 * kTenYears, kTenYears}) {
        pair.ground().counters.timeOfDay = pair.air().counters.timeOfDay = time;
        pair.run(5s);
        QCOMPARE(pair.air().all<SessionUp>().size(), 1u);
    }
    pair.kill(Ground);
    pair.start(Ground);
    HOLDS(pair.run(3s, [&] { return pair.ground().up() && pair.air().all<SessionUp>().size() == 2; }),
          "a handshake needs no clock");
}

void AttackSessionTest::replayedAnnouncementsEndNothing()
{
    Pair pair(attackOptions());
    Tap tap(pair);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    const auto announcements = tap.ofKind(0x58);
    QVERIFY(!announcements.empty());
    pair.link.attacker = nullptr;
    pair.run(1s);
    Path thief = pair.pathOf(Air);
    thief.remote.port = 6666;
    const std::uint64_t before = *pair.ground().counters.next();
    for (int i = 0; i < 200; ++i) {
        offer(pair, Ground, announcements[0].bytes, thief);
        pair.run(100ms);
    }
    HOLDS(*pair.ground().counters.next() == before + 1, "no handshake is begun while the session lives");
    QVERIFY(aliveAndExact(pair));
    QCOMPARE(pair.air().all<SessionUp>().size(), 1u);
}

/// While an agent reports that it receives nothing, an announcement on another carrier may begin a handshake. So the attacker
/// cuts the way to the agent, keeps its reports, and releases them when the way is open again.
void AttackSessionTest::withheldReportOfADeafAgent()
{
    Pair pair(attackOptions());
    Tap tap(pair);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    const auto announcements = tap.ofKind(0x58);
    QVERIFY(!announcements.empty());
    pair.run(2s);
    std::vector<SentDatagram> withheld;
    pair.link.attacker = [](TimePoint, SentDatagram &flight) { return flight.from == Air; };
    pair.run(1600ms); // from now on the agent says so
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        if (flight.from == Air && (flight.bytes[0] & 0xfc) == 0x50)
            withheld.push_back(flight);
        return false;
    };
    pair.run(2300ms); // a little longer, and the station would miss the agent
    pair.link.attacker = nullptr;
    QVERIFY(withheld.size() >= 2);
    pair.run(2s);
    QVERIFY(pair.bothUp());
    Path thief = pair.pathOf(Air);
    thief.link = LinkId{7};
    thief.carrier = Carrier::Tunnel;
    const std::uint64_t before = *pair.ground().counters.next();
    for (const SentDatagram &flight : withheld) {
        offer(pair, Ground, flight.bytes);
        offer(pair, Ground, announcements[0].bytes, thief);
        pair.run(100ms);
    }
    HOLDS(*pair.ground().counters.next() == before + 1, "no old report begins a handshake on another carrier");
    QVERIFY(aliveAndExact(pair));
    QCOMPARE(pair.air().all<SessionUp>().size(), 1u);
}

void AttackSessionTest::killedTwoHundredTimes()
{
    // Equal plaintexts over 200 restarts of either end: no two records are equal, so no pair of key and nonce repeated.
    Pair pair(attackOptions());
    std::unordered_set<std::string> bodies;
    std::uint64_t records = 0;
    const Bytes frame(40, 0xfd);
    Bytes record(40 + kMaxRecordOverhead);
    for (int life = 0; life < 200; ++life) {
        QVERIFY(pair.run(6s, [&] { return pair.bothUp(); }));
        for (auto &end : pair.ends) {
            for (int i = 0; i < 10; ++i, ++records) {
                QVERIFY(end.seal(pair.now, frame, record));
                bodies.emplace(reinterpret_cast<const char *>(record.data()) + 6, 20);
            }
        }
        const Side victim = life % 2 ? Ground : Air;
        pair.kill(victim);
        pair.run(std::chrono::milliseconds(m_random() % 50));
        pair.start(victim);
    }
    HOLDS(bodies.size() == records, "no pair of key and nonce comes twice");
}

void AttackSessionTest::everyControlRecordDropped()
{
    PairOptions options = attackOptions();
    options.timing.rekeyAfterRecords = 500;
    options.timing.hardStopRecords = 3000;
    Pair pair(options);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    pair.link.attacker = [](TimePoint, SentDatagram &flight) { return flight.tag != 0; }; // Only frames pass.
    const auto before = pair.air().stats()->tx.records;
    pair.every(10ms, [&] { pair.sendFrame(Air); });
    pair.every(20ms, [&] { pair.sendFrame(Ground); });
    HOLDS(pair.run(60s, [&] { return !pair.air().all<SessionDown>().empty(); }), "an epoch ends at its limit");
    const SessionDown down = pair.air().all<SessionDown>()[0];
    QCOMPARE(down.reason, DownReason::Exhausted);
    QCOMPARE(down.stats.tx.records, std::uint64_t(3000));
    QVERIFY(before < 100);
    // The failed rekeys were reported.
    const auto done = pair.air().all<SwitchDone>();
    QVERIFY(!done.empty());
    for (const SwitchDone &d : done)
        QVERIFY(d.rekey && d.failure != SwitchFailure::None);
    QCOMPARE(QString::fromStdString(pair.accountFrom(Air)), QString());
}

void AttackSessionTest::clonedEnd_data()
{
    QTest::addColumn<int>("side");
    QTest::newRow("station") << static_cast<int>(Ground);
    QTest::newRow("agent") << static_cast<int>(Air);
}

/// A snapshot of a machine runs twice. Two pairs from one seed have the same keys and counters, so that the end of the second
/// pair is a clone of that of the first.
void AttackSessionTest::clonedEnd()
{
    QFETCH(int, side);
    const auto from = static_cast<Side>(side), to = from == Ground ? Air : Ground;
    const auto pair = pairUnder(SuiteId::ChaCha20Poly1305), clones = pairUnder(SuiteId::ChaCha20Poly1305);
    const Caught original = catchOne(*pair, 28, from), clone = catchOne(*clones, 40, from);
    const auto head = [](const Caught &caught) { return Bytes(caught.flight.bytes.begin(), caught.flight.bytes.begin() + 6); };
    QCOMPARE(head(original), head(clone)); // with the counter
    QVERIFY(offer(*pair, to, original.flight.bytes));

    // A copy by the network, and a forged record with the same counter, have no effect.
    QVERIFY(!offer(*pair, to, original.flight.bytes));
    Bytes forged = original.flight.bytes;
    forged.back() ^= 1;
    QVERIFY(!offer(*pair, to, forged));
    pair->run(1ms);
    QVERIFY(pair->ends[to].all<SessionDown>().empty());

    QVERIFY(!offer(*pair, to, clone.flight.bytes));
    pair->run(1ms);
    const auto down = pair->ends[to].all<SessionDown>();
    HOLDS(down.size() == 1, "keys that are in use twice end with their session");
    QCOMPARE(down[0].reason, DownReason::Cloned);
    const auto ups = pair->ends[from].all<SessionUp>().size();
    QVERIFY(pair->run(5s, [&] { return pair->ends[from].all<SessionUp>().size() > ups && pair->bothUp(); }));
}

/// A machine is put back to a snapshot, while its peer went on: the reports of the peer count what the machine sent before.
void AttackSessionTest::restoredEnd()
{
    QFETCH(int, side);
    const auto from = static_cast<Side>(side), to = from == Ground ? Air : Ground;
    const auto pair = pairUnder(SuiteId::ChaCha20Poly1305), restored = pairUnder(SuiteId::ChaCha20Poly1305);
    traffic(*pair);
    pair->run(5s);
    std::vector<Bytes> sent;
    pair->link.attacker = [&](TimePoint, SentDatagram &flight) {
        if (flight.from == to)
            sent.push_back(flight.bytes);
        return true;
    };
    pair->run(2s); // with a report
    QVERIFY(!sent.empty());
    for (const Bytes &bytes : sent)
        offer(*restored, from, bytes);
    restored->run(1ms);
    const auto down = restored->ends[from].all<SessionDown>();
    HOLDS(down.size() == 1, "a session that went on elsewhere ends");
    QCOMPARE(down[0].reason, DownReason::Cloned);
}

SKYSEAL_TEST(AttackSessionTest)
#include "attack_session_test.moc"
