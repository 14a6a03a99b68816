#include "core/experiment/append_format.h"

#include <cstdarg>
#include <cstdio>

namespace skyseal::experiment {

void put(std::string &out, const char *pattern, ...)
{
    char line[512];
    va_list arguments;
    va_start(arguments, pattern);
    std::vsnprintf(line, sizeof line, pattern, arguments);
    va_end(arguments);
    out += line;
}

} // namespace skyseal::experiment
