// The live switch over links that lose, repeat, reorder and delay, with both ends proposing: each frame that the link
// transports is delivered exactly once.
#include "core/channel/suite_strength.h"
#include "core/crypto/init_crypto.h"
#include "pair.h"
#include "stolen_session.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;
using crypto::SuiteId;

class SwitchTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void stricterPolicyMovesOrEndsTheSession();
    void stricterPolicyAppliesToPendingHandshakes_data();
    void stricterPolicyAppliesToPendingHandshakes();
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void everySecondOnABadLink();
    void every50MillisecondsOnAGoodLink();
    void stormWithBothEndsProposing();
    void bothAtTheSameInstant();
    void refusedByPolicyHere();
    void refusedByThePeer();
    void unansweredRollsBackOnce();
    void confirmationLostForAMinute();
    void plainSuiteIsRefused();
    void replacedRequestIsSuperseded();
    void endsWithTheSession();
    void weakKeysAreRefused();
};

namespace {

WireModel stormyLink()
{
    WireModel link;
    link.loss = 0.2;
    link.duplicate = 0.1;
    link.reorder = 0.1;
    link.delay = 5ms;
    link.jitter = 300ms;
    return link;
}

SuiteId suiteAt(std::size_t i)
{
    static const std::vector<SuiteId> usable = [] {
        std::vector<SuiteId> out;
        for (const SuiteId suite : defaultSuites()) {
            if (crypto::suiteAvailable(suite))
                out.push_back(suite);
        }
        return out;
    }();
    return usable[i % usable.size()];
}

void traffic(Pair &pair, Duration period = 20ms)
{
    pair.every(period, [&pair] {
        pair.sendFrame(Air);
        pair.sendFrame(Ground, 40);
    });
}

/// Pending and done alternate as they should, and the epochs of commits go up one by one.
QString eventsInOrder(const Pair::End &end)
{
    int open = 0;
    std::uint32_t epoch = 0;
    for (const Event &event : end.events) {
        if (std::holds_alternative<SwitchPending>(event))
            ++open;
        if (const auto *done = std::get_if<SwitchDone>(&event)) {
            if (--open < 0)
                return QStringLiteral("done without pending");
            if (done->failure == SwitchFailure::None && static_cast<std::uint32_t>(done->epoch) != ++epoch)
                return QStringLiteral("epoch %1 after %2").arg(static_cast<std::uint32_t>(done->epoch)).arg(epoch - 1);
        }
    }
    return open == 0 ? QString() : QStringLiteral("%1 never done").arg(open);
}

QString epochsMonotone(const Pair::End &end)
{
    // Deliveries may come late under the previous epoch, but never two epochs late.
    std::uint32_t newest = 0;
    for (const std::uint32_t epoch : end.epochs) {
        if (epoch + 1 < newest)
            return QStringLiteral("epoch %1 after %2").arg(epoch).arg(newest);
        newest = std::max(newest, epoch);
    }
    return {};
}

} // namespace

#define VERIFY_ALL(pair)                                                                                                       \
    QCOMPARE(QString::fromStdString(pair.accountFrom(Air)), QString());                                                        \
    QCOMPARE(QString::fromStdString(pair.accountFrom(Ground)), QString());                                                     \
    QCOMPARE(eventsInOrder(pair.ground()), QString());                                                                         \
    QCOMPARE(eventsInOrder(pair.air()), QString());                                                                            \
    QCOMPARE(epochsMonotone(pair.ground()), QString());                                                                        \
    QCOMPARE(epochsMonotone(pair.air()), QString());                                                                           \
    QCOMPARE(pair.ground().stats()->rx.forged, std::uint64_t(0));                                                              \
    QCOMPARE(pair.air().stats()->rx.forged, std::uint64_t(0))

void SwitchTest::everySecondOnABadLink()
{
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        PairOptions options;
        options.seed = seed;
        options.link = stormyLink();
        options.link.jitter = 50ms;
        Pair pair(options);
        traffic(pair);
        QVERIFY(pair.run(10s, [&] { return pair.bothUp(); }));
        pair.run(2s);
        std::size_t step = 0;
        pair.every(1s, [&] { pair.ground().switchSuite(pair.now, suiteAt(++step)); });
        pair.run(60s);
        pair.stopTraffic();
        pair.run(10s);
        VERIFY_ALL(pair);
        QVERIFY2(pair.ground().switches() >= 55, qPrintable(QString::number(pair.ground().switches())));
        QCOMPARE(pair.ground().switches(), pair.air().switches());
    }
}

