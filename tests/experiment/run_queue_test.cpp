// The runs of a sweep one after the other: positions, blocks and the estimate of the time that is left.
#include "core/experiment/run_queue.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::experiment;
using namespace std::chrono_literals;

class RunQueueTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void blocksBeginWithEachLoad()
    {
        Plan plan;
        plan.arms = {{crypto::SuiteId::Aes256Gcm}, {crypto::SuiteId::Aes256Ctr}};
        plan.loads = {Load::Natural, Load::Saturated};
        plan.repeats = 2;
        RunQueue queue(plan);
        QCOMPARE(queue.size(), std::size_t(8));
        for (std::size_t i = 0; i < queue.size(); ++i) {
            QVERIFY(!queue.atEnd());
            QCOMPARE(queue.position(), i);
            QCOMPARE(queue.atBlockStart(), i % 4 == 0);
            QCOMPARE(queue.current().load, i / 4);
            queue.finishRun(static_cast<double>(i));
        }
        QVERIFY(queue.atEnd());
        QCOMPARE(queue.remaining(), 0.0);
    }

    void blocksBeginWithEachLaunch()
    {
        Plan plan;
        plan.arms = {{crypto::SuiteId::Aes256Gcm}, {crypto::SuiteId::Aes256Ctr}};
        plan.launches = 3;
        plan.repeats = 1;
        RunQueue queue(plan);
        QCOMPARE(queue.size(), std::size_t(6));
        for (std::size_t i = 0; i < queue.size(); ++i) {
            QCOMPARE(queue.atBlockStart(), i % 2 == 0);
            queue.finishRun(static_cast<double>(i));
        }
    }

    void startOfABlockIsEstimatedForTheNext()
    {
        Plan plan;
        plan.arms = {{crypto::SuiteId::Aes256Gcm}};
        plan.loads = {Load::Natural, Load::Saturated};
        plan.repeats = 2;
        plan.measure = 1s;
        plan.warmUp = 500ms;
        RunQueue queue(plan);
        QCOMPARE(queue.remaining(), 4 * 1.7);
        queue.finishRun(10); // with the start of the programs
        queue.finishRun(12);
        QCOMPARE(queue.remaining(), 2 * 2.0 + 8);
        queue.finishRun(22);
        QCOMPARE(queue.remaining(), 2.0);
    }
};

SKYSEAL_TEST(RunQueueTest)
#include "run_queue_test.moc"
