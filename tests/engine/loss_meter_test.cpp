// The meters that turn growing counters into recent rates.
#include "core/engine/common/loss_meter.h"
#include "core/engine/station/overhead_meter.h"
#include "core/engine/station/replay_meter.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal::engine;

class LossMeterTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void startsAtTheFirstReading();
    void looksBackOneWindow();
    void lateRecordsAreNotLost();
    void overheadIsRelativeToTheFrames();
    void replaysCountWhileTheyOutnumberGoodRecords();
};

void LossMeterTest::startsAtTheFirstReading()
{
    LossMeter meter;
    QCOMPARE(meter.percent(), 0.0);
    meter.note(1000, 500); // the past of a session that was up before
    QCOMPARE(meter.percent(), 0.0);
    meter.note(1030, 510);
    QCOMPARE(meter.percent(), 25.0);
}

void LossMeterTest::looksBackOneWindow()
{
    LossMeter meter;
    meter.note(0, 0);
    meter.note(10, 10);
    QCOMPARE(meter.percent(), 50.0);
    for (int i = 2; i <= 5; ++i)
        meter.note(10u * static_cast<unsigned>(i), 10);
    QCOMPARE(meter.percent(), 0.0);
}

void LossMeterTest::lateRecordsAreNotLost()
{
    Growth<4> growth;
    growth.note(10);
    growth.note(8);
    QCOMPARE(growth.value(), -2);
    LossMeter meter;
    meter.note(0, 10);
    meter.note(10, 8);
    QCOMPARE(meter.percent(), 0.0);
}

void LossMeterTest::overheadIsRelativeToTheFrames()
{
    OverheadMeter meter;
    QVERIFY(!meter.percent());
    meter.note(5000, 100); // counters of earlier traffic
    meter.note(5000, 100);
    QVERIFY(!meter.percent()); // no frames since then
    meter.note(5125, 200);
    QCOMPARE(meter.percent().value(), 25.0);
    for (int i = 0; i < 4; ++i)
        meter.note(5125, 200);
    QVERIFY(!meter.percent()); // the traffic is older than the window
}

void LossMeterTest::replaysCountWhileTheyOutnumberGoodRecords()
{
    ReplayMeter meter;
    meter.note(100, 0);
    meter.note(120, 20); // a network that delivers each datagram twice
    QCOMPARE(meter.attacking(), std::uint64_t(0));
    meter.note(121, 60);
    QCOMPARE(meter.attacking(), std::uint64_t(40));
    meter.note(221, 70); // good records outnumber the replays again
    QCOMPARE(meter.attacking(), std::uint64_t(40));
}

SKYSEAL_TEST(LossMeterTest)
#include "loss_meter_test.moc"
