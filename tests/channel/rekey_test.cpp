// Fresh keys by count and age, the hard limit, and the end of old keys, with lowered limits.
#include "core/crypto/init_crypto.h"
#include "pair.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;
using crypto::SuiteId;

class RekeyTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void rekeyByRecordsOfEitherEnd();
    void rekeyByAgeOncePerTerm();
    void rekeyOnCommand();
    void rekeyBySwitchingToTheSuiteInUse();
    void hardStopExactlyThere();
    void sessionComesBackAfterHardStop();
    void sixteenEpochsAreRemembered();
    void policyThatForbidsTheSuiteInUse();
};

namespace {

std::size_t rekeys(const Pair::End &end)
{
    std::size_t count = 0;
    for (const SwitchDone &done : end.all<SwitchDone>())
        count += done.rekey && done.failure == SwitchFailure::None;
    return count;
}

} // namespace

void RekeyTest::rekeyByRecordsOfEitherEnd()
{
    for (const Side busy : {Ground, Air}) {
        PairOptions options;
        options.timing.rekeyAfterRecords = 1000;
        options.link.delay = 10ms;
        options.link.jitter = 20ms;
        options.link.loss = 0.05;
        Pair pair(options);
        QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
        pair.every(5ms, [&] { pair.sendFrame(busy); });
        pair.run(60s);
        pair.stopTraffic();
        pair.run(5s);
        const auto count = rekeys(pair.ground());
        QVERIFY2(count >= 8 && count <= 12, qPrintable(QString::number(count)));
        QCOMPARE(count, rekeys(pair.air()));
        QCOMPARE(QString::fromStdString(pair.accountFrom(busy)), QString());
        const auto stats = pair.ends[busy].stats();
        for (const EpochStats &epoch : stats->epochs)
            QVERIFY2(epoch.tx.records < 1400, qPrintable(QString::number(epoch.tx.records)));
    }
}

void RekeyTest::rekeyByAgeOncePerTerm()
{
    Pair pair;
    QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
    pair.run(1h);
    QCOMPARE(rekeys(pair.ground()), 5u); // Every 600 s; the sixth is just due.
    QCOMPARE(rekeys(pair.air()), rekeys(pair.ground()));
    for (const SwitchDone &done : pair.ground().all<SwitchDone>())
        QVERIFY(done.failure == SwitchFailure::None && !done.byPeer);
    QCOMPARE(pair.ground().all<SessionUp>().size(), 1u);
}

void RekeyTest::rekeyOnCommand()
{
    Pair pair;
    QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    pair.air().rekey(pair.now);
    pair.run(1s);
    QCOMPARE(rekeys(pair.ground()), 1u);
    QVERIFY(pair.ground().all<SwitchDone>()[0].byPeer && pair.ground().all<SwitchDone>()[0].rekey);
    QCOMPARE(pair.ground().sessionInfo()->epoch, Epoch{1});
}

void RekeyTest::rekeyBySwitchingToTheSuiteInUse()
{
    // As requested from the window.
    Pair pair;
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    pair.ground().switchSuite(pair.now, SuiteId::ChaCha20Poly1305);
    QVERIFY(pair.run(1s, [&] { return rekeys(pair.ground()) == 1 && rekeys(pair.air()) == 1; }));
    for (const auto &end : pair.ends)
        QCOMPARE(end.sessionInfo()->epoch, Epoch{1});
}

void RekeyTest::hardStopExactlyThere()
{
    PairOptions options;
    options.timing.rekeyAfterRecords = 1u << 22; // not reached in this test
    options.timing.hardStopRecords = 5000;
    Pair pair(options);
    QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    const Bytes frame(20, 0xfd);
    Bytes record(100);
    const auto before = pair.air().stats()->tx.records;
    std::uint64_t sealed = 0;
    for (;; ++sealed) {
        const auto result = pair.air().seal(pair.now, frame, record);
        if (!result) {
            QCOMPARE(result.error(), SealError::Exhausted);
            break;
        }
    }
    QCOMPARE(before + sealed, std::uint64_t(5000));
    QVERIFY(!pair.air().seal(pair.now, frame, record));
    pair.pump();
    QCOMPARE(pair.air().all<SessionDown>().at(0).reason, DownReason::Exhausted);
}

void RekeyTest::sessionComesBackAfterHardStop()
{
    PairOptions options;
    options.timing.hardStopRecords = 500;
    for (const Side busy : {Ground, Air}) {
        Pair pair(options);
        QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
        pair.every(10ms, [&] { pair.sendFrame(busy); });
        pair.run(30s);
        // The other end notices each one by silence, so there are several, and none blocks.
        QVERIFY(pair.ends[busy].all<SessionUp>().size() >= 4);
        QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
    }
}

void RekeyTest::sixteenEpochsAreRemembered()
{
    Pair pair;
    QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    for (int i = 0; i < 40; ++i) {
        pair.sendFrame(Air);
        pair.ground().rekey(pair.now);
        pair.run(200ms);
    }
    pair.run(2s);
    for (const auto &end : pair.ends) {
        const auto stats = end.stats();
        QCOMPARE(stats->epochs.size(), 16u);
        QCOMPARE(stats->epochs.back().epoch, Epoch{40});
        QCOMPARE(stats->epochs.front().epoch, Epoch{25});
    }
    // Sums go over all of them.
    const auto air = pair.air().stats();
    const auto ground = pair.ground().stats();
    QCOMPARE(ground->rx.good, air->tx.records);
    QCOMPARE(ground->rx.lost, std::uint64_t(0));
}

void RekeyTest::policyThatForbidsTheSuiteInUse()
{
    Pair pair;
    QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
    pair.run(1s);
    pair.air().setPolicy(pair.now, {{SuiteId::Aes256Ctr, SuiteId::Aes256Gcm}, false, false});
    pair.run(2s);
    // The initiator's order stands, also here.
    QCOMPARE(pair.ground().sessionInfo()->suite, SuiteId::Aes256Gcm);
}

SKYSEAL_TEST(RekeyTest)
#include "rekey_test.moc"
