// Two endpoints from their first announcement on: a session comes up, carries frames of every suite, survives failures of links
// and processes, and accounts for every frame.
#include "core/channel/endpoint.h"
#include "core/crypto/init_crypto.h"
#include "pair.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;
using crypto::SuiteId;

class SessionTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void comesUpWithinASecond_data();
    void comesUpWithinASecond();
    void carriesFramesInEverySuite();
    void comesUpOverABadLink();
    void stationRestarts();
    void agentRestarts();
    void restartsRepeatedly();
    void outageResumesWithoutHandshake();
    void followsTheAddressOfThePeer();
    void staysAtTheConfirmedAddress();
    void closesOnce();
    void countersAgreeOnBothEnds();
    void costsAreReportedOnRequest();
};

namespace {

WireModel badLink()
{
    WireModel link;
    link.loss = 0.2;
    link.duplicate = 0.1;
    link.reorder = 0.1;
    link.delay = 10ms;
    link.jitter = 50ms;
    return link;
}

void exchange(Pair &pair)
{
    pair.every(20ms, [&pair] {
        pair.sendFrame(Air);
        pair.sendFrame(Ground, 40);
    });
}

std::optional<EndCosts> toldCosts(Pair &pair, Side side)
{
    const auto stats = pair.ends[side].stats();
    return stats ? stats->peerCosts : std::nullopt;
}

} // namespace

#define VERIFY_ACCOUNTS(pair)                                                                                                  \
    QCOMPARE(QString::fromStdString(pair.accountFrom(Air)), QString());                                                        \
    QCOMPARE(QString::fromStdString(pair.accountFrom(Ground)), QString())

void SessionTest::comesUpWithinASecond_data()
{
    QTest::addColumn<bool>("toAddress");
    QTest::newRow("announced to an address") << true;
    QTest::newRow("announced to the one peer of a link") << false;
}

void SessionTest::comesUpWithinASecond()
{
    QFETCH(bool, toAddress);
    PairOptions options;
    options.announceToAddress = toAddress;
    Pair pair(options);
    QVERIFY(pair.run(1s, [&] { return pair.bothUp(); }));
    const auto info = pair.ground().sessionInfo();
    QVERIFY(info);
    QCOMPARE(info->suite, SuiteId::ChaCha20Poly1305);
    QCOMPARE(info->peer, pair.air().publicKey());
    QCOMPARE(info->peerName, std::string("air"));
    QCOMPARE(pair.ground().all<SessionUp>().size(), 1u);
    QCOMPARE(pair.air().all<SessionUp>().size(), 1u);
    pair.run(60s);
    QCOMPARE(pair.ground().events.size(), 1u);
    QCOMPARE(pair.air().events.size(), 1u);
    // A quiet session costs its reports, not more.
    QVERIFY2(pair.air().datagramsOut < 80, qPrintable(QString::number(pair.air().datagramsOut)));
    qInfo("%.1f bytes a datagram", static_cast<double>(pair.air().bytesOut) / static_cast<double>(pair.air().datagramsOut));
}

void SessionTest::carriesFramesInEverySuite()
{
    Pair pair;
    QVERIFY(pair.run(1s, [&] { return pair.bothUp(); }));
    exchange(pair);
    std::uint32_t epoch = 0;
    for (const auto &suite : crypto::suites()) {
        if (suite.id == SuiteId::None || !crypto::suiteAvailable(suite.id) || suite.id == SuiteId::ChaCha20Poly1305)
            continue;
        pair.ground().switchSuite(pair.now, suite.id);
        pair.run(1s);
        ++epoch;
        for (auto &end : pair.ends) {
            const auto info = end.sessionInfo();
            QCOMPARE(info->suite, suite.id);
            QCOMPARE(info->epoch, Epoch{epoch});
            QVERIFY(!info->pending);
            const auto done = end.all<SwitchDone>();
            QCOMPARE(done.size(), std::size_t(epoch));
            QCOMPARE(done.back().failure, SwitchFailure::None);
            QCOMPARE(done.back().to, suite.id);
        }
    }
    QVERIFY(epoch >= 4);
    pair.stopTraffic();
    pair.run(2s);
    VERIFY_ACCOUNTS(pair);
    QCOMPARE(pair.dropped[Air].size(), 0u);
}

void SessionTest::comesUpOverABadLink()
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        PairOptions options;
        options.seed = seed;
        options.link = badLink();
        Pair pair(options);
        exchange(pair);
        QVERIFY2(pair.run(10s, [&] { return pair.bothUp(); }), qPrintable(QString::number(seed)));
        pair.run(10s);
        pair.stopTraffic();
        pair.run(2s);
        VERIFY_ACCOUNTS(pair);
    }
}

