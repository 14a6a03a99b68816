#include "tests/support/test_runner.h"

#include <cstdio>
#include <map>
#include <string>
#include <string_view>

namespace skyseal::test {

namespace {

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

} // namespace

TestEntry::TestEntry(const char *sourceFile, TestMain main)
{
    entries().emplace(baseName(sourceFile), main);
}

} // namespace skyseal::test

/// The first argument names the class, unless the program has only one. The class sees the remaining arguments.
int main(int argc, char **argv)
{
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
    return 2;
}
