// One of our programs run to its end.
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

inline RunResult runProgram(const char *name, const QStringList &arguments, const QByteArray &input = {},
                            int milliseconds = 60000)
{
    QProcess process;
    process.start(QStringLiteral(SKYSEAL_BIN_DIR "/") + QLatin1String(name), arguments);
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

} // namespace skyseal::test