void SwitchTest::every50MillisecondsOnAGoodLink()
{
    Pair pair;
    traffic(pair, 2ms);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    std::size_t step = 0;
    pair.every(50ms, [&] { pair.ground().switchSuite(pair.now, suiteAt(++step)); });
    pair.run(10s);
    pair.stopTraffic();
    pair.run(2s);
    VERIFY_ALL(pair);
    QCOMPARE(pair.ground().switches(), step);
    QCOMPARE(pair.air().switches(), step);
}

void SwitchTest::stormWithBothEndsProposing()
{
    const std::size_t wanted = qEnvironmentVariableIsSet("SKYSEAL_SWITCHES")
        ? static_cast<std::size_t>(qEnvironmentVariableIntValue("SKYSEAL_SWITCHES"))
        : 200;
    PairOptions options;
    options.seed = 7;
    options.link = stormyLink();
    Pair pair(options);
    traffic(pair);
    QVERIFY(pair.run(10s, [&] { return pair.bothUp(); }));
    std::size_t step = 0;
    for (const Side side : {Ground, Air}) {
        pair.every(side == Ground ? Duration(1100ms) : Duration(1300ms), [&pair, &step, side] {
            auto &end = pair.ends[side];
            if (end.up() && !end.sessionInfo()->pending)
                end.switchSuite(pair.now, suiteAt(++step));
        });
    }
    QVERIFY(pair.run(std::chrono::seconds(20) * wanted, [&] { return pair.ground().switches() >= wanted; }));
    const Duration took = pair.now - TimePoint(1h);
    pair.stopTraffic();
    pair.run(20s);
    VERIFY_ALL(pair);
    QCOMPARE(pair.ground().switches(), pair.air().switches());
    qInfo("%zu switches of %zu asked for in %.0f s, %zu frames sent, %zu dropped by the link, the rest arrived once",
          pair.ground().switches(), step, seconds(took), pair.sent[Air].size() + pair.sent[Ground].size(),
          pair.dropped[Air].size() + pair.dropped[Ground].size());
}

void SwitchTest::bothAtTheSameInstant()
{
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        PairOptions options;
        options.seed = seed;
        options.link.delay = 20ms;
        options.link.jitter = 30ms;
        Pair pair(options);
        traffic(pair);
        QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
        pair.run(3s);
        pair.ground().switchSuite(pair.now, SuiteId::Aes256Gcm);
        pair.air().switchSuite(pair.now, SuiteId::Aes256Ctr);
        pair.run(5s);
        // The station's proposal wins; the agent's is reported as superseded.
        for (auto &end : pair.ends)
            QCOMPARE(end.sessionInfo()->suite, SuiteId::Aes256Gcm);
        const auto done = pair.air().all<SwitchDone>();
        QCOMPARE(done.size(), 2u);
        QCOMPARE(done[0].failure, SwitchFailure::Superseded);
        QVERIFY(!done[0].byPeer);
        QCOMPARE(done[1].failure, SwitchFailure::None);
        QVERIFY(done[1].byPeer);
        pair.stopTraffic();
        pair.run(2s);
        VERIFY_ALL(pair);
    }
}

void SwitchTest::refusedByPolicyHere()
{
    PairOptions options;
    options.ground.allowResearch = false;
    Pair pair(options);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.ground().switchSuite(pair.now, SuiteId::Rc4);
    pair.run(1s);
    const auto done = pair.ground().all<SwitchDone>();
    QCOMPARE(done.size(), 1u);
    QCOMPARE(done[0].failure, SwitchFailure::NotAllowedHere);
    QCOMPARE(pair.air().all<SwitchPending>().size(), 0u);
}

void SwitchTest::refusedByThePeer()
{
    Pair pair;
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    // Its policy became stricter after the handshake, which the station does not know.
    channel::Policy strict = pair.air().policy;
    strict.suites = {SuiteId::ChaCha20Poly1305};
    pair.air().setPolicy(pair.now, strict);
    pair.ground().switchSuite(pair.now, SuiteId::Aes256Gcm);
    pair.run(1s);
    const auto done = pair.ground().all<SwitchDone>();
    QCOMPARE(done.size(), 1u);
    QCOMPARE(done[0].failure, SwitchFailure::NotAllowedByPeer);
    QCOMPARE(pair.air().all<SwitchPending>().size(), 0u);
    QCOMPARE(pair.ground().sessionInfo()->suite, SuiteId::ChaCha20Poly1305);
}

