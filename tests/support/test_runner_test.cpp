// The exit status of test programs, by which ctest tells skips from passes and failures, and the functions that they leave out.
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

using namespace skyseal::test;

namespace {

RunResult runMixedOutcomes(const char *arguments)
{
    return runToItsEnd(QCoreApplication::applicationFilePath(), words("mixed_outcomes") + words(arguments));
}

} // namespace

class TestRunnerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { qunsetenv("SKYSEAL_MAVPROXY"); } // a requirement that is not met
    void statusTellsTheOutcome_data();
    void statusTellsTheOutcome();
    void otherFunctionsRun();
    void unknownFunctionIsNoTest();
};

void TestRunnerTest::statusTellsTheOutcome_data()
{
    QTest::addColumn<QByteArray>("arguments");
    QTest::addColumn<int>("status");
    QTest::newRow("a pass") << QByteArray("passes") << 0;
    QTest::newRow("a skipped row") << QByteArray("passes skipsARow") << 77;
    QTest::newRow("the other row") << QByteArray("skipsARow:passes") << 0;
    QTest::newRow("a skip without a requirement") << QByteArray("passes skipsWithoutARequirement") << 1;
    QTest::newRow("a failure beside skips") << QByteArray() << 1;
    QTest::newRow("without the failure") << QByteArray("-without fails") << 77;
    QTest::newRow("without a failure and skips")
        << QByteArray("-without fails -without skipsARow -without skipsWithoutARequirement") << 0;
}

void TestRunnerTest::statusTellsTheOutcome()
{
    QFETCH(QByteArray, arguments);
    QFETCH(int, status);
    const RunResult run = runMixedOutcomes(arguments.constData());
    QVERIFY2(run.status == status, run.out.constData());
}

void TestRunnerTest::otherFunctionsRun()
{
    const RunResult run = runMixedOutcomes("-without skipsARow -without skipsWithoutARequirement");
    QVERIFY2(run.out.contains("PASS   : MixedOutcomes::passes()"), run.out.constData());
    QVERIFY2(run.out.contains("FAIL!  : MixedOutcomes::fails()"), run.out.constData());
    QVERIFY2(!run.out.contains("::skips"), run.out.constData());
}

void TestRunnerTest::unknownFunctionIsNoTest()
{
    const RunResult run = runMixedOutcomes("-without flies");
    QCOMPARE(run.status, 2);
    QCOMPARE(run.err, QByteArray("-without flies: MixedOutcomes has no such function\n"));
    QCOMPARE(run.out, QByteArray());
}

SKYSEAL_TEST(TestRunnerTest)
#include "test_runner_test.moc"
