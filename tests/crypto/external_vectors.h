// Reads published vector files, which are not in the repository: the requirement published_vectors.
#pragma once

#include <QtCore/QFile>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>

#include "core/base/hex.h"
#include "tests/support/requirements.h"

namespace skyseal::test {

/// One of those files. A missing or unreadable file gives an empty object.
inline QJsonObject externalVectors(const char *file)
{
    QFile in(publishedVectorsFolder() + QLatin1Char('/') + QLatin1String(file));
    if (!in.open(QIODevice::ReadOnly))
        return QJsonObject();
    return QJsonDocument::fromJson(in.readAll()).object();
}

/// The bytes of a field in hex; empty when it is missing.
inline Bytes hexField(const QJsonObject &object, const char *name)
{
    return fromHex(object.value(QLatin1String(name)).toString().toStdString()).value_or(Bytes());
}

} // namespace skyseal::test
