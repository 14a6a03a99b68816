// What proc(5) says of the memory and descriptors of a process.
#pragma once

#include <QtCore/QDir>
#include <QtCore/QFile>

namespace skyseal::test {

/// A field of /proc/PID/status in kB, such as "VmRSS" or "VmHWM" (its peak); 0 if it is not known.
inline qint64 statusKilobytes(qint64 pid, const QByteArray &field)
{
    QFile status(QStringLiteral("/proc/%1/status").arg(pid));
    if (!status.open(QIODevice::ReadOnly))
        return 0;
    for (const QByteArray &line : status.readAll().split('\n')) {
        if (line.startsWith(field + ':'))
            return line.mid(field.size() + 1).trimmed().chopped(3).trimmed().toLongLong();
    }
    return 0;
}

/// Open descriptors; 0 where this user may not see them.
inline qsizetype descriptors(qint64 pid)
{
    const QDir folder(QStringLiteral("/proc/%1/fd").arg(pid));
    return folder.entryList(QDir::NoDotAndDotDot | QDir::AllEntries | QDir::System).size();
}

} // namespace skyseal::test
