#include "tests/support/test_runner.h"

#include "tests/support/requirements.h"

#include <QtCore/QMetaMethod>

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// QtTest keeps the number of skips to itself: the class is declared in its private header qtestlog_p.h, which Debian's
/// qt6-base-dev lacks, but its functions are exported. If a later Qt has no such function, linking fails.
class QTestLog
{
public:
    static int skipCount();
};

namespace skyseal::test {

namespace {

constexpr int kSkipped = 77; ///< SKIP_RETURN_CODE in cmake/SkysealTargets.cmake
constexpr int kFailed = 1;
constexpr int kUsage = 2;

/// A function-local object, because the entries register themselves before main().
std::map<std::string, TestMain, std::less<>> &entries()
{
    static std::map<std::string, TestMain, std::less<>> all;
    return all;
}

std::string_view baseName(std::string_view path)
{
    path.remove_prefix(path.rfind('/') + 1); // npos + 1 is 0
    return path.substr(0, path.rfind('.'));
}

/// The functions that QtTest runs: private slots without parameters that neither prepare nor supply data.
std::vector<std::string> testFunctions(const QMetaObject &type)
{
    std::vector<std::string> out;
    for (int i = 0; i < type.methodCount(); ++i) {
        const QMetaMethod method = type.method(i);
        const QByteArray name = method.name();
        if (method.methodType() == QMetaMethod::Slot && method.access() == QMetaMethod::Private && method.parameterCount() == 0
            && !name.endsWith("_data") && name != "initTestCase" && name != "cleanupTestCase" && name != "init"
            && name != "cleanup")
            out.push_back(name.toStdString());
    }
    return out;
}

} // namespace

TestEntry::TestEntry(const char *sourceFile, TestMain main)
{
    entries().emplace(baseName(sourceFile), main);
}

int runTest(QObject &test, int argc, char **argv)
{
    std::vector<std::string> functions = testFunctions(*test.metaObject());
    std::vector<char *> arguments;
    bool runsAll = true;
    for (int i = 0; i < argc; ++i) {
        if (argv[i] != std::string_view("-without")) {
            arguments.push_back(argv[i]);
            continue;
        }
        runsAll = false;
        if (++i == argc || std::erase(functions, argv[i]) == 0) {
            std::fprintf(stderr, "-without %s: %s has no such function\n", i < argc ? argv[i] : "",
                         test.metaObject()->className());
            return kUsage;
        }
    }
    if (!runsAll) {
        for (std::string &function : functions)
            arguments.push_back(function.data());
    }
    const int failures = QTest::qExec(&test, static_cast<int>(arguments.size()), arguments.data());
    if (failures > 0 || QTestLog::skipCount() == 0)
        return failures == kSkipped ? kSkipped + 1 : failures;
    if (isSomethingMissing())
        return kSkipped;
    std::fprintf(stderr, "%s skips without a requirement (tests/support/requirements.h)\n", test.metaObject()->className());
    return kFailed;
}

} // namespace skyseal::test

/// The first argument names the class, unless the program has only one. The class sees the remaining arguments.
int main(int argc, char **argv)
{
    // The locale of the environment, as QCoreApplication sets it in every program, also for classes without such an object. A
    // test entry that names a locale of its own (LOCPATH, tests/CMakeLists.txt) must not run without it.
    if (!std::setlocale(LC_ALL, "") && std::getenv("LOCPATH")) {
        std::fprintf(stderr, "%s has no such locale\n", std::getenv("LOCPATH"));
        return 2;
    }
    const auto &all = skyseal::test::entries();
    if (argc > 1) {
        if (const auto found = all.find(std::string_view(argv[1])); found != all.end()) {
            argv[1] = argv[0];
            return found->second(argc - 1, argv + 1);
        }
    }
    if (all.size() == 1)
        return all.begin()->second(argc, argv);
    std::fprintf(stderr, "usage: %s CLASS [options and functions of QtTest]; the classes are\n", argv[0]);
    for (const auto &entry : all)
        std::fprintf(stderr, "  %s\n", entry.first.c_str());
    return skyseal::test::kUsage;
}
