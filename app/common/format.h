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

} // namespace skyseal::app
