// perf's samples of a station's I/O thread in another process, as stacks of function names.
#pragma once

#include "tests/support/run_program.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QRegularExpression>

#include <vector>

namespace skyseal::test {

/// The thread that receives, opens, parses and sends; 0 while there is none.
inline qint64 ioThreadOf(qint64 process)
{
    const QString tasks = QStringLiteral("/proc/%1/task").arg(process);
    for (const QString &task : QDir(tasks).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        QFile name(tasks + QLatin1Char('/') + task + QStringLiteral("/comm"));
        if (name.open(QIODevice::ReadOnly) && name.readAll().trimmed() == "skyseal-io")
            return task.toLongLong();
    }
    return 0;
}

/// One sample: its time in seconds, and the functions of its stack.
struct PerfStack
{
    double time = 0;
    QString functions;
};

/// Of what `perf script -F tid,time,ip,sym` writes: a line with thread and time, a line for each frame, an empty line.
inline std::vector<PerfStack> perfStacks(const QByteArray &script)
{
    static const QRegularExpression kTime(QStringLiteral("([0-9]+\\.[0-9]+):"));
    std::vector<PerfStack> out;
    for (const QString &stack : QString::fromUtf8(script).split(QStringLiteral("\n\n"), Qt::SkipEmptyParts)) {
        const QString head = stack.trimmed().section(QLatin1Char('\n'), 0, 0);
        out.push_back({kTime.match(head).captured(1).toDouble(), stack});
    }
    return out;
}

} // namespace skyseal::test
