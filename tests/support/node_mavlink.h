// The npm package node-mavlink, an implementation of MAVLink that we did not write. SKYSEAL_NODE_MODULES names the folder that
// holds it (./test puts it into build/node).
#pragma once

#include <QtCore/QDir>
#include <QtCore/QStandardPaths>
#include <QtCore/QString>

namespace skyseal::test {

struct NodeMavlink
{
    QString node;                  ///< the program that runs scripts
    const char *missing = nullptr; ///< why nothing can be run
};

/// Finds node, and lets the scripts that it runs find the package.
inline NodeMavlink findNodeMavlink()
{
    NodeMavlink found{QStandardPaths::findExecutable(QStringLiteral("node"))};
    QString modules = qEnvironmentVariable("SKYSEAL_NODE_MODULES");
    if (modules.isEmpty())
        modules = QStringLiteral(SKYSEAL_SOURCE_DIR "/build/node/node_modules");
    if (found.node.isEmpty())
        found.missing = "node is not installed: the check against node-mavlink is skipped";
    else if (!QDir(modules).exists(QStringLiteral("node-mavlink")))
        found.missing = "SKYSEAL_NODE_MODULES names no folder with node-mavlink: the check against it is skipped";
    else
        qputenv("NODE_PATH", modules.toUtf8());
    return found;
}

} // namespace skyseal::test
