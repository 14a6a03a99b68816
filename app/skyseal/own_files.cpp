#include "app/skyseal/own_files.h"

#include "core/keys/peers_file.h"
#include "core/keys/secret_file.h"

#include <QtCore/QDir>
#include <QtCore/QFileInfo>
#include <QtCore/QStandardPaths>

namespace skyseal::app {

QString dataFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
}

QString defaultRecordFolder()
{
    return dataFolder() + QStringLiteral("/logs");
}

QString indexCacheFile()
{
    return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/recordings.index");
}

Result<engine::KeyPaths, InputError> ownKeys(RandomSource &random)
{
    const QDir folder(dataFolder());
    if (!folder.mkpath(QStringLiteral(".")))
        return tl::unexpected(InputError{sentence("Reason", "the folder cannot be made"), folder.path().toStdString()});
    const engine::KeyPaths paths{folder.filePath(QStringLiteral("identity.key")).toStdString(),
                                 folder.filePath(QStringLiteral("peers")).toStdString()};
    if (!QFileInfo::exists(QString::fromStdString(paths.identity))) {
        const auto made = keys::writeNewIdentity(paths.identity, random);
        if (!made)
            return tl::unexpected(made.error());
    }
    if (const auto created = keys::createMissingPeers(paths.peers); !created)
        return tl::unexpected(created.error());
    return paths;
}

} // namespace skyseal::app
