// Runs a program of the build or another one until it ends.
#pragma once

#include "tests/support/eventually.h"

#include <QtCore/QProcess>
#include <QtCore/QStringList>

namespace skyseal::test {

/// The arguments of a command line that needs no quotes.
inline QStringList words(const char *line)
{
    return QString::fromUtf8(line).split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

struct RunResult
{
    int status = -1; ///< -1: did not start, crashed, or still ran at the deadline
    QByteArray out;
    QByteArray err;
};

/// `program` is a path, or a name to be found on the PATH.
inline RunResult runToItsEnd(const QString &program, const QStringList &arguments, const QByteArray &input = {},
                             int milliseconds = kDeadlineMs)
{
    QProcess process;
    process.start(program, arguments);
    if (!process.waitForStarted(kDeadlineMs))
        return {};
    process.write(input);
    process.closeWriteChannel();
    if (!process.waitForFinished(milliseconds)) {
        process.kill();
        process.waitForFinished(kDeadlineMs);
        return {};
    }
    const bool ended = process.exitStatus() == QProcess::NormalExit;
    return {ended ? process.exitCode() : -1, process.readAllStandardOutput(), process.readAllStandardError()};
}

/// Runs a program of the build, by its name.
inline RunResult runProgram(const char *name, const QStringList &arguments, const QByteArray &input = {},
                            int milliseconds = kDeadlineMs)
{
    return runToItsEnd(QStringLiteral(SKYSEAL_BIN_DIR "/") + QLatin1String(name), arguments, input, milliseconds);
}

/// Runs a program of the build by a line of the shell, in which "$@" is the command.
inline RunResult runInShell(const char *line, const char *name, const QStringList &arguments)
{
    return runToItsEnd(QStringLiteral("/bin/sh"),
                       QStringList{QStringLiteral("-c"), QLatin1String(line), QStringLiteral("sh"),
                                   QStringLiteral(SKYSEAL_BIN_DIR "/") + QLatin1String(name)}
                           + arguments);
}

/// On a full disk, as far as the program can tell: not a byte can be written to a file. Its output is read as usual.
inline RunResult runOnFullDisk(const char *name, const QStringList &arguments)
{
    return runInShell("trap '' XFSZ; ulimit -f 0; exec \"$@\"", name, arguments);
}

/// With standard output on a full disk.
inline RunResult runIntoFullDisk(const char *name, const QStringList &arguments)
{
    return runInShell("exec \"$@\" >/dev/full", name, arguments);
}

} // namespace skyseal::test
