// Locked memory: a failure is reported once, and the program goes on. (Which keys are locked: channel/attack_memory_test.)
#include "core/base/locked_memory.h"
#include "core/base/secret_bytes.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <array>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace skyseal;

namespace {

int g_reports = 0;

void countReport(int error)
{
    g_reports += error != 0;
}

/// Runs `attempt` in a child process that may lock no memory. Returns its exit status; 100 if it could not be restricted.
template<typename Attempt> int whereNothingMayBeLocked(Attempt &&attempt)
{
    const pid_t child = ::fork();
    if (child == 0) {
        const rlimit none{0, 0};
        // Root may lock regardless of the limit.
        const bool restricted = ::setrlimit(RLIMIT_MEMLOCK, &none) == 0 && (::geteuid() != 0 || ::setuid(65534) == 0);
        ::_exit(restricted ? attempt() : 100);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace

class LockedMemoryTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void failureIsReportedOnce();
    void failureBeforeTheReportIsSet();
    void nothingIsReportedOnSuccess();
    void sharedSecretIsMoved();
};

void LockedMemoryTest::failureIsReportedOnce()
{
    const int reports = whereNothingMayBeLocked([] {
        reportLockFailure(countReport);
        for (int i = 0; i < 3; ++i) {
            const auto key = shareInLockedMemory(Key32());
            if (!key->isZero())
                return 101;
        }
        return g_reports;
    });
    QCOMPARE(reports, 1);
}

void LockedMemoryTest::failureBeforeTheReportIsSet()
{
    const int reports = whereNothingMayBeLocked([] {
        const auto key = shareInLockedMemory(Key32());
        reportLockFailure(countReport);
        return g_reports;
    });
    QCOMPARE(reports, 1);
}

void LockedMemoryTest::nothingIsReportedOnSuccess()
{
    reportLockFailure(countReport);
    const auto key = shareInLockedMemory(Key32());
    QCOMPARE(g_reports, 0);
}

void LockedMemoryTest::sharedSecretIsMoved()
{
    std::array<std::uint8_t, 32> bytes{};
    bytes.fill(7);
    Key32 key{std::span<const std::uint8_t, 32>(bytes)};
    const auto shared = shareInLockedMemory(std::move(key));
    QCOMPARE(shared->view()[31], std::uint8_t(7));
}

SKYSEAL_TEST_APPLESS(LockedMemoryTest)
#include "locked_memory_test.moc"
