// The entry points of QtTest classes. All test classes of a folder are linked into one program, which runs one class per
// process: `channel_tests session_test [options and functions of QtTest]`, or `… session_test -without FUNCTION` for all other
// functions. The program exits with 77 if nothing failed but something was skipped for a requirement (requirements.h). Use
// these macros instead of QTEST_MAIN and its variants, once at the end of the source file. The files of a folder may be
// compiled as one (skyseal_unite() in cmake/SkysealTargets.cmake), so that their helpers need names of their own, or a header.
#pragma once

#include <QtTest/QTest>

namespace skyseal::test {

using TestMain = int (*)(int argc, char **argv);

/// Adds a test class to the program. Its name on the command line is the base name of its source file.
struct TestEntry
{
    TestEntry(const char *sourceFile, TestMain main);
};

/// Runs a test class with these arguments. Returns the exit status of the program.
int runTest(QObject &test, int argc, char **argv);

} // namespace skyseal::test

#define SKYSEAL_TEST_ENTRY(Class, ...)                                                                                         \
    static const ::skyseal::test::TestEntry kTestEntryOf##Class(__FILE__, [](int argc, char **argv) {                          \
        __VA_ARGS__                                                                                                            \
        Class test;                                                                                                            \
        return ::skyseal::test::runTest(test, argc, argv);                                                                     \
    });

/// Runs the class under a QCoreApplication.
#define SKYSEAL_TEST(Class) SKYSEAL_TEST_ENTRY(Class, QCoreApplication application(argc, argv);)

/// Runs the class without an application object.
#define SKYSEAL_TEST_APPLESS(Class) SKYSEAL_TEST_ENTRY(Class)

/// Runs the class under a QApplication, at 96 dots per inch.
#define SKYSEAL_TEST_WIDGETS(Class)                                                                                            \
    SKYSEAL_TEST_ENTRY(Class, QApplication application(argc, argv); application.setAttribute(Qt::AA_Use96Dpi, true);)
