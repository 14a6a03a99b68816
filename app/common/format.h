// Short formatted texts.
#pragma once

#include <cstdio>
#include <string>
#include <type_traits>

namespace skyseal::app {

/// printf into a string; truncated to 511 characters. Not for floating-point numbers, which would follow the locale: see
/// core/base/number_text.h.
template<typename... Args> std::string format(const char *pattern, Args... args)
{
    static_assert((!std::is_floating_point_v<Args> && ...));
    char out[512];
    std::snprintf(out, sizeof out, pattern, args...);
    return out;
}

/// "1 frame", "2 frames": `noun` in the singular, of a regular plural.
inline std::string counted(unsigned long long number, const std::string &noun)
{
    return std::to_string(number) + ' ' + noun + (number == 1 ? "" : "s");
}

} // namespace skyseal::app
