// Waiting for a condition in tests with real sockets, threads, programs and windows. The deadline only ends a test that hangs;
// it is no claim about the speed of the product. Protocol times are tested on a simulated clock.
#pragma once

#include <QtTest/QTest>

namespace skyseal::test {

#ifdef SKYSEAL_WEAKEN
inline constexpr int kDeadlineMs = 30'000; // there attacks succeed, so that some conditions never become true
#else
inline constexpr int kDeadlineMs = 60'000;
#endif

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