void SessionTest::stationRestarts()
{
    Pair pair;
    exchange(pair);
    pair.run(5s);
    pair.kill(Ground);
    pair.run(700ms);
    pair.start(Ground);
    const TimePoint back = pair.now;
    QVERIFY(pair.run(3s, [&] { return pair.bothUp() && pair.air().all<SessionUp>().size() == 2; }));
    qInfo("station back in session after %.3f s", seconds(pair.now - back));
    QCOMPARE(pair.air().all<SessionDown>().size(), 1u);
    QCOMPARE(pair.air().all<SessionDown>()[0].reason, DownReason::PeerRestarted);
    QCOMPARE(pair.air().sessions().size(), 1u);
}

void SessionTest::agentRestarts()
{
    Pair pair;
    exchange(pair);
    pair.run(5s);
    pair.kill(Air);
    pair.run(700ms);
    pair.start(Air);
    const TimePoint back = pair.now;
    QVERIFY(pair.run(3s, [&] { return pair.air().up() && pair.ground().all<SessionUp>().size() == 2; }));
    qInfo("agent back in session after %.3f s", seconds(pair.now - back));
    QCOMPARE(pair.ground().all<SessionDown>().size(), 1u);
    QCOMPARE(pair.ground().all<SessionDown>()[0].reason, DownReason::PeerRestarted);
    QCOMPARE(pair.ground().sessions().size(), 1u);
}

void SessionTest::restartsRepeatedly()
{
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        PairOptions options;
        options.seed = seed;
        Pair pair(options);
        exchange(pair);
        for (int i = 0; i < 20; ++i) {
            const Side side = (seed + static_cast<std::uint64_t>(i) * 7) % 3 ? Air : Ground;
            pair.run(std::chrono::milliseconds(100 + (seed * 97 + static_cast<std::uint64_t>(i) * 331) % 3000));
            pair.kill(side);
            pair.run(std::chrono::milliseconds((seed * 131 + static_cast<std::uint64_t>(i) * 577) % 4000));
            pair.start(side);
            const auto ups = pair.ends[1 - side].all<SessionUp>().size();
            QVERIFY(pair.run(3s, [&] { return pair.bothUp() && pair.ends[1 - side].all<SessionUp>().size() > ups; }));
        }
    }
}

void SessionTest::outageResumesWithoutHandshake()
{
    for (const Duration outage : {Duration(4s), Duration(60s), Duration(300s)}) {
        Pair pair;
        pair.every(10ms, [&pair] { pair.sendFrame(Air); });
        pair.run(5s);
        pair.link.attacker = [](TimePoint, SentDatagram &) { return false; };
        pair.run(outage);
        QVERIFY(pair.ground().sessionInfo()->silent);
        pair.link.attacker = nullptr;
        const auto before = pair.ground().delivered.size();
        pair.run(30ms);
        QVERIFY(pair.ground().delivered.size() > before);
        pair.run(10s);
        QCOMPARE(pair.ground().all<SessionUp>().size(), 1u);
        QCOMPARE(pair.air().all<SessionUp>().size(), 1u);
        QCOMPARE(pair.ground().all<SessionDown>().size(), 0u);
        pair.stopTraffic();
        pair.run(2s);
        VERIFY_ACCOUNTS(pair);
    }
}

void SessionTest::followsTheAddressOfThePeer()
{
    Pair pair;
    exchange(pair);
    pair.run(3s);
    pair.air().port = 50001;
    pair.run(1s);
    QCOMPARE(pair.ground().recordPath().remote.port, std::uint16_t(50001));
    QCOMPARE(pair.ground().all<PeerMoved>().size(), 1u);
    QCOMPARE(pair.ground().all<SessionUp>().size(), 1u);
    // Moves with every record: reported, at most once a second.
    pair.every(20ms, [&pair] { pair.air().port = static_cast<std::uint16_t>(50000 + (pair.air().port + 1) % 100); });
    pair.run(10s);
    QVERIFY(pair.ground().all<PeerMoved>().size() <= 12);
    pair.stopTraffic();
    pair.run(2s);
    VERIFY_ACCOUNTS(pair);
}

void SessionTest::staysAtTheConfirmedAddress()
{
    // An end that moved, was confirmed there, and then is unreachable for long is addressed at its new address.
    Pair pair;
    pair.run(3s);
    pair.air().port = 50001;
    const auto where = [&] { return pair.ground().recordPath().remote.port; };
    QVERIFY(pair.run(1100ms, [&] { return where() == 50001; }));
    pair.run(2100ms); // a report there, and one back
    pair.link.attacker = [](TimePoint, SentDatagram &) { return false; };
    pair.run(60s);
    QCOMPARE(where(), std::uint16_t(50001));
    pair.link.attacker = nullptr;
    pair.run(3s);
    QCOMPARE(pair.ground().all<SessionUp>().size(), 1u);
    QVERIFY(!pair.ground().sessionInfo()->silent);
}

