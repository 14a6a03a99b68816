// Waiting for a condition in tests with real sockets, threads, programs and windows. The deadline only ends a test that hangs;
// it is no claim about the speed of the product. Protocol times are tested on a simulated clock.
#pragma once

#include <QtCore/QtGlobal>
#include <QtTest/QTest>

namespace skyseal::test {

/// Half in a weakened program, where attacks succeed, so that some conditions never become true.
inline const int kDeadlineMs = qEnvironmentVariableIsSet("SKYSEAL_WEAKNESS") ? 30'000 : 60'000;

/// Runs the event loop until the condition is true. Returns false at the deadline.
template<typename Condition> [[nodiscard]] bool eventually(Condition condition)
{
    return QTest::qWaitFor(condition, kDeadlineMs);
}

} // namespace skyseal::test

/// QVERIFY of a condition that becomes true while the event loop runs.
#define EVENTUALLY(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, ::skyseal::test::kDeadlineMs)
#define EVENTUALLY2(condition, message) QTRY_VERIFY2_WITH_TIMEOUT(condition, message, ::skyseal::test::kDeadlineMs)
/// QCOMPARE of a value that becomes the expected one while the event loop runs.
#define EVENTUALLY_EQUAL(actual, expected) QTRY_COMPARE_WITH_TIMEOUT(actual, expected, ::skyseal::test::kDeadlineMs)
