// Tools of others that our own figures are held against: perf, heaptrack. A test that needs one says so and is skipped where
// it is not there.
#pragma once

#include <QtCore/QProcess>
#include <QtCore/QStandardPaths>

namespace skyseal::test {

struct ToolRun
{
    int status = -1; ///< -1: it did not end in time, or crashed
    QByteArray out, err;
};

inline ToolRun runTool(const QString &program, const QStringList &arguments, int milliseconds)
{
    QProcess process;
    process.start(program, arguments);
    if (!process.waitForFinished(milliseconds)) {
        process.kill();
        process.waitForFinished(5000);
        return {};
    }
    const bool ended = process.exitStatus() == QProcess::NormalExit;
    return {ended ? process.exitCode() : -1, process.readAllStandardOutput(), process.readAllStandardError()};
}

inline bool hasTool(const char *name)
{
    return !QStandardPaths::findExecutable(QString::fromLatin1(name)).isEmpty();
}

} // namespace skyseal::test
