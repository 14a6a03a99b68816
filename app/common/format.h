// Short formatted texts.
#pragma once

#include <cstdio>
#include <string>

namespace skyseal::app {

/// printf into a string; truncated to 511 characters.
template<typename... Args> std::string format(const char *pattern, Args... args)
{
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
