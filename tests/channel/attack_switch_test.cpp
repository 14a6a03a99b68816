// Attacks on the live switch: the worst link, with both ends proposing, and an attacker who selects the lost messages.
#include "attack.h"
#include "core/crypto/init_crypto.h"
#include "stolen_session.h"
#include "tests/support/holds.h"
#include "tests/support/test_runner.h"

using namespace skyseal;
using namespace skyseal::test;

class AttackSwitchTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(crypto::initCrypto());
        qInfo("seed %llu", static_cast<unsigned long long>(kAttackSeed));
    }
    void raceOfBothEnds();
    void acceptancesAreDropped();
    void proposalFlood();
};

namespace {

void trafficOfBoth(Pair &pair)
{
    pair.every(20ms, [&pair] {
        pair.sendFrame(Air);
        pair.sendFrame(Ground, 40);
    });
}

} // namespace

void AttackSwitchTest::raceOfBothEnds()
{
    const int asked = qEnvironmentVariableIntValue("SKYSEAL_SWITCHES");
    const std::size_t wanted = asked > 0 ? static_cast<std::size_t>(asked) : 200;
    PairOptions options = attackOptions();
    options.link.loss = 0.2;
    options.link.duplicate = 0.1;
    options.link.reorder = 0.1;
    options.link.delay = 5ms;
    options.link.jitter = 300ms;
    Pair pair(options);
    trafficOfBoth(pair);
    QVERIFY(pair.run(10s, [&] { return pair.bothUp(); }));
    pair.run(5s);
    const std::size_t sessions = pair.ground().all<SessionUp>().size();
    const std::vector<SuiteId> suites = defaultSuites();
    std::size_t step = 0;
    for (const Side side : {Ground, Air}) {
        pair.every(side == Ground ? Duration(1100ms) : Duration(1300ms), [&, side] {
            auto &end = pair.ends[side];
            const SuiteId next = suites[++step % suites.size()];
            if (end.up() && !end.sessionInfo()->pending && crypto::suiteAvailable(next))
                end.switchSuite(pair.now, next);
        });
    }
    pair.run(std::chrono::seconds(5) * wanted, [&] { return pair.ground().switches() >= wanted; });
    pair.stopTraffic();
    pair.run(20s);
    HOLDS(pair.accountFrom(Air).empty() && pair.accountFrom(Ground).empty(), "a switch loses nothing and repeats nothing");
    QVERIFY2(pair.ground().switches() >= wanted, qPrintable(QString::number(pair.ground().switches())));
    QCOMPARE(pair.ground().switches(), pair.air().switches());
    QCOMPARE(pair.ground().all<SessionUp>().size(), sessions); // over this link two may have come up at the start
}

void AttackSwitchTest::acceptancesAreDropped()
{
    // The agent accepts, and none of its messages reaches the station for six seconds: both continue under the old epoch.
    Pair pair(attackOptions());
    trafficOfBoth(pair);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) { return flight.from == Ground || flight.tag != 0; };
    pair.ground().switchSuite(pair.now, SuiteId::Aes256Gcm);
    pair.run(6s);
    pair.link.attacker = nullptr;
    pair.run(10s);
    pair.stopTraffic();
    pair.run(2s);
    HOLDS(pair.accountFrom(Air).empty() && pair.accountFrom(Ground).empty(), "a switch loses nothing and repeats nothing");
    QCOMPARE(pair.ground().switches(), 0u);
    QCOMPARE(pair.ground().all<SwitchDone>().size(), 1u);
}

void AttackSwitchTest::proposalFlood()
{
    // A peer proposes again and again under its own keys; each proposal asks for two X25519 computations.
    Pair pair(attackOptions());
    Tap tap(pair);
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    const StolenSession station(pair, tap, kAttackSeed, SuiteId::ChaCha20Poly1305);
    tap.flights.clear();
    crypto::PublicKey key{};
    key[0] = 9;
    for (std::uint32_t i = 1; i <= 500; ++i)
        offer(pair, Air, station.seal(Ground, 1000 + i, Propose{ProposalId{i}, Epoch{1}, SuiteId::ChaCha20Poly1305, key}));
    pair.pump();
    std::set<crypto::PublicKey> answers;
    for (const SentDatagram &flight : tap.ofKind(0x50)) {
        if (const auto acceptance = station.newest<Accept>({flight}))
            answers.insert(acceptance->key);
    }
    QVERIFY(answers.size() >= 20);
    HOLDS(answers.size() <= 21, "at most fifty proposals a second are computed on");
}

SKYSEAL_TEST(AttackSwitchTest)
#include "attack_switch_test.moc"
