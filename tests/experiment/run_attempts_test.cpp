// How often a run is measured, and when failed runs mean that the link is lost.
#include "core/experiment/run_attempts.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal::experiment;

namespace {

/// Measures a run that is never valid; returns its attempts.
unsigned measureInvalidRun(RunAttempts &attempts, bool isFirstOfBlock)
{
    attempts.beginRun(isFirstOfBlock);
    while (attempts.mayRepeat())
        attempts.repeat();
    attempts.runMeasured(false);
    return attempts.count();
}

} // namespace

class RunAttemptsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void invalidRunsAreRepeated();
    void aLoadThatIsNeverReachedIsTriedOnce();
    void failedRunsInARow();
};

void RunAttemptsTest::invalidRunsAreRepeated()
{
    RunAttempts attempts;
    QCOMPARE(measureInvalidRun(attempts, true), RunAttempts::kMost);
}

void RunAttemptsTest::aLoadThatIsNeverReachedIsTriedOnce()
{
    RunAttempts attempts;
    measureInvalidRun(attempts, true);
    QCOMPARE(measureInvalidRun(attempts, false), 1u);
    QCOMPARE(measureInvalidRun(attempts, true), RunAttempts::kMost); // another load
    attempts.beginRun(false);
    attempts.runMeasured(true);
    QCOMPARE(measureInvalidRun(attempts, false), RunAttempts::kMost);
}

void RunAttemptsTest::failedRunsInARow()
{
    RunAttempts attempts;
    for (unsigned i = 1; i < RunAttempts::kMostFailedRuns; ++i)
        attempts.runFailed();
    QVERIFY(!attempts.isLinkLost());
    attempts.runMeasured(false);
    for (unsigned i = 1; i < RunAttempts::kMostFailedRuns; ++i)
        attempts.runFailed();
    QVERIFY(!attempts.isLinkLost());
    attempts.runFailed();
    QVERIFY(attempts.isLinkLost());
}

SKYSEAL_TEST_APPLESS(RunAttemptsTest)
#include "run_attempts_test.moc"
