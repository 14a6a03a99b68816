// A file of the tree as a text.
#pragma once

#include <QtCore/QFile>
#include <QtCore/QString>

/// Empty if the file cannot be read.
inline QString contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}
