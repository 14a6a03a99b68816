// The npm package node-mavlink, an implementation of MAVLink that we did not write. SKYSEAL_NODE_MODULES names the folder that
// holds it (./test puts it into build/node).
#pragma once

#include <QtCore/QDir>
#include <QtCore/QStandardPaths>
#include <QtCore/QString>

namespace skyseal::test {

/// The program node, whose scripts find the package from now on; empty if node or the package is missing.
inline QString findNodeMavlink()
{
    QString modules = qEnvironmentVariable("SKYSEAL_NODE_MODULES");
    if (modules.isEmpty())
        modules = QStringLiteral(SKYSEAL_SOURCE_DIR "/build/node/node_modules");
    if (!QDir(modules).exists(QStringLiteral("node-mavlink")))
        return {};
    qputenv("NODE_PATH", modules.toUtf8());
    return QStandardPaths::findExecutable(QStringLiteral("node"));
}

} // namespace skyseal::test
