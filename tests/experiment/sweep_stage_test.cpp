// The age of a stage of a sweep, and the end of the patience with it.
#include "core/experiment/sweep_stage.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal::experiment;

class SweepStageTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void patienceEnds();
    void ageIsThatOfSnapshots();
};

void SweepStageTest::patienceEnds()
{
    StageTimer timer;
    QVERIFY(timer.is(SweepStage::Idle));
    QVERIFY(!timer.isOverdue(1e9));
    timer.enter(SweepStage::Connecting, std::chrono::seconds(20), 100, 0);
    QVERIFY(!timer.isOverdue(119.9));
    QVERIFY(timer.isOverdue(120));
    timer.enter(SweepStage::Settling, std::chrono::seconds(20), 119, 0);
    QVERIFY(!timer.isOverdue(138.9));
    QVERIFY(timer.isOverdue(139));
    timer.enterUnlimited(SweepStage::Closing);
    QVERIFY(timer.is(SweepStage::Closing));
    QVERIFY(!timer.isOverdue(1e9));
}

void SweepStageTest::ageIsThatOfSnapshots()
{
    StageTimer timer;
    timer.enter(SweepStage::Beginning, std::chrono::seconds(10), 100, 30);
    QCOMPARE(timer.age(32.5), 2.5);
    QVERIFY(timer.age(29.9) < 0); // taken before the stage began
}

SKYSEAL_TEST_APPLESS(SweepStageTest)
#include "sweep_stage_test.moc"