void SwitchTest::stricterPolicyAppliesToPendingHandshakes_data()
{
    QTest::addColumn<int>("side");
    QTest::addColumn<int>("after");
    for (const Side side : {Ground, Air}) {
        for (const int after : {150, 250, 350, 450}) // while each of the messages is on its way
            QTest::addRow("%s, %d ms", side == Ground ? "station" : "agent", after) << int(side) << after;
    }
}

void SwitchTest::stricterPolicyAppliesToPendingHandshakes()
{
    QFETCH(int, side);
    QFETCH(int, after);
    PairOptions options;
    options.link.delay = 100ms;
    Pair pair(options);
    pair.run(std::chrono::milliseconds(after));
    pair.ends[static_cast<std::size_t>(side)].setPolicy(pair.now, Policy{{SuiteId::Aes256Ctr}, false, false});
    const auto strict = [](const Pair::End &end) {
        const auto info = end.sessionInfo();
        return info && info->suite == SuiteId::Aes256Ctr && !info->pending;
    };
    QVERIFY(pair.run(5s, [&] { return strict(pair.ground()) && strict(pair.air()); }));
    pair.run(20s);
    QVERIFY(strict(pair.ground()) && strict(pair.air()));
}

void SwitchTest::unansweredRollsBackOnce()
{
    Pair pair;
    traffic(pair);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.link.attacker = [](TimePoint, SentDatagram &flight) { return flight.from == Ground; }; // nothing reaches the station
    pair.ground().switchSuite(pair.now, SuiteId::Aes256Gcm);
    pair.run(4900ms);
    QCOMPARE(pair.ground().all<SwitchDone>().size(), 0u);
    pair.run(200ms);
    const auto done = pair.ground().all<SwitchDone>();
    QCOMPARE(done.size(), 1u);
    QCOMPARE(done[0].failure, SwitchFailure::NotConfirmed);
    pair.link.attacker = nullptr;
    pair.run(10s);
    QCOMPARE(pair.ground().all<SwitchDone>().size(), 1u);
    QCOMPARE(pair.air().all<SwitchDone>().size(), 1u);
    QCOMPARE(pair.air().all<SwitchDone>()[0].failure, SwitchFailure::NotConfirmed);
    // And the next one works, in either direction.
    pair.air().switchSuite(pair.now, SuiteId::ChaCha20);
    pair.run(3s);
    pair.ground().switchSuite(pair.now, SuiteId::Aes256Cbc);
    pair.run(3s);
    QCOMPARE(pair.air().sessionInfo()->suite, SuiteId::Aes256Cbc);
    pair.stopTraffic();
    pair.run(2s);
    VERIFY_ALL(pair);
}

void SwitchTest::confirmationLostForAMinute()
{
    // The agent has accepted, the station has committed, and then nothing of the station arrives for a minute: the agent
    // reports a failure, and still reads the new epoch when the link returns.
    Pair pair;
    traffic(pair);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    bool cut = false;
    pair.link.attacker = [&cut](TimePoint, SentDatagram &flight) { return !(cut && flight.from == Ground); };
    pair.ground().switchSuite(pair.now, SuiteId::Aes256Gcm);
    QVERIFY(pair.run(1s, [&] { return !pair.air().all<SwitchPending>().empty(); }));
    cut = true;
    pair.run(60s);
    QCOMPARE(pair.ground().switches(), 1u);
    QCOMPARE(pair.air().all<SwitchDone>().size(), 1u);
    QCOMPARE(pair.air().all<SwitchDone>()[0].failure, SwitchFailure::NotConfirmed);
    cut = false;
    pair.run(5s);
    QCOMPARE(pair.air().switches(), 1u);
    QCOMPARE(pair.air().sessionInfo()->suite, SuiteId::Aes256Gcm);
    QCOMPARE(pair.ground().all<SessionUp>().size(), 1u);
    pair.stopTraffic();
    pair.run(2s);
    VERIFY_ALL(pair);
}

void SwitchTest::plainSuiteIsRefused()
{
    PairOptions options;
    options.ground.allowPlain = options.air.allowPlain = true;
    Pair pair(options);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.ground().switchSuite(pair.now, SuiteId::None);
    pair.run(1s);
    QCOMPARE(pair.ground().all<SwitchDone>().size(), 1u);
    QCOMPARE(pair.ground().all<SwitchDone>()[0].failure, SwitchFailure::NotAllowedHere);
}

