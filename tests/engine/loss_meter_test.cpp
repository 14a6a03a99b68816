#include "core/engine/common/loss_meter.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal::engine;

class LossMeterTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void startsAtTheFirstReading();
    void looksBackOneWindow();
    void takesBackWhatCameLate();
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

void LossMeterTest::takesBackWhatCameLate()
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

SKYSEAL_TEST(LossMeterTest)
#include "loss_meter_test.moc"
