// The output of the programs: results on stdout, remarks on stderr.
#pragma once

#include "core/base/printable.h"

#include <QtCore/QString>

#include <cstdio>
#include <string>

#include <poll.h>

namespace skyseal::app {

/// Prints a text of this program, of one line or more, on stdout.
inline void printOwnText(const std::string &text)
{
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fputc('\n', stdout);
}

/// Prints one line on stdout and flushes it, for readers behind a pipe. Text of others in it cannot control the terminal or
/// forge further lines; JSON stays as it is. Returns false if the reader has closed the pipe.
inline bool printLine(const std::string &line)
{
    printOwnText(printable(line));
    return std::fflush(stdout) == 0;
}

/// True if a line of up to 4096 bytes (POSIX's PIPE_BUF) can be written without blocking. Programs that serve a link check it
/// first: the link must not stall because a pipe is full or a terminal is stopped.
inline bool hasRoom(std::FILE *stream, int patienceMilliseconds = 0)
{
    pollfd out{::fileno(stream), POLLOUT, 0};
    return ::poll(&out, 1, patienceMilliseconds) != 0;
}

/// The same on stderr.
inline void remark(const std::string &line)
{
    std::fprintf(stderr, "%s\n", printable(line).c_str());
}

} // namespace skyseal::app
