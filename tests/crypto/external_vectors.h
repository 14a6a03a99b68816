// Finds published vector files that are too large for the repository.
#pragma once

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>

#include "core/base/hex.h"

#include <optional>

namespace skyseal::test {

/// The folder named by SKYSEAL_VECTORS, or else shared/vectors beside the source tree; empty if neither exists.
inline QString externalVectorsFolder()
{
    const QString named = qEnvironmentVariable("SKYSEAL_VECTORS");
    if (!named.isEmpty())
        return named;
    const QString beside = QStringLiteral(SKYSEAL_SOURCE_DIR "/../shared/vectors");
    return QDir(beside).exists() ? beside : QString();
}

inline const char *externalVectorsMissing()
{
    return "the published vector files are not here; name their folder in SKYSEAL_VECTORS";
}

/// One of those files; nullopt if the folder does not exist. A missing or unreadable file gives an empty object.
inline std::optional<QJsonObject> externalVectors(const char *file)
{
    const QString folder = externalVectorsFolder();
    if (folder.isEmpty())
        return std::nullopt;
    QFile in(folder + QLatin1Char('/') + QLatin1String(file));
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
