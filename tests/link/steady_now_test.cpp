// The clock of the program counts the time while the machine was suspended, and never steps with the time of day.
#include "core/link/steady_now.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <sys/syscall.h>
#include <unistd.h>

using namespace skyseal;

namespace {

time_t suspended = 0, timeOfDayStep = 0;

} // namespace

/// In place of the one of the C library: a machine that was suspended, and whose time of day was set.
extern "C" int clock_gettime(clockid_t clock, timespec *out) noexcept
{
    const auto status = static_cast<int>(::syscall(SYS_clock_gettime, clock, out));
    if (clock == CLOCK_BOOTTIME)
        out->tv_sec += suspended;
    if (clock == CLOCK_REALTIME)
        out->tv_sec += timeOfDayStep;
    return status;
}

class SteadyNowTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { suspended = timeOfDayStep = 0; }
    void countsTheTimeOfASuspendedMachine();
    void doesNotStepWithTheTimeOfDay();
};

void SteadyNowTest::countsTheTimeOfASuspendedMachine()
{
    const TimePoint before = steadyNow();
    suspended = 3600;
    QVERIFY(steadyNow() - before >= std::chrono::hours(1));
}

void SteadyNowTest::doesNotStepWithTheTimeOfDay()
{
    const TimePoint before = steadyNow();
    const WallTime wallBefore = wallNow();
    timeOfDayStep = -3600;
    QVERIFY(wallNow() < wallBefore);
    QVERIFY(steadyNow() >= before);
}

SKYSEAL_TEST(SteadyNowTest)
#include "steady_now_test.moc"
