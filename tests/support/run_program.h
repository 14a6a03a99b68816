// A program run to its end: one of ours, or another one.
#pragma once

#include <QtCore/QProcess>
#include <QtCore/QStringList>

namespace skyseal::test {

struct RunResult
{
    int status = -1; ///< -1: did not start, crashed or did not end
    QByteArray out;
    QByteArray err;
};

/// `program` is a path, or a name to be found on the PATH.
inline RunResult runToItsEnd(const QString &program, const QStringList &arguments, const QByteArray &input = {},
                             int milliseconds = 60000)
{
    QProcess process;
    process.start(program, arguments);
    if (!process.waitForStarted(10000))
        return {};
    process.write(input);
    process.closeWriteChannel();
    if (!process.waitForFinished(milliseconds)) {
        process.kill();
        process.waitForFinished(5000);
        return {};
    }
    const bool ended = process.exitStatus() == QProcess::NormalExit;
    return {ended ? process.exitCode() : -1, process.readAllStandardOutput(), process.readAllStandardError()};
}

/// One of ours, by its name.
inline RunResult runProgram(const char *name, const QStringList &arguments, const QByteArray &input = {},
                            int milliseconds = 60000)
{
    return runToItsEnd(QStringLiteral(SKYSEAL_BIN_DIR "/") + QLatin1String(name), arguments, input, milliseconds);
}

} // namespace skyseal::test