void SwitchTest::replacedRequestIsSuperseded()
{
    Pair pair;
    traffic(pair);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    for (const SuiteId suite : {SuiteId::Aes256Gcm, SuiteId::Aes256Ctr, SuiteId::ChaCha20})
        pair.ground().switchSuite(pair.now, suite);
    pair.run(3s);
    const auto done = pair.ground().all<SwitchDone>();
    QCOMPARE(done.size(), 3u);
    QCOMPARE(done[0].failure, SwitchFailure::Superseded);
    QCOMPARE(done[1].failure, SwitchFailure::Superseded);
    QCOMPARE(done[2].failure, SwitchFailure::None);
    QCOMPARE(pair.air().sessionInfo()->suite, SuiteId::ChaCha20);
    pair.stopTraffic();
    pair.run(2s);
    VERIFY_ALL(pair);
}

void SwitchTest::endsWithTheSession()
{
    Pair pair;
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.link.attacker = [](TimePoint, SentDatagram &) { return false; };
    pair.ground().switchSuite(pair.now, SuiteId::Aes256Gcm);
    pair.run(1s);
    pair.ground().close(pair.now);
    pair.run(1s);
    const auto done = pair.ground().all<SwitchDone>();
    QCOMPARE(done.size(), 1u);
    QCOMPARE(done[0].failure, SwitchFailure::SessionEnded);
}

void SwitchTest::stricterPolicyMovesOrEndsTheSession()
{
    Pair pair;
    QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
    pair.ground().switchSuite(pair.now, SuiteId::Aes256Cbc);
    QVERIFY(pair.run(10s, [&] { return pair.ground().all<SwitchDone>().size() == 1; }));
    const Policy strict{notWeakerThan(SuiteId::Aes256Gcm, defaultSuites()), false, false};
    pair.run(10s);
    pair.ground().setPolicy(pair.now, strict);
    QVERIFY(pair.run(10s, [&] { return pair.ground().all<SwitchDone>().size() == 2; }));
    const SuiteId now = pair.ground().sessionInfo()->suite;
    QVERIFY(crypto::suiteInfo(now).strength >= crypto::suiteInfo(SuiteId::Aes256Gcm).strength);
    // No suite remains that both allow.
    pair.air().setPolicy(pair.now, Policy{{SuiteId::Aes256Cbc}, false, false});
    QVERIFY(pair.run(20s, [&] { return !pair.air().up() && !pair.ground().up(); }));
    pair.run(10s);
    QVERIFY(!pair.air().up());
}

void SwitchTest::weakKeysAreRefused()
{
    // Points of small order, from a peer that has the keys of the session.
    PairOptions options;
    Pair pair(options);
    Tap tap(pair);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    const StolenSession peer(pair, tap, options.seed, SuiteId::ChaCha20Poly1305);
    tap.flights.clear();
    const auto malformed = [&](Side side) { return pair.ends[side].stats()->rx.malformed; };
    const auto offer = [&](Side from, const Bytes &record) {
        Bytes copy = record;
        pair.ends[from == Ground ? Air : Ground].handleDatagram(pair.now, pair.pathOf(from), copy);
        pair.pump();
    };
    std::uint32_t counter = 1000;
    for (const std::uint8_t first : {0, 1}) {
        crypto::PublicKey weak{};
        weak[0] = first;
        offer(Ground, peer.seal(Ground, ++counter, Propose{ProposalId{1}, Epoch{1}, SuiteId::ChaCha20Poly1305, weak}));
        QCOMPARE(malformed(Air), std::uint64_t(first + 1));
    }
    QVERIFY(!peer.newest<Accept>(tap.flights) && !peer.newest<Refuse>(tap.flights));
    QVERIFY(pair.air().all<SwitchPending>().empty());

    // In an answer: the proposal stays open, and the true answer to its next copy is taken.
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        tap.flights.push_back(flight);
        return flight.from == Ground;
    };
    pair.air().rekey(pair.now);
    pair.run(10ms);
    QVERIFY(pair.air().sessionInfo()->pending);
    offer(Ground, peer.seal(Ground, ++counter, Accept{ProposalId{1}, {}}));
    QCOMPARE(malformed(Air), std::uint64_t(3));
    QVERIFY(pair.air().sessionInfo()->pending);
    QCOMPARE(pair.air().sessionInfo()->epoch, Epoch{0});
    offer(Ground, peer.seal(Ground, ++counter, Accept{ProposalId{1}, crypto::PublicKey{9}}));
    QCOMPARE(pair.air().sessionInfo()->epoch, Epoch{1});
}

SKYSEAL_TEST(SwitchTest)
#include "switch_test.moc"
