// The output of the programs: results on stdout, remarks on stderr.
#pragma once

#include <QtCore/QString>

#include <cstdio>
#include <string>

#include <poll.h>

namespace skyseal::app {

/// Prints one line on stdout and flushes it, for readers behind a pipe. Returns false if the reader has closed the pipe.
inline bool printLine(const std::string &line)
{
    std::fwrite(line.data(), 1, line.size(), stdout);
    std::fputc('\n', stdout);
    return std::fflush(stdout) == 0;
}

/// True if a line of up to 4096 bytes (POSIX's PIPE_BUF) can be written without blocking. Programs that serve a link check it
/// first: the link must not stall because a pipe is full or a terminal is stopped.
inline bool hasRoom(std::FILE *stream, int patienceMilliseconds = 0)
{
    pollfd out{::fileno(stream), POLLOUT, 0};
    return ::poll(&out, 1, patienceMilliseconds) != 0;
}

/// The line with every control character replaced by '?'. It may contain text from unauthenticated vehicles, which must not
/// control the terminal or forge further lines.
inline std::string printable(std::string line)
{
    for (std::size_t i = 0; i < line.size(); ++i) {
        const auto byte = static_cast<unsigned char>(line[i]);
        // U+0080 to U+009F are control characters as well: C2 80 to C2 9F in UTF-8.
        const bool second = i > 0 && static_cast<unsigned char>(line[i - 1]) == 0xC2 && byte >= 0x80 && byte < 0xA0;
        if (byte < 0x20 || byte == 0x7F || second)
            line[i] = '?';
        if (second)
            line[i - 1] = '?';
    }
    return line;
}

/// One line on stderr.
inline void remark(const std::string &line)
{
    std::fprintf(stderr, "%s\n", printable(line).c_str());
}

} // namespace skyseal::app
