// The age of a stage of a sweep, and the end of the patience with it.
#include "core/experiment/stage_timer.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal::experiment;

class StageTimerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void patienceEnds();
    void ageIsThatOfSnapshots();
};

namespace {

enum class Stage : std::uint8_t { Idle, Closing, Connecting, Settling, Beginning };

} // namespace

void StageTimerTest::patienceEnds()
{
    StageTimer<Stage> timer;
    QVERIFY(timer.is(Stage::Idle));
    QVERIFY(!timer.isOverdue(1e9));
    timer.enter(Stage::Connecting, std::chrono::seconds(20), 100, 0);
    QVERIFY(!timer.isOverdue(119.9));
    QVERIFY(timer.isOverdue(120));
    timer.enter(Stage::Settling, std::chrono::seconds(20), 119, 0);
    QVERIFY(!timer.isOverdue(138.9));
    QVERIFY(timer.isOverdue(139));
    timer.enterUnlimited(Stage::Closing);
    QVERIFY(timer.is(Stage::Closing));
    QVERIFY(!timer.isOverdue(1e9));
}

void StageTimerTest::ageIsThatOfSnapshots()
{
    StageTimer<Stage> timer;
    timer.enter(Stage::Beginning, std::chrono::seconds(10), 100, 30);
    QCOMPARE(timer.age(32.5), 2.5);
    QVERIFY(timer.age(29.9) < 0); // taken before the stage began
}

SKYSEAL_TEST_APPLESS(StageTimerTest)
#include "stage_timer_test.moc"
