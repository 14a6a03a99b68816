// What a program says: lines for programs or people on stdout, remarks for people on stderr.
#pragma once

#include <QtCore/QString>

#include <cstdio>
#include <string>

namespace skyseal::app {

/// One line on stdout, at once: a reader behind a pipe must not wait for a full buffer. False when nobody reads any more.
inline bool printLine(const std::string &line)
{
    std::fwrite(line.data(), 1, line.size(), stdout);
    std::fputc('\n', stdout);
    return std::fflush(stdout) == 0;
}

/// One line on stderr.
inline void remark(const std::string &line)
{
    std::fprintf(stderr, "%s\n", line.c_str());
}

} // namespace skyseal::app
