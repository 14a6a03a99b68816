// An agent that cannot store the counters of handshakes: sessions go on, and its stations learn of it.
#include "core/crypto/init_crypto.h"
#include "tests/channel/pair.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;

class StorageReportTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void stationLearnsOfIt();
    void newSessionsComeUp();
    void stationDoesNotReportIts();
};

void StorageReportTest::stationLearnsOfIt()
{
    Pair pair;
    pair.start(Ground);
    pair.start(Air);
    QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
    pair.every(100ms, [&] { pair.sendFrame(Air), pair.sendFrame(Ground); });
    pair.run(5s);
    QVERIFY(pair.ground().all<PeerStorageChanged>().empty());
    pair.air().counters.trouble = "the disk is full";
    QVERIFY(pair.run(2s, [&] { return !pair.ground().all<PeerStorageChanged>().empty(); }));
    QVERIFY(pair.ground().all<PeerStorageChanged>().front().failed);
    QVERIFY(pair.ground().stats()->peerCannotStore);
    pair.run(60s);
    QCOMPARE(pair.ground().all<PeerStorageChanged>().size(), std::size_t(1)); // once
    pair.air().counters.trouble.clear();
    QVERIFY(pair.run(2s, [&] { return pair.ground().all<PeerStorageChanged>().size() == 2; }));
    QVERIFY(!pair.ground().all<PeerStorageChanged>().back().failed);
    QVERIFY(!pair.ground().stats()->peerCannotStore);
    QCOMPARE(pair.accountFrom(Air) + pair.accountFrom(Ground), std::string());
}

void StorageReportTest::newSessionsComeUp()
{
    Pair pair;
    pair.air().counters.trouble = "the disk does not answer";
    pair.start(Ground);
    pair.start(Air);
    for (std::size_t session = 1; session <= 5; ++session) {
        QVERIFY(pair.run(5s, [&] { return pair.ground().all<SessionUp>().size() == session && pair.bothUp(); }));
        QVERIFY(pair.run(2s, [&] { return pair.ground().all<PeerStorageChanged>().size() == session; }));
        pair.kill(Ground);
        pair.start(Ground);
    }
}

void StorageReportTest::stationDoesNotReportIts()
{
    Pair pair;
    pair.ground().counters.trouble = "the disk is full";
    pair.start(Ground);
    pair.start(Air);
    QVERIFY(pair.run(5s, [&] { return pair.bothUp(); }));
    pair.run(5s);
    QVERIFY(pair.air().all<PeerStorageChanged>().empty());
    QVERIFY(pair.ground().all<PeerStorageChanged>().empty());
}

SKYSEAL_TEST(StorageReportTest)
#include "storage_report_test.moc"