void SessionTest::closesOnce()
{
    Pair pair;
    exchange(pair);
    pair.run(3s);
    pair.stopTraffic();
    pair.air().close(pair.now);
    pair.run(50ms);
    QCOMPARE(pair.air().all<SessionDown>().size(), 1u);
    QCOMPARE(pair.air().all<SessionDown>()[0].reason, DownReason::Closed);
    QCOMPARE(pair.ground().all<SessionDown>().size(), 1u);
    QCOMPARE(pair.ground().all<SessionDown>()[0].reason, DownReason::PeerClosed);
    QVERIFY(pair.ground().all<SessionDown>()[0].stats.rx.good > 100);
    QCOMPARE(QString::fromStdString(pair.accountFrom(Air)), QString());
}

void SessionTest::countersAgreeOnBothEnds()
{
    PairOptions options;
    options.link = badLink();
    Pair pair(options);
    std::uint64_t recordsDropped[2] = {};
    exchange(pair);
    pair.run(20s);
    pair.stopTraffic();
    pair.link.model = {};
    pair.run(5s); // The last reports pass.
    for (const Side side : {Ground, Air}) {
        const auto &here = pair.ends[side];
        const auto &there = pair.ends[1 - side];
        const auto mine = here.stats();
        const auto yours = there.stats();
        QVERIFY(mine && yours && mine->peerReported);
        QVERIFY(mine->rx.good <= yours->tx.records);
        // Every record arrived or is lost; only the report of this moment is in transit.
        const auto accounted = mine->rx.good + mine->rx.lost;
        QCOMPARE(accounted, yours->tx.records);
        QVERIFY(yours->peerRx.good + 3 >= mine->rx.good && yours->peerRx.good <= mine->rx.good);
        QVERIFY(mine->rx.lost > 100 && mine->rx.late > 10 && mine->rx.replayed > 10);
        QVERIFY(mine->roundTrip > 1ms);
        recordsDropped[side] = mine->rx.lost;
    }
    QVERIFY(recordsDropped[Ground] >= pair.dropped[Air].size());
}

void SessionTest::costsAreReportedOnRequest()
{
    Pair pair;
    pair.start(Ground);
    pair.start(Air);
    std::uint64_t asked = 0;
    pair.air().endpoint->setCostSource([&](SessionId session) {
        ++asked;
        return session == pair.air().session() ? EndCosts{7'000'000, 1 << 24, 30, 40'000, 50, 60'000} : EndCosts{};
    });
    QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
    pair.run(3s);
    QCOMPARE(asked, std::uint64_t(0)); // no cost in normal flight
    QVERIFY(!toldCosts(pair, Ground));

    // A change is answered at once, and not with the next report of each end.
    pair.ground().endpoint->askCosts(true);
    QVERIFY(pair.run(100ms, [&] { return toldCosts(pair, Ground).has_value(); }));
    pair.ground().endpoint->askCosts(false);
    QVERIFY(pair.run(100ms, [&] { return !toldCosts(pair, Ground); }));
    const std::uint64_t askedBefore = asked;
    pair.run(3s);
    QCOMPARE(asked, askedBefore);

    pair.ground().endpoint->askCosts(true);
    pair.run(3s);
    const auto told = toldCosts(pair, Ground);
    QVERIFY(told);
    QCOMPARE(told->cpuMicroseconds, std::uint64_t(7'000'000));
    QCOMPARE(told->residentBytes, std::uint64_t(1 << 24));
    QCOMPARE(told->opened, std::uint64_t(30));
    QCOMPARE(told->openNanoseconds, std::uint64_t(40'000));
    QCOMPARE(told->sealed, std::uint64_t(50));
    QCOMPARE(told->sealNanoseconds, std::uint64_t(60'000));
    QVERIFY(!toldCosts(pair, Air));
    const auto before = pair.ground().stats();
    pair.run(1s);
    const auto after = pair.ground().stats();
    QCOMPARE(after->peerStamp / 10'000 - before->peerStamp / 10'000, 100u); // by the agent's own clock

    pair.air().endpoint->askCosts(true); // of an end that does not measure itself
    pair.ground().endpoint->askCosts(false);
    pair.run(3s);
    QVERIFY(!toldCosts(pair, Ground));
    QVERIFY(!toldCosts(pair, Air));
    VERIFY_ACCOUNTS(pair);
}

SKYSEAL_TEST(SessionTest)
#include "session_test.moc"
