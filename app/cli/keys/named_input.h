// Reads a small input given on the command line: a file, or - for standard input.
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/keys/file_io.h"

#include <QtCore/QFile>

#include <cstdio>

namespace skyseal::app {

/// Reads at most the maximum size of a key file. The caller wipes secret content.
inline Result<Bytes, InputError> readNamed(const std::string &name)
{
    QFile file(QString::fromStdString(name));
    const bool opened = name == "-" ? file.open(stdin, QIODevice::ReadOnly | QIODevice::Unbuffered)
                                    : file.open(QIODevice::ReadOnly | QIODevice::Unbuffered);
    if (!opened)
        return tl::unexpected(InputError{"cannot be read: " + file.errorString().toStdString(), name});
    Bytes content(keys::kMaxFileSize);
    std::size_t size = 0;
    while (size < content.size()) {
        const qint64 count = file.read(reinterpret_cast<char *>(content.data() + size),
                                       static_cast<qint64>(content.size() - size));
        if (count <= 0)
            break;
        size += static_cast<std::size_t>(count);
    }
    content.resize(size);
    return content;
}

} // namespace skyseal::app
