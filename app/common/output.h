// The output of the programs: results on stdout, remarks on stderr.
#pragma once

#include "app/common/exit_status.h"
#include "core/base/printable.h"

#include <QtCore/QString>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <utility>

#include <poll.h>

namespace skyseal::app {

/// Number of the first error of stdout, 0 before: the C library forgets both the error and the bytes. Main thread.
inline int &outputError()
{
    static int first = 0;
    return first;
}

/// `done`: the success of a call that writes to stdout, which is returned.
inline bool noteOutput(bool done)
{
    if (!done && outputError() == 0)
        outputError() = errno;
    return done;
}

/// Prints a text of this program, of one line or more, on stdout. Returns false if a full buffer could not be written.
inline bool printOwnText(const std::string &text)
{
    return noteOutput(std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fputc('\n', stdout) != EOF);
}

inline bool flushOutput()
{
    return noteOutput(std::fflush(stdout) == 0);
}

/// Prints one line on stdout and flushes it, for readers behind a pipe. Text of others in it cannot control the terminal or
/// forge further lines; JSON stays as it is. Returns false if the reader has closed the pipe, or the disk is full.
inline bool printLine(const std::string &line)
{
    const bool printed = printOwnText(printable(line));
    return flushOutput() && printed;
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

/// Lines on stdout for a reader that may be slower than they come, or may not read at all: those for which there is no room are
/// dropped, and their number is said on stderr. Main thread.
class UnblockedOutput
{
public:
    void print(const std::string &line)
    {
        if (!hasRoom(stdout)) {
            ++m_dropped;
            return;
        }
        if (m_dropped > 0 && hasRoom(stderr))
            std::fprintf(stderr, "%u lines of JSON were dropped because the reader did not keep up\n",
                         std::exchange(m_dropped, 0U));
        printLine(line);
    }

    /// Waits a moment for a reader that is slow.
    void printLast(const std::string &line)
    {
        constexpr int kWaitMs = 1000;
        if (hasRoom(stdout, kWaitMs))
            printLine(line);
    }

private:
    unsigned m_dropped = 0; ///< since the last line that was printed
};

/// At the end of a command that prints its result: its exit status, or kCannotOpen and a remark if stdout did not take all, as
/// on a full disk. Not if the reader has closed the pipe, as `head` does.
inline int finishOutput(const QString &program, int status)
{
    flushOutput();
    if (outputError() == 0 || outputError() == EPIPE)
        return status;
    remark(program.toStdString() + ": standard output: " + std::strerror(outputError()));
    return status == kDone ? int(kCannotOpen) : status;
}

} // namespace skyseal::app
