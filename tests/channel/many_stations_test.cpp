// One agent and several stations on one link, as behind a router or at a listening port: the first station does not keep the
// others out, and an active session costs few announcements.
#include "core/crypto/init_crypto.h"
#include "crowd.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::channel;
using namespace skyseal::test;
using namespace std::chrono_literals;

class ManyStationsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void firstStationDoesNotBlockOthers();
    void activeSessionsNeedFewAnnouncements();
    void restartedStationIsBackSoon();
};

void ManyStationsTest::initTestCase()
{
    QVERIFY(crypto::initCrypto());
}

void ManyStationsTest::firstStationDoesNotBlockOthers()
{
    Crowd crowd(2);
    crowd.start(0);
    QVERIFY(crowd.run(1s, [&] { return crowd.up(0); }));
    crowd.run(30s);
    crowd.start(1);
    QVERIFY(crowd.run(3s, [&] { return crowd.up(1); }));
    crowd.run(30s);
    QVERIFY(crowd.up(0) && crowd.up(1));
    QCOMPARE(crowd.events(0).size(), std::size_t(1)); // up, and undisturbed since
    QCOMPARE(crowd.events(1).size(), std::size_t(1));
}

void ManyStationsTest::activeSessionsNeedFewAnnouncements()
{
    Crowd crowd(2);
    const int alone = crowd.announcementsIn(10s);
    QVERIFY2(alone >= 19 && alone <= 21, qPrintable(QString::number(alone)));
    crowd.start(0);
    QVERIFY(crowd.run(1s, [&] { return crowd.up(0); }));
    const int beside = crowd.announcementsIn(20s);
    QVERIFY2(beside >= 9 && beside <= 11, qPrintable(QString::number(beside)));
    crowd.start(1);
    QVERIFY(crowd.run(3s, [&] { return crowd.up(1); }));
    crowd.run(1s); // the last one's report
    QCOMPARE(crowd.announcementsIn(60s), 0);
}

void ManyStationsTest::restartedStationIsBackSoon()
{
    for (const bool elsewhere : {false, true}) {
        Crowd crowd(3);
        for (const std::size_t station : {0, 1})
            crowd.start(station);
        QVERIFY(crowd.run(3s, [&] { return crowd.up(0) && crowd.up(1); }));
        crowd.kill(1);
        crowd.run(100ms);
        if (elsewhere)
            crowd.move(1);
        crowd.start(1);
        QVERIFY(crowd.run(3s, [&] { return crowd.up(1); }));
        QCOMPARE(crowd.events(0).size(), std::size_t(1));
    }
}

SKYSEAL_TEST_APPLESS(ManyStationsTest)
#include "many_stations_test.moc"
