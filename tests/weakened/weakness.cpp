#include "tests/weakened/weakness.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#if __has_include(<valgrind/memcheck.h>)
#include <valgrind/memcheck.h>
#else
#define VALGRIND_MAKE_MEM_DEFINED(bytes, count) (static_cast<void>(bytes), static_cast<void>(count))
#endif

namespace skyseal {

namespace {

std::vector<std::string_view> split(std::string_view names)
{
    std::vector<std::string_view> out;
    while (!names.empty()) {
        const std::size_t end = std::min(names.find(','), names.size());
        out.push_back(names.substr(0, end));
        names.remove_prefix(std::min(end + 1, names.size()));
    }
    return out;
}

std::vector<std::string_view> selected()
{
    const std::vector<std::string_view> patches = split(SKYSEAL_WEAKNESSES);
    const char *names = std::getenv("SKYSEAL_WEAKNESS");
    std::vector<std::string_view> out = split(names ? names : "");
    for (const std::string_view name : out) {
        if (std::find(patches.begin(), patches.end(), name) == patches.end()) {
            std::fprintf(stderr, "no weakness is called '%.*s'\n", static_cast<int>(name.size()), name.data());
            std::abort();
        }
    }
    return out;
}

} // namespace

bool weakened(const char *weakness)
{
    static const std::vector<std::string_view> kSelected = selected();
    return std::find(kSelected.begin(), kSelected.end(), std::string_view(weakness)) != kSelected.end();
}

void declassify(const void *bytes, std::size_t count)
{
    static_cast<void>(VALGRIND_MAKE_MEM_DEFINED(bytes, count));
}

} // namespace skyseal
